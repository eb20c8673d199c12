import { openingResults } from '../../experiments/open-results'
import { RESULTS_FORMAT } from '../../experiments/results'
import type { GivenMap } from '../../experiments/settings'
import { checkSettings } from '../../experiments/settings-check'
import { InputError, messageOf } from '../../grid/errors'
import { fileText } from '../../grid/file-text'
import { parseJson } from '../../grid/formats/json'
import { rowByRow } from '../../grid/text-map'
import { byId } from '../element'
import { onFileChosen } from '../files/chosen-file'
import { inSlices } from '../files/in-slices'
import { readMap } from '../files/opening-worker'
import { showWork } from '../files/shown-work'
import { tell } from '../state/messages'
import type { Store } from '../state/store'
import type { PageState } from './state'
import { addMaps, openSettings, showResults } from './transitions'

/** No more than a text of a browser can hold. */
const MOST_BYTES = 400 * 2 ** 20

/** What a file of settings or of results changes. It yields what share of it is read. */
export function* openingText(
  text: string,
): Generator<number, (state: PageState) => PageState, void> {
  const isResults = text.startsWith('#') || text.slice(0, 200).includes(RESULTS_FORMAT)
  if (!isResults) {
    const value = parseJson(fileText(text))
    yield 0.5
    const settings = checkSettings(value)
    return (state) => openSettings(state, settings)
  }
  const results = yield* openingResults(text)
  return (state) => showResults(openSettings(state, results.settings), results)
}

/**
 * Opens settings or results. If that fails, a message says why, and all stays as it was.
 * @param isWanted whether no other file was asked for while this one was read
 */
async function openFile(
  store: Store<PageState>,
  file: File,
  isWanted: () => boolean,
): Promise<void> {
  try {
    const open = await showWork(store, `Opening ${file.name}…`, async ({ progress, signal }) => {
      const opening = openingText(await textOf(file))
      return inSlices(opening, (shares) => progress(shares.at(-1) ?? 1), signal)
    })
    if (!open || !isWanted()) return
    store.update((state) => tell(open(state), 'note', `Opened ${file.name}.`))
  } catch (error) {
    if (isWanted()) refuse(store, file, error)
  }
}

/** Adds the maps in files to the family of opened maps. */
async function openMaps(store: Store<PageState>, files: readonly File[]): Promise<void> {
  const maps: GivenMap[] = []
  for (const file of files) {
    try {
      const rows = await showWork(store, `Opening ${file.name}…`, ({ signal }) =>
        readRows(file, signal),
      )
      if (rows) maps.push({ name: file.name, rows })
    } catch (error) {
      refuse(store, file, error)
    }
  }
  if (maps.length > 0) store.update((state) => addMaps(state, maps))
}

async function readRows(file: File, signal: AbortSignal): Promise<readonly string[]> {
  const { problem } = await readMap(file, signal)
  const rows: string[] = []
  await inSlices(rowByRow(problem.grid), (some) => rows.push(...some), signal)
  return rows
}

async function textOf(file: File): Promise<string> {
  if (file.size > MOST_BYTES) {
    throw new InputError(`It has more than ${MOST_BYTES / 2 ** 20} MB.`)
  }
  return file.text()
}

function refuse(store: Store<PageState>, file: File, error: unknown): void {
  store.update((state) => tell(state, 'error', `${file.name} was not opened. ${messageOf(error)}`))
}

/** Binds the two file inputs, and dropping a file of settings or results anywhere. */
export function bindFiles(store: Store<PageState>): { open(): void; openMaps(): void } {
  const mapInput = byId('map-files', HTMLInputElement)
  mapInput.addEventListener('change', () => {
    void openMaps(store, [...(mapInput.files ?? [])])
    mapInput.value = ''
  })
  const open = onFileChosen(store, (file, isWanted) => void openFile(store, file, isWanted))
  return { open, openMaps: () => mapInput.click() }
}
