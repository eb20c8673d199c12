import { isBoxedIn, obstacleInTheWay, onceAround, type Turn } from './boundary'
import type { Walk } from './bug1'
import { isSame, isWall, simplest, type World, type XY } from './world'

/**
 * Bug2 from its description: along the simplest path from start to goal, and where it is blocked
 * along the boundary until that path is met again.
 */
export function bug2(world: World, turn: Turn, leave: 'report' | 'closer'): Walk {
  const mLine = simplest(world.start, world.goal)
  const path: XY[] = [world.start]
  const hits: XY[] = []
  const leaves: XY[] = []
  let i = 0
  while (i < mLine.length - 1) {
    const obstacle = obstacleInTheWay(world, mLine[i], mLine[i + 1])
    if (!obstacle) {
      path.push(mLine[++i])
      continue
    }
    if (hits.some((hit) => isSame(hit, mLine[i]))) return { status: 'loop', path, hits, leaves }
    hits.push(mLine[i])
    const stuck = leave === 'closer' ? 'unreachable' : 'loop'
    if (isBoxedIn(world, mLine[i])) {
      return { status: leave === 'closer' ? 'unreachable' : 'dead-end', path, hits, leaves }
    }
    const placeOnLine = (place: XY) => mLine.findIndex((cell) => isSame(cell, place))
    const isLeavePoint = (place: XY) =>
      leave === 'closer' ? placeOnLine(place) > i : ![-1, i].includes(placeOnLine(place))
    const lap = onceAround(world, { at: mLine[i], obstacle }, turn, isLeavePoint)
    path.push(...lap.slice(1))
    const end = path[path.length - 1]
    if (!isLeavePoint(end)) return { status: stuck, path, hits, leaves }
    i = placeOnLine(end)
    if (i < mLine.length - 1) leaves.push(end)
  }
  return { status: 'reached', path, hits, leaves }
}

/**
 * The bound. With `closer` the rover stops at each cell of the m-line at most once, goes at most
 * once around from there, and comes to each of its cells along the line at most once. With `report`
 * it stops at a cell for the second time only to say `loop`, and each part of the way along the
 * line that begins where it leaves a boundary may be the whole line again.
 */
export function bug2Bound(world: World, turn: Turn, leave: 'report' | 'closer'): number {
  const mLine = simplest(world.start, world.goal)
  let bound = mLine.length - 1
  for (let i = 0; i < mLine.length - 1; i++) {
    const obstacle = obstacleInTheWay(world, mLine[i], mLine[i + 1])
    if (!obstacle || isWall(world, ...mLine[i]) || isBoxedIn(world, mLine[i])) continue
    const hit = { at: mLine[i], obstacle }
    bound += onceAround(world, hit, turn, () => false).length - 1
    if (leave === 'report') bound += mLine.length - 1
  }
  return bound
}
