import { plannerById } from '../../algorithms/plan'
import { byId, create, createSvg } from '../element'
import { type Scenario, withScenario } from '../scenarios/scenario'
import { scenarios } from '../scenarios/scenarios'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { changeMap } from '../state/transitions'
import { newDialog } from './dialog'
import markup from './scenarios.html?raw'

/** Makes the dialog of the scenarios; returns what opens it. */
export function scenariosDialog(store: Store<State>): () => void {
  const element = newDialog('scenarios-dialog', markup)
  const list = byId('scenarios-list', HTMLUListElement)
  for (const scenario of scenarios) {
    const { title, figure, see, planner } = scenario
    const button = create(
      'button',
      { type: 'button', class: 'scenario', 'data-scenario': scenario.id },
      thumbnail(scenario),
      create('span', { class: 'scenario-title' }, figure ? `${figure}: ${title}` : title),
      create('span', { class: 'scenario-planner' }, plannerById(planner).title),
      create('span', { class: 'scenario-see' }, see),
    )
    button.addEventListener('click', () => {
      element.close()
      store.update((state) => changeMap(state, withScenario(state.setup, scenario), `${title}.`))
    })
    list.append(create('li', {}, button))
  }
  return () => element.showModal()
}

/** A small picture of a map. */
function thumbnail({ problem }: Scenario): SVGSVGElement {
  const { grid, start, goal } = problem
  const { width } = grid
  const square = (cell: number) => `M${cell % width} ${Math.floor(cell / width)}h1v1h-1z`
  const walls = [...grid.walls.keys()].filter((cell) => grid.walls[cell] === 1)
  return createSvg(
    'svg',
    { class: 'thumbnail', viewBox: `0 0 ${width} ${grid.height}`, 'aria-hidden': 'true' },
    createSvg('path', { class: 'thumbnail-walls', d: walls.map(square).join('') }),
    createSvg('path', { class: 'thumbnail-start', d: square(start) }),
    createSvg('path', { class: 'thumbnail-goal', d: square(goal) }),
  )
}
