import type { Origin } from '../experiments/results'
import { parseLine } from '../experiments/results-json'
import { countWork } from '../experiments/settings'
import { type MapRange, rangeOfShard } from '../experiments/shards'
import { InputError } from '../grid/errors'
import { inFile } from './in-file'

/** Follows the rows of a file line by line: they stand by map and, for each map, by setting. */
export class RowOrder {
  /** The maps that the file has when it is complete. */
  readonly maps: MapRange
  readonly #path: string
  readonly #settings: number
  #map: number
  #setting = 0

  constructor(path: string, { settings, shard }: Origin) {
    const work = countWork(settings)
    this.maps = rangeOfShard(shard, work.maps)
    this.#path = path
    this.#settings = work.settings
    this.#map = this.maps.first
  }

  /** The first map of which not all rows were there so far. */
  get next(): number {
    return this.#map
  }

  /**
   * Takes the next row.
   * @param number of the line, from 1
   * @returns whether it is the last row of its map
   * @throws InputError if it is not the row that comes next
   */
  take(line: string, number: number): boolean {
    const row = Object(inFile(this.#path, () => parseLine(line, number)))
    const isNext = row.map === this.#map && row.setting === this.#setting
    if (this.#map >= this.maps.end || !isNext) {
      throw new InputError(
        `${this.#path} is damaged: line ${number} is not the row that should stand there.`,
      )
    }
    this.#setting = (this.#setting + 1) % this.#settings
    if (this.#setting > 0) return false
    this.#map++
    return true
  }
}
