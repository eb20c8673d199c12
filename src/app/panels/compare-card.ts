import { isSameSubject } from '../compare/compared'
import type { Comparison } from '../compare/state'
import { toggleComparison, togglePath } from '../compare/transitions'
import { byId, setText } from '../element'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { ComparisonTable } from './compare-table'

/**
 * Binds the comparison's card and its button in the toolbar; returns what shows a state in them.
 * @param rearranged called when the card comes or goes
 */
export function compareCard(store: Store<State>, rearranged: () => void): (state: State) => void {
  const card = byId('comparison', HTMLElement)
  const button = byId('compare', HTMLButtonElement)
  const fault = byId('comparison-fault', HTMLParagraphElement)
  let table: ComparisonTable | null = null
  const newTable = () =>
    new ComparisonTable(byId('comparison-table', HTMLTableElement), (plannerId) =>
      store.update((state) => togglePath(state, plannerId)),
    )
  const toggle = () => store.update(toggleComparison)
  button.addEventListener('click', toggle)
  byId('comparison-close', HTMLButtonElement).addEventListener('click', () => {
    toggle()
    // The card is gone, and with it what had the focus.
    button.focus()
  })
  let shown: Comparison | null = null
  let setup: State['setup'] | null = null

  return (state) => {
    const { comparison } = state
    if (comparison === shown && state.setup === setup) return
    shown = comparison
    setup = state.setup
    button.setAttribute('aria-pressed', String(comparison.isOn))
    if (card.hidden === comparison.isOn) {
      card.hidden = !comparison.isOn
      fold(card, !comparison.isOn)
      rearranged()
    }
    setText(fault, comparison.fault)
    fault.hidden = comparison.fault === ''
    if (comparison.isOn) table ??= newTable()
    table?.show(comparison, ({ subject }) => isSameSubject(subject, state.setup))
  }
}

/** By its own button, so that other cards are folded where there is no room for both. */
function fold(card: HTMLElement, folded: boolean): void {
  const button = card.querySelector<HTMLElement>('[data-fold]')
  if (button?.getAttribute('aria-expanded') === String(folded)) button.click()
}
