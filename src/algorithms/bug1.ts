import { type Direction, opposite } from '../grid/directions'
import { isSamePlace, placeName } from '../grid/grid'
import { distance, farness, simplestStep } from '../grid/simplest-path'
import { boxedIn, hitObstacle, otherSide, turnParam } from './boundary'
import { onlinePlanner } from './planner'
import { pseudocode } from './pseudocode'

const { text, line } = pseudocode({
  follow: 'follow the simplest path to the goal',
  hit: 'if an obstacle refuses a step: here is a hit point',
  around:
    'go around the obstacle once in full, computing at each step the distance to the goal (if equal, the Euclidean one)',
  unreachable: 'if no cell was nearer to the goal than the hit point: the goal is unreachable',
  back: 'return along the boundary, the shorter way, to the cell nearest to the goal',
  leave: 'leave there and start over',
  reached: 'as soon as the goal is met: done',
})

const HERE = 0
const NEAREST = 1

export const bug1 = onlinePlanner({
  id: 'bug1',
  title: 'Bug1',
  summary:
    'Heads for the goal; goes around each obstacle once in full, returns to the cell nearest to the goal and goes on from there.',
  promise: 'Complete: it arrives whenever there is a path, and else proves that there is none.',
  complete: () => true,
  optimal: () => false,
  params: [turnParam],
  variables: ['distance to the goal', 'least distance on this boundary'],
  pseudocode: text,
  source:
    'Report, IV.E.1 and Algorithm 1; V. J. Lumelsky and A. A. Stepanov, "Path-planning strategies for a point mobile automaton moving amidst unknown obstacles of arbitrary shape", 1987',
  sensor: () => ({ range: 1, lineOfSight: false }),

  drive(rover, { params, notes }) {
    const { goal } = rover
    const isAtGoal = () => isSamePlace(rover.position, goal)
    rover.sense()
    while (!isAtGoal()) {
      const ahead = simplestStep(rover.position, goal)
      notes.at(line.follow)
      if (rover.step(ahead)) {
        rover.sense()
        notes.value(HERE, distance(rover.position, goal))
        continue
      }
      const hitPoint = rover.position
      const walk = hitObstacle(rover, ahead, params.turn, notes.at(line.hit))
      notes.value(HERE, distance(hitPoint, goal))
      notes.value(NEAREST, distance(hitPoint, goal))
      if (walk.isBoxedIn) return boxedIn('unreachable', hitPoint)
      let nearest = hitPoint
      let firstMet = 0
      let lastMet = 0
      notes.at(line.around)
      while (!walk.isAround && !isAtGoal()) {
        walk.step()
        if (farness(rover.position, goal) < farness(nearest, goal)) {
          nearest = rover.position
          firstMet = walk.taken.length
        }
        if (isSamePlace(rover.position, nearest)) lastMet = walk.taken.length
        notes.value(HERE, distance(rover.position, goal))
        notes.value(NEAREST, distance(nearest, goal))
      }
      if (isAtGoal()) break
      notes.around(walk.taken.length)
      if (nearest === hitPoint) {
        notes.at(line.unreachable)
        const reason = `went round the obstacle once, and nowhere was nearer to the goal than hit point ${placeName(hitPoint)}`
        return { status: 'unreachable', reason }
      }
      notes.at(line.back).target(nearest, distance(nearest, goal))
      const { directions, isBackwards } = shorterWay(walk.taken, firstMet, lastMet)
      for (const direction of directions) {
        rover.step(direction)
        rover.sense()
        if (isBackwards) notes.turn(otherSide(params.turn))
        notes.value(HERE, distance(rover.position, goal))
      }
      notes.at(line.leave).leave('nearest')
    }
    notes.at(line.reached)
    return { status: 'reached', reason: 'the rover is at the goal' }
  },
})

/**
 * From the end of a closed walk, which is its start, to a place on it: onwards to where it was first
 * met, or backwards, with the obstacle on the other side, to where it was last met.
 */
function shorterWay(
  taken: readonly Direction[],
  firstMet: number,
  lastMet: number,
): { readonly directions: readonly Direction[]; readonly isBackwards: boolean } {
  const isBackwards = firstMet > taken.length - lastMet
  const directions = isBackwards
    ? taken.slice(lastMet).reverse().map(opposite)
    : taken.slice(0, firstMet)
  return { directions, isBackwards }
}
