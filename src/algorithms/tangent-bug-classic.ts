import { type Direction, DX, DY, stepped } from '../grid/directions'
import { isSamePlace, type Point, placeName } from '../grid/grid'
import { distance, farness, placeOnSimplestPath, simplestStep } from '../grid/simplest-path'
import type { DriveNotes } from '../rover/drive-notes'
import type { Rover } from '../rover/rover'
import { boxedIn, hitObstacle, isIn, type Turn } from './boundary'
import type { DriveAnswer } from './planner'
import { freeSteps, SensedSquare, shorter, type Visit, type Way, wayOver } from './sensed-square'
import { D_FOLLOWED, D_REACH, line } from './tangent-bug-lines'

/**
 * Tangent Bug as its authors have it, carried over to the grid; "nearer" is by `farness`.
 *
 * It ends: every target is nearer to the goal than all targets reached before it, and only given up
 * for one with a shorter way, and each boundary is left for a place nearer than d_followed, which is
 * nearer than the hit point (the cell that refuses a step of the simplest path always is).
 *
 * It is complete, for every range: let q be the cell of the followed obstacle nearest to the goal.
 * The simplest path from q to the goal only meets nearer cells, so it does not meet this obstacle
 * again, nor does it pass between two of its cells, because these would be nearer too. So if the
 * goal can be reached, its first cell p is free and on the boundary that the rover follows. There,
 * at the latest, d_reach is less than d_followed, because p is nearer than q.
 */
export function driveClassic(rover: Rover, turn: Turn, notes: DriveNotes): DriveAnswer {
  const { goal } = rover
  const square = new SensedSquare(rover)
  const isAtGoal = () => isSamePlace(rover.position, goal)
  const far = (place: Point) => farness(place, goal)
  const goTowards = (place: Point) => {
    rover.step(simplestStep(rover.position, place))
    rover.sense()
  }
  /** The farness that the next target must be below. */
  let bound = far(rover.position)
  let target: Point | undefined
  rover.sense()
  while (!isAtGoal()) {
    if (target && isSamePlace(rover.position, target)) {
      bound = far(target)
      target = undefined
    }
    const nodes = tangentGraph(rover, square)
    notes.at(line.nodes).nodes(nodes)
    const node = bestBelow(bound, nodes, goal)
    if (node && (!target || node.steps < wayOver(rover, target).steps)) {
      target = node.place
      notes.at(line.target).target(target, node.steps)
    }
    // Nothing to steer for, but the way is free: the simplest path gets nearer as well.
    const ahead = simplestStep(rover.position, goal)
    if (!target && isIn(rover.legalSteps(), ahead)) {
      target = stepped(rover.position, ahead)
      notes.at(line.ahead).target(target, distance(rover.position, goal))
    }
    if (target) {
      notes.at(line.towards)
      goTowards(target)
      continue
    }

    const hitPoint = rover.position
    const walk = hitObstacle(rover, ahead, turn, notes.at(line.hit))
    if (walk.isBoxedIn) return boxedIn('unreachable', hitPoint)
    let followed = stepped(rover.position, walk.obstacle)
    for (;;) {
      const obstacle = stepped(rover.position, walk.obstacle)
      followed = nearest(followed, far, (visit) => square.obstacle(obstacle, visit))
      const reach = nearest(rover.position, far, (visit) => square.placesInReach(visit))
      // They belong to the hit or the step before, whose line stays the present one.
      notes.value(D_REACH, distance(reach, goal))
      notes.value(D_FOLLOWED, distance(followed, goal))
      if (far(reach) < far(followed)) {
        notes.at(line.leave).leave('place-in-reach')
        bound = far(followed)
        target = reach
        notes.target(reach, wayOver(rover, reach).steps)
        break
      }
      if (walk.isAround) {
        notes.at(line.unreachable).around(walk.taken.length)
        const reason = `went round the obstacle once from hit point ${placeName(hitPoint)} without seeing a place nearer to the goal`
        return { status: 'unreachable', reason }
      }
      notes.at(line.around)
      walk.step()
    }
  }
  notes.at(line.reached)
  return { status: 'reached', reason: 'the rover is at the goal' }
}

/** The place that is least far of a first one and all others; among equals the first. */
function nearest(
  first: Point,
  far: (place: Point) => number,
  visitOthers: (visit: Visit) => void,
): Point {
  let best = first
  let least = far(first)
  visitOthers((place) => {
    const farness = far(place)
    if (farness >= least) return
    least = farness
    best = { ...place }
  })
  return best
}

/** The local tangent graph: the free way to the goal, and the ends of obstacles in reach. */
function tangentGraph(rover: Rover, square: SensedSquare): Way[] {
  const places = freeWayToGoal(rover)
  const [onTheWay] = places
  square.placesInReach((place) => {
    // Where the free way leaves the square may be an end as well.
    if (onTheWay && isSamePlace(onTheWay, place)) return
    if (isEnd(rover, place)) places.push({ ...place })
  })
  return places.map((place) => wayOver(rover, place))
}

/** The node with the least way over it, of those that are nearer to the goal than the bound. */
function bestBelow(bound: number, nodes: readonly Way[], goal: Point): Way | undefined {
  return nodes
    .filter(({ place }) => farness(place, goal) < bound)
    .reduce<Way | undefined>((best, way) => (best ? shorter(best, way) : way), undefined)
}

/** Where the simplest path to the goal leaves the sensed square, or the goal; none if it is blocked. */
function freeWayToGoal(rover: Rover): Point[] {
  const { position, goal, range } = rover
  const steps = Math.min(range, distance(position, goal))
  const isFree = freeSteps(rover, goal, steps) === steps
  return isFree ? [placeOnSimplestPath(position, goal, steps)] : []
}

/**
 * Where a sensed obstacle ends: at its corners, and at the rim of the sensed square, where its
 * boundary leads on out of sight.
 */
function isEnd(rover: Rover, place: Point): boolean {
  const obstacles = rover.obstaclesAround(place)
  if (obstacles === 0) return false
  if (distance(rover.position, place) === rover.range) return true
  const isFree = (d: Direction) => rover.known(place.x + DX[d], place.y + DY[d]) === 'free'
  for (let d = 1; d < 8; d += 2) {
    if (isIn(obstacles, d) && isFree(d - 1) && isFree((d + 1) & 7)) return true
  }
  return false
}
