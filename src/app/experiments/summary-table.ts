import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import { seriesOf } from '../../experiments/summary/groups'
import { distributionOf } from '../../experiments/summary/ratios'
import { quantilesOf } from '../../experiments/summary/statistics'
import { successOf } from '../../experiments/summary/success'
import { clockTick } from '../../experiments/summary/times'
import { compareValues } from '../sorting'

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
  /** A tick of the clock that all times were read off is at most so long. */
  readonly tick: number
  readonly failures: readonly Row[]
}

export function summarize(settings: ExperimentSettings, rows: readonly Row[]): SummaryRow[] {
  const tick = clockTick(rows)
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
      tick,
      failures: success.failures,
    }
  })
}

export type SummaryKey = keyof SummaryRow

/** Sorted by a column; rows without a number there come last in either direction. */
export function sortSummary(
  rows: readonly SummaryRow[],
  key: SummaryKey,
  descending: boolean,
): SummaryRow[] {
  const value = (row: SummaryRow) => (key === 'failures' ? row.failures.length : row[key])
  return rows.toSorted((a, b) => compareValues(value(a), value(b), descending))
}
