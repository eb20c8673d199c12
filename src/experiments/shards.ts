import { InputError } from '../grid/errors'

/** One of several parts of an experiment, counted from 1. */
export interface Shard {
  readonly index: number
  readonly of: number
}

export const WHOLE: Shard = { index: 1, of: 1 }

/** The maps of a shard, from `first` up to `end`, without it. The shards follow one another. */
export interface MapRange {
  readonly first: number
  readonly end: number
}

export function rangeOfShard({ index, of }: Shard, maps: number): MapRange {
  const border = (i: number) => Math.floor((maps * i) / of)
  return { first: border(index - 1), end: border(index) }
}

/**
 * A shard written as "2/4".
 * @throws InputError if it is not.
 */
export function readShard(text: string): Shard {
  const [, index, of] = /^(\d{1,6})\/(\d{1,6})$/.exec(text)?.map(Number) ?? []
  if (index >= 1 && index <= of) return { index, of }
  throw new InputError(`A shard is written as 2/4, the second of four, but this is "${text}".`)
}
