import type { Mark } from '../../charts/chart'
import { chartsOf } from '../../charts/charts'
import { chartThemes, type ThemeName } from '../../charts/style'
import type { Results } from '../../experiments/results'
import { countInWords } from '../words/numbers'
import { type ChartCard, chartCard } from './chart-card'

export interface ChartsEvents {
  opened(mark: Mark): void
  toggled(series: string): void
}

/** Charts on the page. This file and what it imports is loaded only when there is something to see. */
export class ChartsPanel {
  readonly #cards: readonly ChartCard[]
  readonly #container: HTMLElement
  readonly #sizes: ResizeObserver
  #theme: ThemeName = 'dark'
  #hidden: ReadonlySet<string> = new Set()
  #width = 0

  constructor(container: HTMLElement, { settings, rows }: Results, events: ChartsEvents) {
    const note = `Path Planner, seed ${settings.seed}, ${countInWords(rows.length, 'run')}`
    this.#cards = chartsOf(settings, rows).map((chart) => chartCard(chart, note, events))
    this.#container = container
    container.replaceChildren(...this.#cards.map(({ element }) => element))
    this.#sizes = new ResizeObserver(() => {
      if (Math.floor(this.#container.clientWidth) !== this.#width) this.#draw()
    })
    this.#sizes.observe(container)
  }

  show(theme: ThemeName, hidden: ReadonlySet<string>): void {
    if (theme === this.#theme && hidden === this.#hidden && this.#width > 0) return
    this.#theme = theme
    this.#hidden = hidden
    this.#draw()
  }

  /** Other results have taken their place. */
  dispose(): void {
    this.#sizes.disconnect()
  }

  #draw(): void {
    this.#width = Math.floor(this.#container.clientWidth)
    if (this.#width === 0) return
    const theme = chartThemes[this.#theme]
    const hidden = this.#hidden
    const drawing = { width: this.#width, theme, isShown: (name: string) => !hidden.has(name) }
    for (const card of this.#cards) card.draw(drawing)
  }
}
