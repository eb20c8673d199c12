import { isBoxedIn, obstacleInTheWay, onceAround, type Turn } from './boundary'
import { isNearer, isSame, simplest, type World, type XY } from './world'

export interface Walk {
  readonly status: 'reached' | 'unreachable' | 'loop' | 'dead-end'
  readonly path: readonly XY[]
  /** Where it met obstacles, and where it left them again. */
  readonly hits: readonly XY[]
  readonly leaves: readonly XY[]
}

/**
 * Bug1 from its description: towards the goal, once around what is in the way, back by the shorter
 * way to the nearest place, and on. Where the description leaves a choice: of equally near places
 * the first that was met, of two equally long ways back the one onward.
 */
export function bug1(world: World, turn: Turn): Walk {
  const { goal } = world
  const path: XY[] = [world.start]
  const hits: XY[] = []
  const leaves: XY[] = []
  for (;;) {
    let here = path[path.length - 1]
    if (isSame(here, goal)) return { status: 'reached', path, hits, leaves }
    const next = simplest(here, goal)[1]
    const obstacle = obstacleInTheWay(world, here, next)
    if (!obstacle) {
      path.push(next)
      continue
    }
    hits.push(here)
    if (isBoxedIn(world, here)) return { status: 'unreachable', path, hits, leaves }
    const lap = onceAround(world, { at: here, obstacle }, turn, (place) => isSame(place, goal))
    path.push(...lap.slice(1))
    here = path[path.length - 1]
    if (isSame(here, goal)) return { status: 'reached', path, hits, leaves }
    let nearest = lap[0]
    for (const place of lap) if (isNearer(place, nearest, goal)) nearest = place
    if (nearest === lap[0]) return { status: 'unreachable', path, hits, leaves }
    path.push(...shorterWay(lap, nearest))
    leaves.push(nearest)
  }
}

/** From the end of a lap to one of its places, onward along it again or back. */
function shorterWay(lap: readonly XY[], to: XY): XY[] {
  const onward = lap.findIndex((place) => isSame(place, to))
  const back = lap.findLastIndex((place) => isSame(place, to))
  return onward <= lap.length - 1 - back
    ? lap.slice(1, onward + 1)
    : lap.slice(back, lap.length - 1).reverse()
}
