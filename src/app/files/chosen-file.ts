import { byId } from '../element'
import { tell, type WithMessages } from '../state/messages'
import type { Store } from '../state/store'

/**
 * Binds the page's file input, and dropping a file anywhere on the page; of several the first is taken.
 * @param open is told by `isWanted` whether no other file was asked for since
 * @returns what asks for a file
 */
export function onFileChosen<State extends WithMessages>(
  store: Store<State>,
  open: (file: File, isWanted: () => boolean) => void,
): () => void {
  const input = byId('file', HTMLInputElement)
  let latest: File | null = null
  const take = (file: File) => {
    latest = file
    open(file, () => file === latest)
  }
  input.addEventListener('change', () => {
    const file = input.files?.[0]
    if (file) take(file)
    // The same file can be chosen again.
    input.value = ''
  })
  onFilesDropped(([file, ...others]) => {
    take(file)
    if (others.length === 0) return
    const words = `Of ${others.length + 1} files only the first, ${file.name}, was taken.`
    store.update((state) => tell(state, 'note', words))
  })
  return () => input.click()
}

/** Shows the drop zone while files are dragged over the page, and takes those that are dropped. */
function onFilesDropped(take: (files: readonly File[]) => void): void {
  const zone = byId('drop-zone', HTMLDivElement)
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
  window.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return
    event.preventDefault()
    zone.hidden = false
  })
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) zone.hidden = true
  })
  window.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return
    event.preventDefault()
    zone.hidden = true
    const files = [...(event.dataTransfer?.files ?? [])]
    if (files.length > 0) take(files)
  })
}
