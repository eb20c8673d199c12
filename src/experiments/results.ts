import type { Row } from './row'
import type { ExperimentSettings } from './settings'
import type { Shard } from './shards'

/** The name and the version that results files carry. */
export const RESULTS_FORMAT = 'path-planner-results'
export const RESULTS_VERSION = 1

/** What a results file holds: the settings, with the seed inside, and the rows that came of them. */
export interface Results {
  readonly settings: ExperimentSettings
  /** Which part of the maps the rows are about; the whole experiment is 1 of 1. */
  readonly shard: Shard
  /** By map, and for each map by setting. Fewer than the settings ask for if it was broken off. */
  readonly rows: readonly Row[]
}
