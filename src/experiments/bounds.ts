import { BoundaryWalk, obstacleInTheWay, type Turn } from '../algorithms/boundary'
import { completeParams } from '../algorithms/params'
import { plannerById } from '../algorithms/plan'
import { stepOffsets } from '../grid/directions'
import { type Cell, type Grid, pointOf } from '../grid/grid'
import { allLegalSteps } from '../grid/legal-steps'
import { checkProblem, type Problem } from '../grid/problem'
import { distance, farness, simplestPath, simplestStep } from '../grid/simplest-path'
import { DriveNotes } from '../rover/drive-notes'
import { SimulatedRover } from '../rover/simulated-rover'

/*
 * The bounds of V. J. Lumelsky and A. A. Stepanov, "Path-planning strategies for a point mobile
 * automaton moving amidst unknown obstacles of arbitrary shape", Algorithmica 2, 1987, on the grid.
 *
 * All lengths are steps. An obstacle is a set of obstacle cells joined by sides or corners (all that
 * is outside the map belongs to one of them), together with the free cells that it cuts off from the
 * rover. Its perimeter p is the number of straight steps once around it; those on both sides of a
 * thin wall count, and so do those there and back in a dead end. A step along a boundary determines
 * the one after it and the one before it, so that the directed steps along boundaries fall into
 * rings without a step in common: one ring, and one perimeter, for each obstacle.
 */

/** An obstacle that stops the rover, and what it may cost. */
export interface ObstacleShare {
  /** The cell where it stops the rover first. */
  readonly hit: Cell
  /** Steps once around it. */
  readonly perimeter: number
  /** How many times that may be walked. */
  readonly rounds: number
}

/** At most so many steps: the distance, and for each obstacle its rounds times its perimeter. */
export interface LengthBound {
  /** D: steps of the simplest path from start to goal. */
  readonly distance: number
  readonly obstacles: readonly ObstacleShare[]
  readonly steps: number
}

/**
 * Bug1: D + 1.5 Σ pᵢ over the obstacles that it meets. (The paper adds up all obstacles within D of
 * the goal; these are some of them, so that this bound is the lower one.)
 *
 * It holds on the grid. Each step towards the goal brings it nearer by one, and each boundary is left
 * no farther from it than it was hit, so that these steps are at most D. A round is pᵢ steps, the
 * way back to the nearest cell at most half as many. From there on all cells are nearer, so that this
 * boundary is never met again.
 *
 * But for one case, which the continuous plane has not: if the rover is refused right where it left,
 * it does not know whether this is the same obstacle, because on the grid two may touch one cell. It
 * goes round once more and finds nothing nearer: the goal is unreachable, and this last obstacle
 * counts 2.5 rounds.
 * @throws InputError that says what is wrong with the problem or the turn
 */
export function bug1Bound(problem: Problem, turn: Turn): LengthBound {
  checkProblem(problem)
  completeParams(plannerById('bug1'), { turn }, problem)
  const { grid, start, goal } = problem
  const legal = allLegalSteps(grid, problem.diagonal)
  const far = (cell: Cell) => farness(pointOf(grid.width, cell), pointOf(grid.width, goal))
  const obstacles: ObstacleShare[] = []
  let before: number | null = null
  for (let left = start; ; ) {
    const hit = firstRefusal(problem, legal, left)
    if (hit === goal) break
    const round = roundFrom(problem, hit, turn)
    const perimeter = round.length - 1
    const ring = ringOf(grid, round)
    if (hit === left && ring === before) {
      const last = obstacles.pop()
      if (last) obstacles.push({ ...last, rounds: 2.5 })
      break
    }
    before = ring
    obstacles.push({ hit, perimeter, rounds: 1.5 })
    left = round.reduce((nearest, cell) => (far(cell) < far(nearest) ? cell : nearest))
    // Met on the way round, or nothing is nearer and the goal is unreachable.
    if (left === goal || left === hit) break
  }
  return boundOf(problem, obstacles)
}

