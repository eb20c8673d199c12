export interface Message {
  readonly id: number
  readonly kind: 'error' | 'note'
  readonly text: string
}

/** The part of a page's state that its messages are in. */
export interface WithMessages {
  readonly messages: readonly Message[]
  /** How many there have been; the next one's id is not that of any before. */
  readonly messagesTold: number
}

const MOST_MESSAGES = 3

/** Shows a message; one with the same text gives way to it. */
export function tell<State extends WithMessages>(
  state: State,
  kind: Message['kind'],
  text: string,
): State {
  const id = state.messagesTold + 1
  const others = state.messages.filter((message) => message.text !== text)
  const messages = [...others, { id, kind, text }].slice(-MOST_MESSAGES)
  return { ...state, messages, messagesTold: id }
}

export const dismiss = <State extends WithMessages>(state: State, id: number): State => ({
  ...state,
  messages: state.messages.filter((message) => message.id !== id),
})
