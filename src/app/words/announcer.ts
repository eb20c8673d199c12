import type { Moment } from '../playback/moment'
import { isSettled, type Said, type State } from '../state/state'
import { cellFactsInWords } from './cell-line'
import { outcomeInWords } from './outcome-in-words'
import { stepInWords } from './steps-in-words'

/**
 * What is to be said now, after `said` has been said: `null` if nothing new, or if it waits for the
 * plan that belongs to it.
 */
export function announcement(
  state: State,
  moment: Moment | null,
  said: Said | null,
): string | null {
  if (state.said === said) return null
  const { text } = state.said
  switch (state.said.followedBy) {
    case 'nothing':
      return text || null
    case 'outcome':
      return withOutcome(state, text)
    case 'step':
      return moment && joined(text, stepInWords(moment))
    case 'cell':
      return joined(text, moment ? cellFactsInWords(moment, state.setup.problem, state.cursor) : '')
  }
}

const joined = (...parts: readonly string[]): string => parts.filter(Boolean).join(' ')

function withOutcome(state: State, text: string): string | null {
  if (text === '') return null
  if (state.run.kind === 'failed') return `${text} No plan: ${state.run.message}`
  if (state.run.kind === 'cancelled') return `${text} Planning was cancelled.`
  if (!isSettled(state) || !state.shown) return null
  const { outcome, tape } = state.shown
  return `${text} ${outcomeInWords(outcome, tape.width)}.`
}

/** Speaks through a live region; the same words twice are said twice. */
export function announcer(
  region: Pick<HTMLElement, 'textContent'>,
): (state: State, moment: Moment | null) => void {
  let said: Said | null = null
  return (state, moment) => {
    const text = announcement(state, moment, said)
    if (text === null) return
    said = state.said
    region.textContent = region.textContent === text ? `${text}\u00a0` : text
  }
}
