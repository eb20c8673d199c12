import type { Message } from './state'

/** The part of a page's state that its messages are in. */
export interface Telling {
  readonly messages: readonly Message[]
  /** How many there have been; the next one's id is not that of any before. */
  readonly messagesTold: number
}

const MOST_MESSAGES = 3

/** A message on screen; the same one again takes the place of the first. */
export function tell<State extends Telling>(
  state: State,
  kind: Message['kind'],
  text: string,
): State {
  const id = state.messagesTold + 1
  const others = state.messages.filter((message) => message.text !== text)
  const messages = [...others, { id, kind, text }].slice(-MOST_MESSAGES)
  return { ...state, messages, messagesTold: id }
}

export const dismiss = <State extends Telling>(state: State, id: number): State => ({
  ...state,
  messages: state.messages.filter((message) => message.id !== id),
})
