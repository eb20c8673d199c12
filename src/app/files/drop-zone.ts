import { tell, type WithMessages } from '../state/messages'
import type { Store } from '../state/store'

/**
 * Shows the zone while a file is dragged over the page, and takes the file that is dropped anywhere; of
 * several the first.
 */
export function onFileDropped<State extends WithMessages>(
  zone: HTMLElement,
  store: Store<State>,
  take: (file: File) => void,
): void {
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
    const [file, ...others] = event.dataTransfer?.files ?? []
    if (!file) return
    take(file)
    if (others.length === 0) return
    const words = `Of ${others.length + 1} files only the first, ${file.name}, was taken.`
    store.update((state) => tell(state, 'note', words))
  })
}
