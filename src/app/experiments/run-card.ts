import { countWork } from '../../experiments/settings'
import { byId, setText } from '../element'
import { countInWords } from '../words/numbers'
import type { PageState } from './state'
import { progressInWords } from './transitions'

export interface RunCardEvents {
  start(): void
  cancel(): void
}

/** Binds the card that starts, shows and ends a run; returns what shows a state in it. */
export function runCard(events: RunCardEvents): (state: PageState) => void {
  const amount = byId('amount', HTMLParagraphElement)
  const start = byId('start', HTMLButtonElement)
  const cancel = byId('cancel', HTMLButtonElement)
  const progress = byId('progress', HTMLDivElement)
  const words = byId('progress-words', HTMLParagraphElement)
  const bar = progress.querySelector('[role=progressbar]')
  const filled = progress.querySelector<HTMLElement>('.determinate')
  start.addEventListener('click', events.start)
  cancel.addEventListener('click', events.cancel)

  return (state) => {
    const { run, checked } = state
    const isRunning = run.kind === 'running'
    setText(amount, amountInWords(state))
    amount.classList.toggle('fault', checked.kind === 'fault')
    // The focus must not get lost on a button that goes.
    const hadFocus = document.activeElement === (isRunning ? start : cancel)
    start.hidden = isRunning
    cancel.hidden = !isRunning
    progress.hidden = !isRunning
    if (hadFocus) (isRunning ? cancel : start).focus()
    if (!isRunning) return
    const percent = Math.floor((100 * run.done) / run.total)
    bar?.setAttribute('aria-valuenow', String(percent))
    if (filled) filled.style.width = `${(100 * run.done) / run.total}%`
    setText(words, progressInWords(run))
  }
}

function amountInWords({ checked }: PageState): string {
  if (checked.kind === 'fault') return 'The settings have a mistake; it is marked.'
  const { maps, settings, runs } = countWork(checked.settings)
  const each = countInWords(settings, 'planner setting')
  return `${countInWords(maps, 'map')} × ${each} = ${countInWords(runs, 'run')}`
}
