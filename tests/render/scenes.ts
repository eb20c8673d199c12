import { plan } from '../../src/algorithms/plan'
import type { Problem } from '../../src/grid/problem'
import { randomNumbers } from '../../src/grid/random'
import { pictureAsSvg } from '../../src/render/export'
import type { Scene } from '../../src/render/scene'
import { themes } from '../../src/render/theme'
import { frameAt } from '../../src/trace/fold'
import { Tape } from '../../src/trace/tape'
import { runToEnd } from './run-to-end'

/** What a planner writes on its tape. */
export function tapeOf(problem: Problem, planner: string): Tape {
  const tape = new Tape()
  plan(problem, planner, { tape })
  return tape
}

/** A dark scene without a plan; change what the test is about. */
export function sceneOf(problem: Problem, changes: Partial<Scene> = {}): Scene {
  return {
    problem,
    theme: themes.dark,
    plan: null,
    sensorRange: 0,
    sight: 'both',
    showPotential: false,
    comparison: [],
    cursor: -1,
    hovered: -1,
    ...changes,
  }
}

/** The text of its picture. */
export const svgOf = (scene: Scene): string => runToEnd(pictureAsSvg(scene)).content

/** The plan on a tape after `time` events; all of them if nothing is said. */
export function momentOf(tape: Tape, time = tape.length) {
  return { tape, frame: frameAt(tape, time) }
}

/** A map with random obstacles, start in its first and goal in its last cell. */
export function randomProblem(
  width: number,
  height: number,
  density: number,
  seed: number,
): Problem {
  const random = randomNumbers(seed)
  const walls = Uint8Array.from({ length: width * height }, () => (random() < density ? 1 : 0))
  const goal = width * height - 1
  walls[0] = 0
  walls[goal] = 0
  return {
    grid: { width, height, walls },
    start: 0,
    goal,
    diagonal: 'if-at-most-one-obstacle',
  }
}
