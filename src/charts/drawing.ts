import type { ChartTheme } from './style'

/** How a chart is to be drawn. */
export interface Drawing {
  /** In pixels. */
  readonly width: number
  readonly theme: ChartTheme
  /** Whether a series is drawn. */
  isShown(name: string): boolean
  /** Makes the elements; that of the page if it is not given. */
  readonly document?: Document
}
