import { mapsOf, type Origin } from '../experiments/results'
import { parseLine } from '../experiments/results-json'
import { countWork } from '../experiments/settings'
import { InputError } from '../grid/errors'
import type { Line } from './lines'

/** What of an experiment is in a rows file: all maps before `next`, up to its byte `end`. */
export interface MapsThere {
  readonly next: number
  readonly end: number
}

/** What is wrong with a file is told with its name. */
export function inFile<T>(path: string, read: () => T): T {
  try {
    return read()
  } catch (error) {
    throw error instanceof InputError ? new InputError(`${path}: ${error.message}`) : error
  }
}

/**
 * Reads all rows of a file, to see that each is there and in its place. What a run that was broken
 * off left half written, a line or the rows of a map, is not counted.
 * @param lines those after the first one, which is `header`
 * @throws InputError that names the line that is wrong
 */
export function mapsThere(
  path: string,
  origin: Origin,
  header: Line,
  lines: Iterable<Line>,
): MapsThere {
  const maps = mapsOf(origin)
  const { settings } = countWork(origin.settings)
  let { end } = header
  let next = maps.first
  let setting = 0
  let number = 1
  for (const line of lines) {
    if (!line.isWhole) break
    number++
    const row = Object(inFile(path, () => parseLine(line.text, number)))
    if (next >= maps.end || row.map !== next || row.setting !== setting) {
      throw new InputError(
        `${path} is damaged: line ${number} is not the row that should stand there.`,
      )
    }
    if (++setting < settings) continue
    setting = 0
    next++
    end = line.end
  }
  return { next, end }
}
