import type { RunList } from '../../charts/chart'
import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import { dialog } from '../dialogs/dialog'
import { byId, create, setText } from '../element'
import { numberInWords } from '../words/numbers'
import { addressOf } from './open-in-playground'
import { mapInWords, runInWords } from './run-words'

/** Each run's map has to be made once more for its link. */
const AT_A_TIME = 20

/** What is to be looked at: the runs behind a mark of a chart, or a number of the table. */
export interface RunsAsked {
  readonly label: string
  readonly runs: readonly RunList[]
}

/** Binds the dialog of the runs behind a number; returns what opens it. */
export function runsDialog(): (settings: ExperimentSettings, asked: RunsAsked) => void {
  const element = dialog('runs-dialog')
  const about = byId('runs-about', HTMLParagraphElement)
  const lists = byId('runs-lists', HTMLDivElement)
  return (settings, { label, runs }) => {
    setText(about, `${label}.`)
    lists.replaceChildren(...runs.flatMap((list) => listOf(settings, list)))
    element.showModal()
    element.scrollTop = 0
  }
}

function listOf(settings: ExperimentSettings, { title, rows }: RunList): HTMLElement[] {
  const head = create('h3', {}, `${title}: ${numberInWords(rows.length)}`)
  if (rows.length === 0) return [head]
  const list = create('ul', { class: 'runs' })
  const more = create('button', { type: 'button', class: 'btn tonal' })
  let shown = 0
  const showMore = () => {
    const next = rows.slice(shown, shown + AT_A_TIME).map((row) => itemOf(settings, row))
    list.append(...next)
    shown += next.length
    more.hidden = shown === rows.length
    const left = rows.length - shown
    setText(more, `Show ${Math.min(AT_A_TIME, left)} more of ${numberInWords(left)}`)
    return next[0]
  }
  more.addEventListener('click', () => showMore()?.querySelector('a')?.focus())
  showMore()
  return [head, list, more]
}

function itemOf(settings: ExperimentSettings, row: Row): HTMLElement {
  const name = mapInWords(settings, row)
  const link = create(
    'a',
    { href: addressOf(settings, row), target: '_blank', rel: 'noopener', class: 'run-link' },
    'Open in the playground',
    create('span', { class: 'visually-hidden' }, `, ${name}`),
  )
  const words = create('span', {}, create('strong', {}, name), create('br'), runInWords(row))
  return create('li', {}, words, link)
}
