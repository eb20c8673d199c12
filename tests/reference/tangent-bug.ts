import { boundarySteps, type Turn } from './boundary'
import { must } from './cases'
import { mustBeComplete, mustBeModest, mustNotExceed, mustWalkAlike, run } from './run'
import { tangentBugReport } from './tangent-bug-report'
import { freeCells, isNearer, steps, type World } from './world'

const RANGES = [1, 2, 3, 5]

/** The classic variant is complete for each range, whichever way it turns. */
export function classicMustHold(world: World, lineOfSight: boolean): void {
  for (const range of RANGES) {
    for (const turn of ['left', 'right'] as const) {
      const found = run(world, 'tangent-bug', { variant: 'classic', range, turn, lineOfSight })
      mustBeComplete(world, found)
      mustNotExceed(classicBound(world, turn, range), found)
    }
  }
}

/** The report's variant walks as described; it proves nothing, but ends. */
export function reportMustHold(world: World, lineOfSight: boolean): void {
  for (const range of RANGES) {
    const found = run(world, 'tangent-bug', { variant: 'report', range, lineOfSight })
    const { name, outcome, path } = found
    const expected = tangentBugReport(world, range, lineOfSight)
    mustWalkAlike(name, path, expected.path)
    must(outcome.status === expected.status, () => `${name}: ${outcome.status}`)
    mustBeModest(world, found)
    mustNotExceed(reportBound(world, range), found)
  }
}

/**
 * The bound of `classic`. Each target that is come to is nearer to the goal than all before it, so
 * there are no more than free cells nearer than the start. On the way to one, the distance rover →
 * target → goal shrinks with every step and with every change of the target; it begins with at most
 * the range and the start's distance. Between two targets at most one boundary is followed, once
 * around at most, and one more at the end.
 */
function classicBound(world: World, turn: Turn, range: number): number {
  const { start, goal } = world
  const nearer = freeCells(world).filter((cell) => isNearer(cell, start, goal)).length
  return nearer * (range + steps(start, goal)) + (nearer + 1) * boundarySteps(world, turn)
}

/**
 * The bound of `report`. It says `loop` when it is blocked at a place for the second time and sensed
 * nothing new in between. Only a cell where it was not before can show it anything new, so there are
 * no more stretches without news than free cells, and in each of them it is blocked at each free cell
 * at most once. Each time it approaches an end within range, goes once around at most, and follows a
 * simplest path until it is blocked again.
 */
function reportBound(world: World, range: number): number {
  const most = Math.max(world.width, world.height)
  const around = Math.max(boundarySteps(world, 'left'), boundarySteps(world, 'right'))
  return most + freeCells(world).length ** 2 * (range + around + most)
}
