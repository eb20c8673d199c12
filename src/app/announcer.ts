import { isSettled, type Said, type State } from './state'
import { outcomeInWords } from './words'

/**
 * What is to be said now, after `said` has been said: `null` if nothing new, or if it waits for the
 * plan that belongs to it.
 */
export function announcement(state: State, said: Said | null): string | null {
  if (state.said === said || state.said.text === '') return null
  if (!state.said.withOutcome) return state.said.text
  if (state.run.kind === 'failed') return `${state.said.text} No plan: ${state.run.message}`
  if (state.run.kind === 'cancelled') return `${state.said.text} Planning was cancelled.`
  if (!isSettled(state) || !state.shown) return null
  const { outcome, tape } = state.shown
  return `${state.said.text} ${outcomeInWords(outcome, tape.width)}.`
}

/** Speaks through a live region; the same words twice are said twice. */
export function announcer(region: HTMLElement): (state: State) => void {
  let said: Said | null = null
  return (state) => {
    const text = announcement(state, said)
    if (text === null) return
    said = state.said
    region.textContent = region.textContent === text ? `${text}\u00a0` : text
  }
}
