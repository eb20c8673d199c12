import type { OpenedMap } from '../../grid/formats/opened-map'
import type { Problem } from '../../grid/problem'
import { tellOfMap } from '../state/messages'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { changeMap } from '../state/transitions'
import { DIAGONAL_RULE_WORDS } from '../words/diagonal-rules'
import { onFileChosen } from './chosen-file'
import { MapsBeside } from './map-beside'
import { readMap } from './opening-worker'

/**
 * Returns what opens the map in a file. If that fails, a message says why, and the map on screen stays.
 */
export function openingFor(store: Store<State>, read = readMap): (file: File) => void {
  const beside = new MapsBeside(store)
  return (file) =>
    void beside.make({
      words: { doing: `Opening ${file.name}…`, failed: `${file.name} was not opened` },
      make: (signal) => read(file, signal),
      put: (opened) => store.update((state) => withMap(state, file.name, opened)),
    })
}

function withMap(state: State, name: string, { problem, notes }: OpenedMap): State {
  const { width, height } = problem.grid
  const opened = `Opened ${name}: ${width} × ${height} cells.`
  const changed = changeMap(state, { ...state.setup, problem }, opened)
  return tellOfMap(changed, 'note', [opened, ...notes, ...ruleNote(state, problem)].join(' '))
}

/** Who did not choose another rule would wonder why the same map has another path. */
function ruleNote({ setup }: State, { diagonal }: Problem): string[] {
  if (diagonal === setup.problem.diagonal) return []
  return [`Diagonal steps are now: ${DIAGONAL_RULE_WORDS[diagonal].title}.`]
}

/** Binds the page's file input and dropping a file on the page; returns what asks for a file. */
export const bindFiles = (store: Store<State>): (() => void) =>
  onFileChosen(store, openingFor(store))
