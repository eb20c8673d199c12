import { EVENT, type Tape } from '../../src/index'
import { type Follower, followOn, isBoxedIn, obstacleInTheWay, type Turn } from './boundary'
import { must } from './cases'
import { isFree, isNearer, isSame, isWall, placesOf, simplest, type World, type XY } from './world'

/** One boundary that was followed: the places from the hit point on, and whether it was left. */
interface Followed {
  readonly places: readonly XY[]
  readonly left: boolean
}

/** Each boundary that is followed on the tape is left where d_reach < d_followed, and not before. */
export function mustLeaveWhenNearer(
  name: string,
  world: World,
  tape: Tape,
  range: number,
  turn: Turn,
): void {
  for (const { places, left } of boundariesOn(world, tape)) {
    const expected = follow(world, places[0], range, turn)
    must(
      left === expected.left && String(places) === String(expected.places),
      () =>
        `${name}: follows ${places.join(' ')} ${left ? 'and leaves' : 'to the end'}, ` +
        `not ${expected.places.join(' ')} ${expected.left ? 'and leaves' : 'to the end'}`,
    )
  }
}

function boundariesOn(world: World, tape: Tape): Followed[] {
  const found: Followed[] = []
  let places: XY[] | undefined
  for (let i = 0; i < tape.length; i++) {
    const kind = tape.kind(i)
    const [cell] = placesOf(world, [tape.cell(i)])
    if (kind === EVENT.hit) places = [cell]
    else if (kind === EVENT.step) places?.push(cell)
    else if (kind === EVENT.leave && places) {
      found.push({ places, left: true })
      places = undefined
    }
  }
  if (places) found.push({ places, left: false })
  return found
}

/** From a hit point along the boundary until a place in reach is nearer than all of the obstacle. */
function follow(world: World, hit: XY, range: number, turn: Turn): Followed {
  const { goal } = world
  const obstacle = obstacleInTheWay(world, hit, simplest(hit, goal)[1])
  if (!obstacle) throw new Error(`nothing is in the way at the hit point ${hit}`)
  const places: XY[] = [hit]
  if (isBoxedIn(world, hit)) return { places, left: false }
  const first = followOn(world, { at: hit, obstacle }, turn).at
  let follower: Follower = { at: hit, obstacle }
  let nearestFollowed = obstacle
  for (;;) {
    // The obstacle cell at the rover's side is the one that it goes past next.
    const next = followOn(world, follower, turn)
    for (const cell of sensedObstacle(world, follower.at, next.obstacle, range)) {
      if (isNearer(cell, nearestFollowed, goal)) nearestFollowed = cell
    }
    const inReach = square(follower.at, range).some(
      (place) =>
        isNearer(place, nearestFollowed, goal) && isFree(world, simplest(follower.at, place)),
    )
    if (inReach) return { places, left: true }
    const around = isSame(follower.at, hit) && isSame(next.at, first) && places.length > 1
    if (around) return { places, left: false }
    follower = next
    places.push(next.at)
  }
}

function square([x, y]: XY, range: number): XY[] {
  const places: XY[] = []
  for (let py = y - range; py <= y + range; py++) {
    for (let px = x - range; px <= x + range; px++) places.push([px, py])
  }
  return places
}

/** The obstacle cells of the square that hang together with one of them, corners included. */
function sensedObstacle(world: World, at: XY, seed: XY, range: number): XY[] {
  const walls = square(at, range).filter(([x, y]) => isWall(world, x, y))
  const found: XY[] = [seed]
  const seen = new Set([String(seed)])
  for (const [x, y] of found) {
    for (const wall of walls) {
      const touches = Math.max(Math.abs(wall[0] - x), Math.abs(wall[1] - y)) === 1
      if (!touches || seen.has(String(wall))) continue
      seen.add(String(wall))
      found.push(wall)
    }
  }
  return found
}
