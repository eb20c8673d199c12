import { InputError } from '../grid/errors'
import { openMap } from '../grid/formats/open-map'
import { saveProject } from '../grid/formats/project-file'
import { download } from './download'
import { byId } from './element'
import type { State } from './state'
import type { Store } from './store'
import { changeMap, say, tell } from './transitions'

/** More than any map needs; a larger file is not even read. */
const MOST_BYTES = 64 * 2 ** 20

/** Opens the map in a file. What is wrong with it is said; the map on screen stays. */
export async function openFile(store: Store<State>, file: File): Promise<void> {
  try {
    if (file.size > MOST_BYTES) {
      const size = Math.round(file.size / 2 ** 20)
      throw new InputError(
        `It has ${size} MB, more than the ${MOST_BYTES / 2 ** 20} MB of any map.`,
      )
    }
    const { problem, notes } = openMap(await file.text())
    const { width, height } = problem.grid
    const opened = `Opened ${file.name}: ${width} × ${height} cells.`
    store.update((state) => {
      const changed = changeMap(state, { ...state.setup, problem }, opened)
      return tell(changed, 'note', [opened, ...notes].join(' '))
    })
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error)
    store.update((state) => tell(state, 'error', `${file.name} was not opened. ${why}`))
  }
}

/** Hands the map to the browser as a file to download. */
export function saveFile(store: Store<State>): void {
  const { problem } = store.state.setup
  const { width, height } = problem.grid
  const name = `path-planner-${width}x${height}.json`
  download(saveProject(problem), 'application/json', name)
  store.update((state) => say(state, `Saved as ${name}.`))
}

/** Binds the file input and dropping a file anywhere on the page; returns what asks for a file. */
export function bindFiles(store: Store<State>): () => void {
  const input = byId('file', HTMLInputElement)
  const zone = byId('drop-zone', HTMLDivElement)
  const open = (file: File | undefined) => {
    if (file) void openFile(store, file)
  }
  input.addEventListener('change', () => {
    open(input.files?.[0])
    // The same file can be chosen again.
    input.value = ''
  })
  const hasFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
  window.addEventListener('dragover', (event) => {
    if (!hasFile(event)) return
    event.preventDefault()
    zone.hidden = false
  })
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) zone.hidden = true
  })
  window.addEventListener('drop', (event) => {
    if (!hasFile(event)) return
    event.preventDefault()
    zone.hidden = true
    open(event.dataTransfer?.files[0])
  })
  return () => input.click()
}
