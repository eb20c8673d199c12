import { byId, setText } from '../element'
import type { State } from '../state/state'

const WORDS = 'Too many vertices or edges to show: zoom in.'

/** Binds the line that says that a roadmap is not all on screen; returns what shows a state in it. */
export function crowdedNote(): (state: State) => void {
  const note = byId('crowded', HTMLParagraphElement)
  let readOf = ''

  return ({ crowded, setup }) => {
    const { width, height } = setup.problem.grid
    const roadmap = `${setup.plannerId} ${width} ${height}`
    if (crowded && note.textContent === '') {
      // Read aloud the first time, and not whenever one has zoomed in and out again.
      note.setAttribute('aria-live', roadmap === readOf ? 'off' : 'polite')
      readOf = roadmap
    }
    setText(note, crowded ? WORDS : '')
  }
}
