/** One state, changed only by transitions: functions from a state to the next one. */
export interface Store<State> {
  readonly state: State
  update(transition: (state: State) => State): void
  /** Calls the listener after every change; returns how to stop that. */
  subscribe(listener: (now: State, before: State) => void): () => void
}

export function createStore<State>(initial: State): Store<State> {
  let state = initial
  const listeners = new Set<(now: State, before: State) => void>()
  return {
    get state() {
      return state
    },
    update(transition) {
      const before = state
      state = transition(before)
      if (state === before) return
      for (const listener of listeners) listener(state, before)
    },
    subscribe(listener) {
      listeners.add(listener)
      return () => listeners.delete(listener)
    },
  }
}
