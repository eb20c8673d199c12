import { type Cell, isSameSize } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { type Frame, packed } from '../trace/frame'
import type { Tape } from '../trace/tape'
import type { StyledPath } from './path-styles'
import type { Theme } from './theme'

/** The plan on screen and its picture at this moment. */
export interface PlanMoment {
  readonly tape: Tape
  readonly frame: Frame
}

/**
 * What is shown of a planner with a rover: the world, with all obstacles, sensed or not; only what
 * the rover knows; or both, the world with a veil over what the rover does not know.
 */
export type Sight = 'both' | 'world' | 'known'

/** All that the drawing of the map depends on, apart from where the map lies on the screen. */
export interface Scene {
  readonly problem: Problem
  readonly theme: Theme
  /** `null` while there is none. */
  readonly plan: PlanMoment | null
  /** Cells that the rover senses around it; 0 for planners without a rover. */
  readonly sensorRange: number
  /** It counts only for planners with a rover. */
  readonly sight: Sight
  /** Whether potentials are shown, as a heat map and, in large cells, as numbers. */
  readonly showPotential: boolean
  /** Paths that are drawn together, on a map of this size; none unless planners are compared. */
  readonly comparison: readonly StyledPath[]
  /** The keyboard's cell; -1 if the map is not being used by keyboard. */
  readonly cursor: Cell
  /** The cell that is asked about, by pointer or keyboard; -1 if none. */
  readonly hovered: Cell
}

/**
 * The scene as it is now, for work that lasts. Playing goes on changing a frame: what is drawn of it is
 * copied, but for the vertices and edges, to which others are only added.
 */
export function still(scene: Scene): Scene {
  if (!scene.plan) return scene
  const { tape, frame } = scene.plan
  const { field } = frame
  const values = (field && scene.showPotential && frame.fields[field]?.slice()) ?? null
  const fields = {
    attraction: null,
    repulsion: null,
    potential: null,
    ...(field && { [field]: values }),
  }
  const kept = { ...packed(frame), cells: frame.cells.slice(), fields }
  return { ...scene, plan: { tape, frame: kept } }
}

/** The plan; `null` as well if it was made for a map of another size, whose cells are not these. */
export function planOnMap({ problem, plan }: Scene): PlanMoment | null {
  return plan && isSameSize(plan.tape, problem.grid) ? plan : null
}

/**
 * What is shown of the map: the world, unless a planner with a rover is on show. What a rover has
 * sensed is not on a thinned tape.
 */
export function sightOf(scene: Scene): Sight {
  const isKnown = scene.sensorRange > 0 && planOnMap(scene)?.tape.thinning === 'whole'
  return isKnown ? scene.sight : 'world'
}
