import type { Grid } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import type { SavedPicture } from '../../render/export'
import type { Scene } from '../../render/scene'
import type { Work } from '../../render/work'
import { fetchedPart } from '../fetched-part'
import { plannerOf } from '../state/setup'
import { type State, visiblePlan } from '../state/state'
import type { Store } from '../state/store'
import { say } from '../state/transitions'
import { leftOut } from '../words/thinning'
import { blobInSlices, inSlices } from './in-slices'
import { type Saved, saveFiles } from './save-files'
import type { ShownWork } from './shown-work'

/** The map's name without an ending, the same for all files that belong together. */
const nameOf = ({ width, height }: Grid): string => `path-planner-${width}x${height}`

async function projectFile({ setup }: State, { signal }: ShownWork): Promise<Saved> {
  const { problem } = setup
  const { saveProject } = await fetchedPart(import('../../grid/formats/project-file'))
  const content = await blobInSlices(saveProject(problem), signal)
  return { name: `${nameOf(problem.grid)}.json`, content }
}

async function mapFile({ grid }: Problem, { signal }: ShownWork): Promise<Saved> {
  const { movingAiMap } = await fetchedPart(import('../../grid/formats/movingai'))
  return { name: `${nameOf(grid)}.map`, content: await blobInSlices(movingAiMap(grid), signal) }
}

/** The trace of the plan on screen, and the map that it opens upon. */
async function traceFiles(state: State, work: ShownWork): Promise<Saved[]> {
  const shown = visiblePlan(state)
  if (!shown) throw new Error('There is no plan on screen.')
  const { posthocTrace } = await fetchedPart(import('../../trace/posthoc'))
  const { setup, tape } = shown
  const { id, title, phases, variables } = plannerOf(setup)
  const { problem } = setup
  const map = await mapFile(problem, work)
  const info = { plannerId: id, title, phases, variables, problem, mapFile: map.name }
  const name = `${nameOf(problem.grid)}-${id}.trace.json`
  const content = await blobInSlices(posthocTrace(tape, info, work), work.signal)
  return [{ name, content, missing: leftOut(tape.thinning).words }, map]
}

const TOO_MANY = 'The picture leaves out vertices or edges, because they are too many.'

async function pictureFile(
  { setup }: State,
  scene: Scene,
  kind: 'png' | 'svg',
  { signal }: ShownWork,
): Promise<Saved> {
  const { pictureAsPng, pictureAsSvg } = await fetchedPart(import('../../render/export'))
  const name = `${nameOf(setup.problem.grid)}-${setup.plannerId}.${kind}`
  const asMap = { ...scene, cursor: -1, hovered: -1 }
  const picture: Work<SavedPicture> = kind === 'png' ? pictureAsPng(asMap) : pictureAsSvg(asMap)
  const { content, isCrowded } = await inSlices(picture, () => {}, signal)
  return { name, content: await content, missing: isCrowded ? TOO_MANY : '' }
}

/** What saves, by the name of the menu's entry. */
export function savers(store: Store<State>, sceneNow: () => Scene) {
  const save = (make: (state: State, work: ShownWork) => Promise<readonly Saved[]>) => async () => {
    const saved = await saveFiles(store, (work) => make(store.state, work))
    if (saved.length === 0) return
    const names = saved.map(({ name }) => name).join(' and ')
    store.update((state) => say(state, `Saved as ${names}.`))
  }
  return {
    save: save(async (state, work) => [await projectFile(state, work)]),
    'save-map': save(async ({ setup }, work) => [await mapFile(setup.problem, work)]),
    'save-trace': save(traceFiles),
    'save-png': save(async (state, work) => [await pictureFile(state, sceneNow(), 'png', work)]),
    'save-svg': save(async (state, work) => [await pictureFile(state, sceneNow(), 'svg', work)]),
  }
}
