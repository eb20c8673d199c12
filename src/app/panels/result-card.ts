import { byId, setText } from '../element'
import { type IconName, setIcon } from '../icons'
import type { Planning } from '../planning/planning'
import { plannerOf } from '../state/setup'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { PATH_HIDDEN, sayOutcome } from '../state/transitions'
import type { NumberRow } from '../words/numbers'
import { outcomeInWords, outcomeNumbers, reasonInWords, toneOf } from '../words/outcome-in-words'
import { showProgress } from './progress'
import { showRows } from './rows'

interface Report {
  readonly tone: IconName
  readonly words: string
  readonly detail: string
  readonly rows: readonly NumberRow[]
}

const NO_ROWS: readonly NumberRow[] = []

/** What the result card says of a state. */
export function reportOf({ run, shown, clearPath, setup }: State): Report {
  const title = plannerOf(setup).title
  if (run.kind === 'running' && (run.slow || !shown)) {
    const detail = `${title} is working.`
    return { tone: 'busy', words: 'Planning…', detail, rows: NO_ROWS }
  }
  if (run.kind === 'cancelled') {
    const detail = `${title} was stopped before it came to an answer.`
    return { tone: 'bad', words: 'Cancelled', detail, rows: NO_ROWS }
  }
  if (run.kind === 'failed') {
    return { tone: 'bad', words: 'No plan', detail: run.message, rows: NO_ROWS }
  }
  if (!shown) return { tone: 'busy', words: 'No plan yet', detail: '', rows: NO_ROWS }
  if (clearPath === 'done') {
    return { tone: 'clear-path', words: 'Path cleared', detail: PATH_HIDDEN, rows: NO_ROWS }
  }
  const { outcome, milliseconds } = shown
  const planner = plannerOf(shown.setup)
  return {
    tone: toneOf(outcome.status),
    words: outcomeInWords(outcome, shown.tape.width),
    detail: reasonInWords(outcome),
    rows: outcomeNumbers(outcome, milliseconds, planner.family),
  }
}

/** Binds the result card; returns what shows a state in it. */
export function resultCard(store: Store<State>, planning: Planning): (state: State) => void {
  const card = byId('result', HTMLElement)
  const words = byId('result-words', HTMLHeadingElement)
  const detail = byId('result-detail', HTMLParagraphElement)
  const progress = byId('result-progress', HTMLDivElement)
  const again = byId('result-again', HTMLButtonElement)
  const cancel = byId('result-cancel', HTMLButtonElement)
  const table = byId('result-numbers', HTMLTableElement)
  const sign = card.querySelector<SVGSVGElement>('#result-icon')
  const bar = progress.querySelector<HTMLElement>('[role=progressbar]')
  const fold = card.querySelector<HTMLElement>('[data-fold]')
  const isSeen = (button: HTMLElement | null) => (button?.getClientRects().length ?? 0) > 0
  cancel.addEventListener('click', planning.cancel)
  again.addEventListener('click', () => {
    planning.ask()
    store.update(sayOutcome)
  })

  return (state) => {
    const report = reportOf(state)
    const { run } = state
    const isSlow = run.kind === 'running' && run.slow
    const focused = [cancel, again].find((button) => button === document.activeElement)
    card.dataset.tone = report.tone
    if (sign) setIcon(sign, report.tone)
    setText(words, report.words)
    setText(detail, report.detail)
    detail.hidden = report.detail === ''
    progress.hidden = !isSlow
    if (run.kind === 'running') showProgress(bar, run.done)
    again.hidden = run.kind !== 'cancelled' && run.kind !== 'failed'
    // The button that was pressed goes, and the focus would go with it.
    if (focused && !isSeen(focused)) [again, cancel, fold].find(isSeen)?.focus()
    showRows(table, report.rows)
  }
}
