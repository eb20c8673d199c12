import { DX, DY, stepped } from '../grid/directions'
import { isSamePlace, type Point, placeName } from '../grid/grid'
import { distance, placeOnSimplestPath, simplestStep } from '../grid/simplest-path'
import { DriveNotes } from '../rover/drive-notes'
import type { Rover } from '../rover/rover'
import { afterSteps, BoundaryWalk, boxedIn, isIn, obstacleInTheWay, type Turn } from './boundary'
import type { DriveAnswer } from './planner'
import { freeSteps, SensedSquare, shorter, type Way, wayOver } from './sensed-square'
import { D_FOLLOWED, D_REACH, line } from './tangent-bug-lines'

/** The report's Algorithms 3 and 4. */
export function driveAsInReport(rover: Rover, notes: DriveNotes): DriveAnswer {
  const { goal } = rover
  const square = new SensedSquare(rover)
  const isAtGoal = () => isSamePlace(rover.position, goal)
  const go = (direction: number) => {
    rover.step(direction)
    rover.sense()
  }
  const stepsWhenBlocked = new Map<string, number>()
  rover.sense()
  while (!isAtGoal()) {
    notes.at(line.follow)
    const blocking = obstacleWithinRange(rover)
    if (!blocking) {
      go(simplestStep(rover.position, goal))
      continue
    }
    const here = placeName(rover.position)
    const before = stepsWhenBlocked.get(here)
    // What was sensed long ago tells where obstacles end, so with news the rover may head elsewhere.
    if (before !== undefined && rover.stepsAtNews <= before) {
      notes.at(line.loop).loop(before)
      const reason = `blocked at ${here} again, in the same state as ${afterSteps(before)}`
      return { status: 'loop', reason }
    }
    stepsWhenBlocked.set(here, rover.steps)

    const ends = endsInReach(rover, square, blocking)
    const end = ends.reduce(shorter)
    notes.at(line.end).nodes(ends)
    notes.target(end.place, end.steps)
    notes.at(line.approach)
    while (distance(rover.position, end.place) > 1 && !isAtGoal()) {
      go(simplestStep(rover.position, end.place))
    }
    if (isAtGoal()) break

    const towards = simplestStep(rover.position, end.place)
    notes.at(line.turn).hit(towards)
    const turn = betterTurn(rover, towards)
    notes.turn(turn)
    const walk = new BoundaryWalk(rover, towards, turn, notes)
    const noteDistances = () => {
      notes.value(D_REACH, distance(rover.position, goal))
      notes.value(D_FOLLOWED, distance(stepped(rover.position, walk.obstacle), goal))
    }
    noteDistances()
    if (walk.isBoxedIn) return boxedIn('dead-end', rover.position)
    notes.at(line.followBoundary)
    do {
      if (walk.isAround) {
        notes.at(line.closed).around(walk.taken.length)
        notes.loop(rover.steps - walk.taken.length)
        const reason = `went round the obstacle once, so the state ${afterSteps(rover.steps - walk.taken.length)} came back`
        return { status: 'loop', reason }
      }
      walk.step()
      noteDistances()
    } while (!isAtGoal() && !mayLeave(rover, walk))
    if (!isAtGoal()) notes.at(line.depart).leave('free-step')
  }
  notes.at(line.reached)
  return { status: 'reached', reason: 'the rover is at the goal' }
}

/** An obstacle cell that refuses a step of the simplest path to the goal within range, if any. */
function obstacleWithinRange(rover: Rover): Point | undefined {
  const { goal, range } = rover
  const free = freeSteps(rover, goal, range)
  if (free === Math.min(range, distance(rover.position, goal))) return undefined
  const place = placeOnSimplestPath(rover.position, goal, free)
  const ahead = simplestStep(place, goal)
  // Maybe it is only not known to be legal, because of cells out of sight: that is no obstacle yet.
  if (!isIn(rover.refusedSteps(place), ahead)) return undefined
  return stepped(place, obstacleInTheWay(rover.obstaclesAround(place), ahead))
}

/**
 * The ends of the sensed obstacle (points of discontinuity) that can be approached: cells with at
 * most one sensed obstacle cell on their four sides, or those with the fewest if there is none.
 */
function endsInReach(rover: Rover, square: SensedSquare, blocking: Point): Way[] {
  const cells: Point[] = []
  square.obstacle(blocking, (cell) => {
    if (freeSteps(rover, cell) >= distance(rover.position, cell) - 1) cells.push({ ...cell })
  })
  const counts = cells.map((cell) => obstaclesOnSides(rover, cell))
  const limit = Math.max(1, Math.min(...counts))
  const ends = cells.filter((_, i) => counts[i] <= limit)
  return ends.map((end) => wayOver(rover, end))
}

function obstaclesOnSides(rover: Rover, { x, y }: Point): number {
  let count = 0
  for (let d = 0; d < 8; d += 2) if (rover.known(x + DX[d], y + DY[d]) === 'obstacle') count++
  return count
}

/** The side whose first step is nearer to the goal; right if both are equal, as Fig. 14 needs it. */
function betterTurn(rover: Rover, obstacle: number): Turn {
  const unnoted = new DriveNotes(rover)
  const after = (turn: Turn) => {
    const { next } = new BoundaryWalk(rover, obstacle, turn, unnoted)
    return distance(stepped(rover.position, next), rover.goal)
  }
  return after('left') < after('right') ? 'left' : 'right'
}

function mayLeave(rover: Rover, walk: BoundaryWalk): boolean {
  const { position, goal } = rover
  const isFree = isIn(rover.legalSteps(), simplestStep(position, goal))
  return isFree && distance(position, goal) <= distance(stepped(position, walk.obstacle), goal)
}
