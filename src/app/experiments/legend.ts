import type { Chart, Series } from '../../charts/chart'
import type { Drawing } from '../../charts/drawing'
import { drawSwatch } from '../../charts/legend'
import { create, setText } from '../element'

/** What the lines of a chart mean, each a button that leaves its series out or brings it back. */
export class Legend {
  readonly element = create('div', { class: 'legend' })
  readonly #chart: Chart
  readonly #toggled: (series: string) => void
  readonly #shown = create('fieldset', {})
  readonly #others = create('fieldset', {})
  readonly #summary = create('summary')
  readonly #details = create('details', {}, this.#summary, this.#others)

  constructor(chart: Chart, toggled: (series: string) => void) {
    this.#chart = chart
    this.#toggled = toggled
    if (chart.series.length > 1) this.element.append(this.#shown, this.#details)
  }

  show(drawing: Drawing): void {
    const { series } = this.#chart
    const { activeElement } = document
    const focused = this.element.contains(activeElement)
      ? activeElement?.getAttribute('data-series')
      : null
    const shown = series.filter(({ name }) => drawing.isShown(name))
    const others = series.filter(({ name }) => !drawing.isShown(name))
    this.#fill(this.#shown, 'On show', shown, drawing)
    this.#fill(this.#others, 'Left out', others, drawing)
    this.#details.hidden = others.length === 0
    setText(this.#summary, `Left out: ${others.length} of ${series.length}`)
    if (typeof focused !== 'string') return
    // The button has moved, perhaps to where it is not seen.
    const button = [...this.element.querySelectorAll<HTMLElement>('[data-series]')].find(
      (one) => one.dataset.series === focused,
    )
    if (button?.checkVisibility()) button.focus()
    else this.#summary.focus()
  }

  #fill(group: HTMLElement, name: string, series: readonly Series[], drawing: Drawing): void {
    const legend = create('legend', { class: 'visually-hidden' }, name)
    group.replaceChildren(legend, ...series.map((one) => this.#button(one, drawing)))
  }

  #button(series: Series, { theme, isShown }: Drawing): HTMLElement {
    const button = create('button', {
      type: 'button',
      class: 'legend-item',
      'aria-pressed': String(isShown(series.name)),
      'data-series': series.name,
    })
    if (this.#chart.kind === 'lines') button.append(drawSwatch(series, theme))
    button.append(create('span', {}, series.name))
    button.addEventListener('click', () => this.#toggled(series.name))
    return button
  }
}
