import type { AnyPlanner } from '../../algorithms/planner'
import { type CodeLine, codeSection } from '../code-section'
import { byId, create, setText } from '../element'
import { loopBegan } from '../loop'
import type { Moment } from '../moment'
import { numberInWords } from '../numbers'
import { plannerOf, type Setup, valuesOf } from '../setup'
import { isFast } from '../speeds'
import type { State } from '../state'
import { stepNumbers } from '../step-numbers'
import { landmarkInWords, stepInWords } from '../steps-in-words'
import type { Store } from '../store'
import { leftOut } from '../thinning'
import { toStep } from '../transport'
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
    store.update((state) => ({ ...toStep(state, step), said: { text: '', followedBy: 'step' } }))
    // The button is gone with the loop.
    byId('scrubber', HTMLInputElement).focus()
  })

  return ({ playing, setup }, moment) => {
    const text = moment ? inWords(moment, isFast(playing)) : 'There is no plan to step through.'
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

/** The planner's pseudocode in a box that scrolls to the line of the step. */
class CodeList {
  readonly #list: HTMLOListElement
  readonly #layout = new ResizeObserver(() => this.#reveal())
  #planner: AnyPlanner | null = null
  #variant: unknown
  #lines: readonly CodeLine[] = []
  #items: readonly HTMLElement[] = []
  #current = -1
  #isNew = true

  constructor(list: HTMLOListElement) {
    this.#list = list
    // It scrolls, so the keyboard has to reach it.
    list.tabIndex = 0
  }

  show(setup: Setup, line: number): void {
    const planner = plannerOf(setup)
    const values = valuesOf(setup)
    if (planner !== this.#planner || values.variant !== this.#variant) {
      this.#planner = planner
      this.#variant = values.variant
      this.#lines = codeSection(planner, values)
      this.#current = -1
      this.#isNew = true
      this.#items = this.#lines.map(lineItem)
      this.#list.replaceChildren(...this.#items)
    }
    if (line !== this.#current) this.#mark(line)
    if (this.#isNew) this.#revealOnceLaidOut()
  }

  #mark(line: number): void {
    this.#itemOf(this.#current)?.removeAttribute('aria-current')
    this.#current = line
    this.#itemOf(line)?.setAttribute('aria-current', 'step')
    this.#revealOnceLaidOut()
  }

  /** Whom an observer begins to observe, it tells of in the same frame, once the layout is known. */
  #revealOnceLaidOut(): void {
    this.#layout.unobserve(this.#list)
    this.#layout.observe(this.#list)
  }

  /** Only the list scrolls: `scrollIntoView` would move what is around it as well. */
  #reveal(): void {
    const list = this.#list
    if (this.#isNew) list.scrollTop = 0
    this.#isNew = false
    const item = this.#itemOf(this.#current)
    if (!item) return
    const { offsetTop: top, offsetHeight: height } = item
    if (top < list.scrollTop) list.scrollTop = top
    else if (top + height > list.scrollTop + list.clientHeight) {
      list.scrollTop = top + height - list.clientHeight
    }
  }

  #itemOf(line: number): HTMLElement | undefined {
    const place = this.#lines.findIndex((shown) => shown.line === line)
    return this.#items[place]
  }
}

function lineItem({ text }: CodeLine): HTMLLIElement {
  const depth = text.length - text.trimStart().length
  return create('li', { 'data-depth': depth }, create('code', {}, text.trimStart()))
}
