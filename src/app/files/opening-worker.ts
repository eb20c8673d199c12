import { InputError } from '../../grid/errors'
import type { OpenedMap } from '../../grid/formats/opened-map'
import { askedWorker } from '../planning/asked-worker'
import { askForMap, type MapWorker } from './map-worker'

/** More than any map needs; a larger file is not even read. */
const MOST_BYTES = 64 * 2 ** 20

/** A new worker that reads one map from a file. */
const openingWorker = (): MapWorker<Blob> =>
  askedWorker(new Worker(new URL('./open-worker.ts', import.meta.url), { type: 'module' }))

/**
 * The map in a file, which a worker reads.
 * @throws what the signal was aborted with, or an Error that says why there is no map
 */
export async function readMap(
  file: Blob,
  signal: AbortSignal,
  makeWorker = openingWorker,
): Promise<OpenedMap> {
  if (file.size > MOST_BYTES) {
    const size = Math.round(file.size / 2 ** 20)
    throw new InputError(`It has ${size} MB, more than the ${MOST_BYTES / 2 ** 20} MB of any map.`)
  }
  return askForMap(makeWorker(), file, signal)
}
