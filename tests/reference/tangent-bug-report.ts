import { type Follower, followOn, isBoxedIn } from './boundary'
import type { Walk } from './bug1'
import { Sensed } from './sensed'
import { DIRECTIONS, isLegal, isSame, simplest, steps, type World, type XY } from './world'

type Drive = Pick<Walk, 'status' | 'path'>

/**
 * The report's Tangent Bug from its Algorithms 3 and 4. It goes round for ever once it is blocked at
 * a place where it was blocked before and knows no more than then: only with the same knowledge does
 * it choose the same end again.
 */
export function tangentBugReport(world: World, range: number, lineOfSight: boolean): Drive {
  const { start, goal } = world
  const path: XY[] = [start]
  const sensed = new Sensed(world, range, lineOfSight)
  let here = start
  const go = (place: XY) => {
    here = place
    path.push(place)
    sensed.lookFrom(place)
  }
  const states = new Set<string>()
  sensed.lookFrom(start)
  while (!isSame(here, goal)) {
    const blocking = blockingWithin(sensed, simplest(here, goal).slice(0, range + 1))
    if (!blocking) {
      go(simplest(here, goal)[1])
      continue
    }
    const state = `${here} ${sensed.count}`
    if (states.has(state)) return { status: 'loop', path }
    states.add(state)
    const end = bestEnd(sensed, here, goal, blocking)
    while (steps(here, end) > 1 && !isSame(here, goal)) go(simplest(here, end)[1])
    if (isSame(here, goal)) break
    if (isBoxedIn(world, here)) return { status: 'dead-end', path }
    if (!followUntilNearer(world, { at: here, obstacle: end }, go)) return { status: 'loop', path }
  }
  return { status: 'reached', path }
}

/** The sensed obstacle cell that refuses a step of a path, if what comes before is known to be free. */
function blockingWithin(sensed: Sensed, path: readonly XY[]): XY | undefined {
  for (let i = 1; i < path.length; i++) {
    const refusing = sensed.refusing(path[i - 1], path[i])
    if (refusing) return refusing
    if (!sensed.allows(path[i - 1], path[i])) return undefined
  }
  return undefined
}

/**
 * The end of the sensed obstacle in reach with the least distance rover, end, goal. Where the
 * description leaves a choice: of equal ones the first that is met from the blocking cell on.
 */
function bestEnd(sensed: Sensed, here: XY, goal: XY, blocking: XY): XY {
  const cells = sensed.obstacle(here, blocking).filter((cell) => {
    const path = simplest(here, cell)
    return path.slice(1, -1).every((place, i) => sensed.allows(path[i], place))
  })
  const onSides = ([x, y]: XY) =>
    DIRECTIONS.filter(([dx, dy]) => dx * dy === 0 && sensed.isObstacle([x + dx, y + dy])).length
  const most = Math.max(1, Math.min(...cells.map(onSides)))
  const over = (cell: XY) => steps(here, cell) + steps(cell, goal)
  const length = (cell: XY) => straight(here, cell) + straight(cell, goal)
  return cells
    .filter((cell) => onSides(cell) <= most)
    .reduce((best, cell) => {
      if (over(cell) !== over(best)) return over(cell) < over(best) ? cell : best
      return length(cell) < length(best) - 1e-9 ? cell : best
    })
}

const straight = (a: XY, b: XY): number => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2)

/** Follows the boundary until the rover may leave it; false if it came round. */
function followUntilNearer(world: World, hit: Follower, go: (place: XY) => void): boolean {
  const { goal } = world
  const first = (['left', 'right'] as const).map((turn) => followOn(world, hit, turn).at)
  const turn = steps(first[0], goal) < steps(first[1], goal) ? 'left' : 'right'
  const taken = new Set<string>()
  for (let follower = hit; ; ) {
    const next = followOn(world, follower, turn)
    const step = `${follower.at} ${next.at}`
    if (taken.has(step)) return false
    taken.add(step)
    go(next.at)
    follower = next
    if (isSame(next.at, goal)) return true
    const { obstacle } = followOn(world, follower, turn)
    const isFree = isLegal(world, next.at, simplest(next.at, goal)[1])
    if (isFree && steps(next.at, goal) <= steps(obstacle, goal)) return true
  }
}
