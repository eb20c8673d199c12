import type { Row } from '../experiments/row'

/** Runs that stand behind a mark, in a list of their own. */
export interface RunList {
  readonly title: string
  readonly rows: readonly Row[]
}

/** A mark of a chart. */
export interface Mark {
  /** Number of its series. */
  readonly series: number
  readonly x: number
  readonly y: number
  /** Ends of the interval around y. */
  readonly low: number
  readonly high: number
  /** All that it says, in words. */
  readonly label: string
  /** The runs that it is made of, those of interest first. */
  readonly runs: readonly RunList[]
}

/** A mark for a whole distribution. */
export interface Box extends Mark {
  /** Half of the values lie between these. */
  readonly lower: number
  readonly upper: number
}

export interface Axis {
  readonly label: string
  readonly scale: 'linear' | 'log' | 'percent'
}

interface ChartTable {
  readonly columns: readonly string[]
  readonly rows: readonly (readonly string[])[]
}

interface Common {
  readonly id: string
  readonly title: string
  /** What can be read from it, in a few sentences: for those who do not see it. */
  readonly summary: string
  readonly x: Axis
  readonly y: Axis
  readonly series: readonly Series[]
  /** The same numbers, to be read one by one. */
  readonly table: ChartTable
  /** What the settings would need for this chart; empty if it has something to show. */
  readonly missing: string
}

export interface Series {
  readonly name: string
  /** Decides its colour, line and symbol, so that they are the same in all charts. */
  readonly style: number
}

/** What a chart shows. How it looks is decided where it is drawn. */
export type Chart = Common &
  (
    | { readonly kind: 'lines'; readonly marks: readonly Mark[] }
    /** A row for each series, with the distribution along x. */
    | { readonly kind: 'boxes'; readonly marks: readonly Box[] }
    /** A field of cells for each series; `y` of a mark is its row, `value` its colour from 0 to 1. */
    | { readonly kind: 'cells'; readonly marks: readonly (Mark & { readonly value: number })[] }
  )
