import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import { seriesOf } from '../../experiments/summary/groups'
import { distributionOf } from '../../experiments/summary/ratios'
import { quantilesOf } from '../../experiments/summary/statistics'
import { successOf } from '../../experiments/summary/success'

/** What came of one planner setting, over all maps. */
export interface SummaryRow {
  readonly name: string
  readonly runs: number
  /** Shares from 0 to 1: of all runs, and of those whose goal can be reached. */
  readonly reached: number
  readonly reachedOfReachable: number
  readonly medianRatio: number
  readonly medianLength: number
  readonly medianMilliseconds: number
  readonly meanMilliseconds: number
  readonly failures: readonly Row[]
}

export function summarize(settings: ExperimentSettings, rows: readonly Row[]): SummaryRow[] {
  return seriesOf(settings, rows, (own) => [own]).map(({ name, points: [own] }) => {
    const success = successOf(own)
    const ratio = distributionOf(own)
    const milliseconds = quantilesOf(own.map((row) => row.milliseconds))
    return {
      name,
      runs: own.length,
      reached: ratio.rows.length / own.length,
      reachedOfReachable: success.rate,
      medianRatio: ratio.quantiles.median,
      medianLength: quantilesOf(ratio.rows.map(({ length }) => length)).median,
      medianMilliseconds: milliseconds.median,
      meanMilliseconds: milliseconds.mean,
      failures: success.failures,
    }
  })
}

export type SummaryKey = Exclude<keyof SummaryRow, 'failures'> | 'failures'

/** Sorted by a column; what there is no number of comes last either way. */
export function sortSummary(
  rows: readonly SummaryRow[],
  key: SummaryKey,
  descending: boolean,
): SummaryRow[] {
  const value = (row: SummaryRow) => (key === 'failures' ? row.failures.length : row[key])
  const sign = descending ? -1 : 1
  return [...rows].sort((a, b) => {
    const [first, second] = [value(a), value(b)]
    if (typeof first === 'string' || typeof second === 'string') {
      return sign * String(first).localeCompare(String(second), 'en', { numeric: true })
    }
    const missing = Number(Number.isNaN(first)) - Number(Number.isNaN(second))
    return missing || sign * (first - second) || 0
  })
}