/**
 * Bug2 with `closer`: D + ½ Σ nᵢ pᵢ, where nᵢ is how often the m-line enters or leaves obstacle i.
 *
 * It holds on the grid. Each hit point is further along the m-line than the one before, and where
 * the m-line is refused it enters an obstacle, which it must leave again, because the goal is free
 * (a diagonal step between two obstacle cells does both at once). So there are at most nᵢ / 2 hit
 * points on obstacle i, from each of which the rover walks at most once around, pᵢ steps; and each
 * step along the m-line is walked at most once, D steps.
 * @throws InputError that says what is wrong with the problem
 */
export function bug2Bound(problem: Problem): LengthBound {
  checkProblem(problem)
  const { grid, start, goal } = problem
  const legal = allLegalSteps(grid, problem.diagonal)
  const within = cellsJoinedTo(grid, start)
  const mLine = simplestPath(grid.width, start, goal)
  const shares = new Map<number, ObstacleShare>()
  for (const cell of mLine.subarray(0, -1)) {
    if (!within[cell] || !isRefused(problem, legal, cell)) continue
    const round = roundFrom(problem, cell, 'left')
    const ring = ringOf(grid, round)
    const { hit, rounds } = shares.get(ring) ?? { hit: cell, rounds: 0 }
    shares.set(ring, { hit, perimeter: round.length - 1, rounds: rounds + 1 })
  }
  return boundOf(problem, [...shares.values()])
}

function boundOf({ grid, start, goal }: Problem, obstacles: readonly ObstacleShare[]): LengthBound {
  const apart = distance(pointOf(grid.width, start), pointOf(grid.width, goal))
  const steps = obstacles.reduce((sum, { perimeter, rounds }) => sum + rounds * perimeter, apart)
  return { distance: apart, obstacles, steps }
}

/** Whether the next step of the simplest path from a free cell to the goal is illegal. */
function isRefused({ grid, goal }: Problem, legal: Uint8Array, cell: Cell): boolean {
  const ahead = simplestStep(pointOf(grid.width, cell), pointOf(grid.width, goal))
  return ((legal[cell] >> ahead) & 1) === 0
}

/** The first cell of the simplest path to the goal at which its next step is refused, or the goal. */
function firstRefusal(problem: Problem, legal: Uint8Array, from: Cell): Cell {
  const path = simplestPath(problem.grid.width, from, problem.goal)
  return path.find((cell) => cell === problem.goal || isRefused(problem, legal, cell)) ?? from
}

/** The cells once around the obstacle that refuses the step at `hit`, which is the first and the last. */
function roundFrom(problem: Problem, hit: Cell, turn: Turn): Int32Array {
  const rover = new SimulatedRover({ ...problem, start: hit }, { range: 1, lineOfSight: false })
  rover.sense()
  const refused = simplestStep(rover.position, rover.goal)
  const obstacle = obstacleInTheWay(rover.obstaclesAround(), refused)
  const walk = new BoundaryWalk(rover, obstacle, turn, new DriveNotes(rover))
  while (!walk.isBoxedIn && !walk.isAround) walk.step()
  return rover.trail()
}

/** A number that two rounds, walked the same way, have in common only if they are along one ring. */
function ringOf(grid: Grid, round: Int32Array): number {
  const offsets = stepOffsets(grid.width)
  let least = -1
  for (let i = 1; i < round.length; i++) {
    const step = 8 * round[i - 1] + offsets.indexOf(round[i] - round[i - 1])
    if (least < 0 || step < least) least = step
  }
  return least
}

/** Marks the cells that straight steps lead to. */
function cellsJoinedTo({ width, walls }: Grid, start: Cell): Uint8Array {
  const joined = new Uint8Array(walls.length)
  const waiting = [start]
  joined[start] = 1
  for (let cell = waiting.pop(); cell !== undefined; cell = waiting.pop()) {
    const x = cell % width
    const beside = [
      x > 0 ? cell - 1 : -1,
      x < width - 1 ? cell + 1 : -1,
      cell - width,
      cell + width,
    ]
    for (const next of beside) {
      if (next < 0 || next >= walls.length || walls[next] || joined[next]) continue
      joined[next] = 1
      waiting.push(next)
    }
  }
  return joined
}
