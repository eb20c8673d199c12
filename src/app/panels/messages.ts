import { byId, create } from '../element'
import { icon } from '../icons'
import { dismiss, type Message, type WithMessages } from '../state/messages'
import type { Store } from '../state/store'

/**
 * Binds the messages at the edge of the screen: errors stay until they are closed, notes until
 * their time, which is that of an animation, is over.
 */
export function messages<State extends WithMessages>(store: Store<State>): (state: State) => void {
  const list = byId('messages', HTMLDivElement)
  const boxes = new Map<number, HTMLElement>()
  /** Where the focus was before it came to the messages. */
  let cameFrom: EventTarget | null = null
  list.addEventListener('focusin', ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && list.contains(relatedTarget))) cameFrom = relatedTarget
  })

  const show = (message: Message): HTMLElement => {
    const { id, kind, text } = message
    const close = create('button', {
      type: 'button',
      class: 'icon-button',
      'aria-label': 'Close this message',
    })
    close.append(icon('close'))
    close.addEventListener('click', ({ detail }) => {
      const others = [...boxes].filter(([other]) => other !== id).map(([, box]) => box)
      const next = others.at(-1)?.querySelector('button') ?? cameFrom
      store.update((state) => dismiss(state, id))
      // The button goes. With a pointer the focus is not missed.
      if (detail === 0 && next instanceof HTMLElement) next.focus()
    })
    const box = create(
      'div',
      { class: `toast ${kind}`, ...(kind === 'error' ? { role: 'alert' } : {}) },
      create('span', {}, text),
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
      box.remove()
      boxes.delete(id)
    }
    for (const message of state.messages) {
      if (!boxes.has(message.id)) boxes.set(message.id, show(message))
    }
  }
}
