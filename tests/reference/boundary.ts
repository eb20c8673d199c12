import { freeCells, isLegal, isWall, type World, type XY } from './world'

/** Which side the obstacle stays on. */
export type Turn = 'left' | 'right'

/** Where the rover is and the obstacle cell that it keeps among its neighbours. */
export interface Follower {
  readonly at: XY
  readonly obstacle: XY
}

/** The next step by where the obstacle cell lies, for the obstacle on the left (Fig. 8). */
const ON_THE_LEFT: Readonly<Record<string, XY>> = {
  '0,-1': [1, 0],
  '-1,-1': [0, -1],
  '-1,0': [0, -1],
  '-1,1': [-1, 0],
  '0,1': [-1, 0],
  '1,1': [0, 1],
  '1,0': [0, 1],
  '1,-1': [1, 0],
}

/** The step by the table; for the obstacle on the right the mirror image, left for right. */
function stepBeside(dx: number, dy: number, turn: Turn): XY {
  if (turn === 'left') return ON_THE_LEFT[`${dx},${dy}`]
  const [mx, my] = ON_THE_LEFT[`${-dx},${dy}`]
  return [-mx, my]
}

/** All four sides blocked. */
export function isBoxedIn(world: World, [x, y]: XY): boolean {
  return (
    isWall(world, x + 1, y) &&
    isWall(world, x - 1, y) &&
    isWall(world, x, y + 1) &&
    isWall(world, x, y - 1)
  )
}

/** The place after the next step along the boundary. Not for a rover that is boxed in. */
export function followOn(world: World, { at, obstacle }: Follower, turn: Turn): Follower {
  let beside = obstacle
  for (;;) {
    const [dx, dy] = stepBeside(beside[0] - at[0], beside[1] - at[1], turn)
    const next: XY = [at[0] + dx, at[1] + dy]
    if (!isWall(world, next[0], next[1])) return { at: next, obstacle: beside }
    beside = next
  }
}

/** The obstacle cell that refuses a step; undefined if the step is legal. */
export function obstacleInTheWay(world: World, from: XY, to: XY): XY | undefined {
  if (isLegal(world, from, to)) return undefined
  if (isWall(world, to[0], to[1])) return to
  const beside: XY = [to[0], from[1]]
  return isWall(world, beside[0], beside[1]) ? beside : [from[0], to[1]]
}

/**
 * Once around: the places from a hit point until the first directed step would come back, which is
 * at the hit point again. Stops early at the first place where `until` says so.
 */
export function onceAround(
  world: World,
  hit: Follower,
  turn: Turn,
  until: (place: XY) => boolean,
): XY[] {
  const places: XY[] = [hit.at]
  const first = followOn(world, hit, turn).at
  let follower = hit
  for (;;) {
    const next = followOn(world, follower, turn)
    const isFirst = String(follower.at) === String(hit.at) && String(next.at) === String(first)
    if (places.length > 1 && isFirst) return places
    follower = next
    places.push(next.at)
    if (until(next.at)) return places
  }
}

/**
 * How many directed steps boundaries have: straight steps between free cells with an obstacle on
 * the boundary's side, or at that side ahead around a corner. No walk along boundaries has others.
 */
export function boundarySteps(world: World, turn: Turn): number {
  let count = 0
  for (const [x, y] of freeCells(world)) {
    for (const [dx, dy] of [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ]) {
      const [sx, sy] = turn === 'left' ? [dy, -dx] : [-dy, dx]
      const touches = isWall(world, x + sx, y + sy) || isWall(world, x + dx + sx, y + dy + sy)
      if (!isWall(world, x + dx, y + dy) && touches) count++
    }
  }
  return count
}
