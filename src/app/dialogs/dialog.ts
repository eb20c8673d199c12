import { byId } from '../element'
import { drawIcons } from '../icons'

/** A modal dialog of the page: the browser keeps the focus inside and gives it back afterwards. */
export function dialog(id: string): HTMLDialogElement {
  const element = byId(id, HTMLDialogElement)
  for (const button of element.querySelectorAll('[data-close]')) {
    button.addEventListener('click', () => element.close())
  }
  // A press on what is behind the dialog reaches the dialog itself, outside its box.
  element.addEventListener('pointerdown', (event) => {
    if (event.target !== element) return
    const { left, right, top, bottom } = element.getBoundingClientRect()
    const isInside =
      event.clientX >= left &&
      event.clientX <= right &&
      event.clientY >= top &&
      event.clientY <= bottom
    if (!isInside) element.close()
  })
  return element
}

/** A modal dialog that is put into the page from its markup. */
export function newDialog(id: string, markup: string): HTMLDialogElement {
  document.querySelector('main')?.insertAdjacentHTML('beforeend', markup)
  const element = dialog(id)
  drawIcons(element)
  return element
}

export function formOf(element: HTMLDialogElement): HTMLFormElement {
  const form = element.querySelector('form')
  if (form) return form
  throw new Error(`The dialog "${element.id}" has no form.`)
}
