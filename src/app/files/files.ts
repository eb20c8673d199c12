import { InputError, messageOf } from '../../grid/errors'
import type { Problem } from '../../grid/problem'
import { fetchedPart } from '../fetched-part'
import { tell, tellOfMap } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { changeMap } from '../state/transitions'
import { DIAGONAL_RULE_WORDS } from '../words/diagonal-rules'
import { onFileChosen } from './chosen-file'

/** More than any map needs; a larger file is not even read. */
const MOST_BYTES = 64 * 2 ** 20

/**
 * Opens the map in a file. If that fails, a message says why, and the map on screen stays.
 * @param isWanted whether no other file was asked for while this one was read
 */
async function openFile(store: Store<State>, file: File, isWanted: () => boolean): Promise<void> {
  try {
    if (file.size > MOST_BYTES) {
      const size = Math.round(file.size / 2 ** 20)
      throw new InputError(
        `It has ${size} MB, more than the ${MOST_BYTES / 2 ** 20} MB of any map.`,
      )
    }
    const { openMap } = await fetchedPart(import('../../grid/formats/open-map'))
    const text = await file.text()
    if (!isWanted()) return
    const { problem, notes } = openMap(text)
    const { width, height } = problem.grid
    const opened = `Opened ${file.name}: ${width} × ${height} cells.`
    store.update((state) => {
      const changed = changeMap(state, { ...state.setup, problem }, opened)
      return tellOfMap(changed, 'note', [opened, ...notes, ...ruleNote(state, problem)].join(' '))
    })
  } catch (error) {
    if (!isWanted()) return
    store.update((state) =>
      tell(state, 'error', `${file.name} was not opened. ${messageOf(error)}`),
    )
  }
}

/** Who did not choose another rule would wonder why the same map has another path. */
function ruleNote({ setup }: State, { diagonal }: Problem): string[] {
  if (diagonal === setup.problem.diagonal) return []
  return [`Diagonal steps are now: ${DIAGONAL_RULE_WORDS[diagonal].title}.`]
}

/** Binds the page's file input and dropping a file on the page; returns what asks for a file. */
export const bindFiles = (store: Store<State>): (() => void) =>
  onFileChosen(store, (file, isWanted) => void openFile(store, file, isWanted))
