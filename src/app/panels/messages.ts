import { byId, create } from '../element'
import { icon } from '../icons'
import { dismiss, type Message, type WithMessages } from '../state/messages'
import type { Store } from '../state/store'
import { showProgress } from './progress'

/**
 * Binds the messages at the edge of the screen: errors stay until they are closed, notes until
 * their time, which is that of an animation, is over, work until it is done or cancelled.
 */
export function messages<State extends WithMessages>(store: Store<State>): (state: State) => void {
  const list = byId('messages', HTMLDivElement)
  const boxes = new Map<number, HTMLElement>()
  /** Where the focus was before it came to the messages. */
  let cameFrom: EventTarget | null = null
  list.addEventListener('focusin', ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && list.contains(relatedTarget))) cameFrom = relatedTarget
  })

  const giveFocusBack = () => {
    const next = [...boxes.values()].at(-1)?.querySelector('button') ?? cameFrom
    if (next instanceof HTMLElement) next.focus()
  }

  const show = (message: Message): HTMLElement => {
    const { id, kind, text } = message
    const close = kind === 'work' ? cancelButton() : closeButton()
    close.addEventListener('click', ({ detail }) => {
      // With a pointer the focus is not missed.
      if (detail > 0) close.blur()
      store.update((state) => dismiss(state, id))
    })
    const box = create(
      'div',
      { class: `toast ${kind}`, ...(kind === 'error' ? { role: 'alert' } : {}) },
      create('span', {}, text),
      ...(kind === 'work' ? [progressBar(text)] : []),
      close,
    )
    box.addEventListener('animationend', ({ animationName }) => {
      if (animationName === 'message-time') store.update((state) => dismiss(state, id))
    })
    list.append(box)
    return box
  }

  return (state) => {
    for (const [id, box] of boxes) {
      if (state.messages.some((message) => message.id === id)) continue
      boxes.delete(id)
      // Before it is lost: nothing could tell then where it had come from.
      if (box.contains(document.activeElement)) giveFocusBack()
      box.remove()
    }
    for (const message of state.messages) {
      const box = boxes.get(message.id) ?? show(message)
      boxes.set(message.id, box)
      showProgress(box.querySelector('[role=progressbar]'), message.done ?? 0)
    }
  }
}

function closeButton(): HTMLButtonElement {
  const label = 'Close this message'
  return create(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': label },
    icon('close'),
  )
}

const cancelButton = (): HTMLButtonElement =>
  create('button', { type: 'button', class: 'btn tonal' }, 'Cancel')

function progressBar(label: string): HTMLDivElement {
  const range = { 'aria-valuemin': 0, 'aria-valuemax': 100 }
  return create(
    'div',
    { class: 'progress', role: 'progressbar', 'aria-label': label, ...range },
    create('div'),
  )
}
