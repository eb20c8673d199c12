import { byId, setText } from '../element'
import { loopBegan } from '../playback/loop'
import type { Moment } from '../playback/moment'
import { isFast } from '../playback/speeds'
import { jumpToStep } from '../playback/transport'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { numberInWords } from '../words/numbers'
import { stepNumbers } from '../words/step-numbers'
import { landmarkInWords, noStepsInWords, stepInWords } from '../words/steps-in-words'
import { leftOut } from '../words/thinning'
import { CodeList } from './code-list'
import { showRows } from './rows'

/** Binds the card that says why; returns what shows a moment in it. */
export function stepsCard(store: Store<State>): (state: State, moment: Moment | null) => void {
  const words = byId('steps-words', HTMLParagraphElement)
  const brief = byId('steps-brief', HTMLSpanElement)
  const thinned = byId('steps-left-out', HTMLParagraphElement)
  const table = byId('steps-numbers', HTMLTableElement)
  const before = byId('loop-began', HTMLButtonElement)
  const code = new CodeList(byId('steps-code', HTMLOListElement))
  let loop: number | null = null
  before.addEventListener('click', () => {
    const step = loop
    if (step === null) return
    store.update((state) => jumpToStep(state, step))
    // The button is hidden now, and would take the focus with it.
    byId('scrubber', HTMLInputElement).focus()
  })

  return (state, moment) => {
    const { playing, setup } = state
    const text = moment ? inWords(moment, isFast(playing)) : noStepsInWords(state)
    setText(words, text)
    setText(brief, text)
    const { words: missing } = leftOut(moment?.shown.tape.thinning ?? 'whole')
    setText(thinned, missing)
    thinned.hidden = missing === ''
    loop = moment && loopBegan(moment)
    before.hidden = loop === null
    setText(before, loop === null ? '' : `See that time: step ${numberInWords(loop)}`)
    showRows(table, moment ? stepNumbers(moment) : [])
    code.show(moment?.shown.setup ?? setup, moment?.frame.line ?? -1)
  }
}

const inWords = (moment: Moment, fast: boolean): string =>
  fast ? landmarkInWords(moment) : stepInWords(moment)
