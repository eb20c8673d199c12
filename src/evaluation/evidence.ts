import type { ParamValue } from '../algorithms/params'
import type { Results } from '../experiments/results'
import type { Row } from '../experiments/row'
import { isSuccess } from '../experiments/row'
import type { Figure } from './svg'

export type Evidence = Pick<Results, 'settings' | 'rows'>

/** A part of the document: what the report claims, and what was measured. */
export interface Section {
  readonly title: string
  /** The report's words; empty if it has none. */
  readonly claim: string
  /** Markdown. */
  readonly body: string
  readonly figures: readonly Figure[]
}

/** The rows of a planner that have these parameters. */
export function select(
  { rows }: Evidence,
  planner: string,
  params: Readonly<Record<string, ParamValue>> = {},
): Row[] {
  const wanted = Object.entries(params)
  return rows.filter(
    (row) => row.planner === planner && wanted.every(([name, value]) => row.params[name] === value),
  )
}

/** The rows of two settings on the same map, where its goal can be reached. */
export function pairs(first: readonly Row[], second: readonly Row[]): (readonly [Row, Row])[] {
  const byMap = new Map(second.map((row) => [row.map, row]))
  return first.flatMap((row) => {
    const other = byMap.get(row.map)
    return row.reachable && other ? [[row, other] as const] : []
  })
}

/** How the lengths compare on maps where both arrive. */
export function compareSteps(first: readonly Row[], second: readonly Row[]) {
  const both = pairs(first, second).filter(([a, b]) => isSuccess(a) && isSuccess(b))
  const share = (test: (a: number, b: number) => boolean) =>
    both.filter(([a, b]) => test(a.steps, b.steps)).length / both.length
  return {
    maps: both.length,
    shorter: share((a, b) => a < b),
    equal: share((a, b) => a === b),
    longer: share((a, b) => a > b),
  }
}

/** The settings of the report, as the planners have them by default. */
export const REPORT = {
  field: { influence: 1, repulsiveValue: 30 },
  bug2: { leave: 'report' },
  tangentBug: { variant: 'report', range: 2 },
} as const
