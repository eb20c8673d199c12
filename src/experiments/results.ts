import * as v from 'valibot'
import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import type { Row } from './row'
import { countWork, type ExperimentSettings } from './settings'
import { checkSettings } from './settings-check'
import { type MapRange, rangeOfShard, type Shard, WHOLE } from './shards'

/** The name and the version that results files carry. */
export const RESULTS_FORMAT = 'path-planner-results'
const RESULTS_VERSION = 1

/** What rows come from: enough to make them again. */
export interface Origin {
  readonly settings: ExperimentSettings
  /** Which part of the maps the rows are about; the whole experiment is 1 of 1. */
  readonly shard: Shard
}

/** The maps that the rows are about. */
export const mapsOf = ({ settings, shard }: Origin): MapRange =>
  rangeOfShard(shard, countWork(settings).maps)

/** What a results file holds. */
export interface Results extends Origin {
  /** By map, and for each map by setting. Fewer than the settings ask for if it was broken off. */
  readonly rows: readonly Row[]
}

/** What every results file begins with or contains, as a JSON value. */
export function originToJson({ settings, shard }: Origin) {
  const part = shard.of === 1 ? {} : { shard }
  return { format: RESULTS_FORMAT, version: RESULTS_VERSION, settings, ...part }
}

const count = v.pipe(v.number(), v.integer(), v.minValue(1))
const shardShape = v.strictObject({ index: count, of: count })

/**
 * The origin in a JSON value that `originToJson` made; other keys of it are not looked at.
 * @throws InputError that says what is wrong, also in the settings.
 */
export function readOrigin(value: unknown): Origin {
  const { format, version, settings, shard } = Object(value)
  if (format !== RESULTS_FORMAT) {
    throw new InputError(
      `This file has no results of experiments: its "format" is ${describe(format)}, not "${RESULTS_FORMAT}".`,
    )
  }
  if (version !== RESULTS_VERSION) {
    throw new InputError(
      `These results are of version ${describe(version)}; this program reads version ${RESULTS_VERSION}.`,
    )
  }
  return { settings: checkSettings(settings), shard: readShardValue(shard) }
}

function readShardValue(value: unknown): Shard {
  if (value === undefined) return WHOLE
  const result = v.safeParse(shardShape, value)
  if (result.success && result.output.index <= result.output.of) return result.output
  throw new InputError('The "shard" must have an "index" from 1 to "of".')
}
