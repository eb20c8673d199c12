import type { AnyPlanner } from '../../algorithms/planner'
import { create } from '../element'
import { plannerOf, type Setup, valuesOf } from '../state/setup'
import { type CodeLine, codeSection } from '../words/code-section'

/** The planner's pseudocode in a box that scrolls to the line of the step. */
export class CodeList {
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

  /** An observer reports an element that it begins to observe in the same frame, after the layout. */
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
