/** Shows the zone while a file is dragged over the page, and takes the file that is dropped anywhere. */
export function onFileDropped(zone: HTMLElement, take: (file: File) => void): void {
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
    const file = event.dataTransfer?.files[0]
    if (file) take(file)
  })
}
