export interface Message {
  readonly id: number
  /** Work is cancelled by closing its message. */
  readonly kind: 'error' | 'note' | 'work'
  readonly text: string
  /** How much of work is done, from 0 to 1, in steps of a hundredth. */
  readonly done?: number
  /** Whether it speaks of the map as it is: the next change of that takes it away. */
  readonly isOfMap?: boolean
}

/** The part of a page's state that its messages are in. */
export interface WithMessages {
  readonly messages: readonly Message[]
  /** How many there have been; the next one's id is not that of any before. */
  readonly messagesTold: number
}

const MOST_MESSAGES = 3

/** Shows a message; one with the same text gives way to it, or else the oldest if they are too many. */
export function tell<State extends WithMessages>(
  state: State,
  kind: Message['kind'],
  text: string,
): State {
  const id = state.messagesTold + 1
  const others = state.messages.filter((message) => message.text !== text)
  // Work would be cancelled with its message.
  const oldest = others.findIndex((message) => message.kind !== 'work')
  if (others.length >= MOST_MESSAGES && oldest >= 0) others.splice(oldest, 1)
  return { ...state, messages: [...others, { id, kind, text }], messagesTold: id }
}

/** Shows a message that may be wrong once the map, or how it is planned, is changed. */
export function tellOfMap<State extends WithMessages>(
  state: State,
  kind: 'error' | 'note',
  text: string,
): State {
  const told = tell(state, kind, text)
  const messages = told.messages.map((message) =>
    message.id === told.messagesTold ? { ...message, isOfMap: true } : message,
  )
  return { ...told, messages }
}

export const withoutThoseOfMap = (messages: readonly Message[]): readonly Message[] =>
  messages.filter(({ isOfMap }) => !isOfMap)

/** What was tried in vain before is of no interest once it, or something else, was done. */
export const withoutErrors = (messages: readonly Message[]): readonly Message[] =>
  messages.filter(({ kind }) => kind !== 'error')

export function workProgressed<State extends WithMessages>(
  state: State,
  id: number,
  done: number,
): State {
  const rounded = Math.round(100 * done) / 100
  const message = state.messages.find((other) => other.id === id)
  if (!message || message.done === rounded) return state
  const messages = state.messages.map((other) =>
    other === message ? { ...message, done: rounded } : other,
  )
  return { ...state, messages }
}

export const dismiss = <State extends WithMessages>(state: State, id: number): State => ({
  ...state,
  messages: state.messages.filter((message) => message.id !== id),
})
