import { type Direction, DX, DY, directionOf, isDiagonal } from '../grid/directions'
import { isSamePlace, type Point, placeName } from '../grid/grid'
import { plural } from '../grid/plural'
import type { Directions } from '../grid/steps'
import type { DriveNotes } from '../rover/drive-notes'
import type { Rover } from '../rover/rover'
import type { ChoiceParam } from './params'
import type { DriveAnswer } from './planner'

/** On which side of the rover the obstacle stays. */
export type Turn = 'left' | 'right'

export const otherSide = (turn: Turn): Turn => (turn === 'left' ? 'right' : 'left')

/** The parameter of all planners that follow boundaries. */
export const turnParam = {
  name: 'turn',
  label: 'Turn',
  kind: 'choice',
  choices: ['left', 'right'],
  default: 'left',
  help: 'On which side the obstacle stays while its boundary is followed.',
} as const satisfies ChoiceParam<'turn', Turn>

export const isIn = (directions: Directions, d: Direction): boolean => ((directions >> d) & 1) === 1

/**
 * The obstacle that refuses a step: the cell it leads to or, for a diagonal step between
 * obstacles, one of the two beside it. Both belong to one obstacle, so it does not matter which.
 * -1 if none of them is an obstacle.
 */
export function obstacleInTheWay(obstacles: Directions, refused: Direction): Direction {
  const beside = isDiagonal(refused) ? [refused - 1, (refused + 1) & 7] : []
  return [refused, ...beside].find((d) => isIn(obstacles, d)) ?? -1
}

/**
 * Where to go around an obstacle cell that lies in direction `obstacle` (report, Figs. 8 and 9):
 * straight on past it, or around the corner that it forms.
 */
function stepPast(obstacle: Direction, turn: Turn): Direction {
  const quarter = isDiagonal(obstacle) ? 1 : 2
  return (obstacle + (turn === 'left' ? quarter : -quarter)) & 7
}

/**
 * The rover's walk along the boundary of an obstacle, the report's `circumnavigate` as a loop: an
 * obstacle cell among the 8 neighbours is kept at the rover's side, and where the way past it is
 * blocked, the blocking cell takes its place. All steps are straight.
 */
export class BoundaryWalk {
  /** Where the obstacle cell lies that the rover keeps at its side. */
  obstacle: Direction
  readonly #rover: Rover
  readonly #notes: DriveNotes
  readonly #turn: Turn
  readonly #taken: Direction[] = []
  #next: Direction
  readonly #start: Point

  constructor(rover: Rover, obstacle: Direction, turn: Turn, notes: DriveNotes) {
    this.#rover = rover
    this.#notes = notes
    this.#turn = turn
    this.obstacle = obstacle
    this.#start = rover.position
    this.#next = this.#look()
  }

  /** All four sides of the rover are blocked, so that no legal step leads away at all. */
  get isBoxedIn(): boolean {
    return this.#next < 0
  }

  /** Once around: the next step would be the first one again, from the same cell the same way. */
  get isAround(): boolean {
    return this.#next === this.#taken[0] && isSamePlace(this.#rover.position, this.#start)
  }

  /** The directions of the steps taken so far. */
  get taken(): readonly Direction[] {
    return this.#taken
  }

  /** Where the next step leads to; -1 if the rover is boxed in. */
  get next(): Direction {
    return this.#next
  }

  step(): void {
    const direction = this.#next
    const { obstacle } = this
    this.#rover.step(direction)
    this.#rover.sense()
    this.#taken.push(direction)
    this.obstacle = directionOf(DX[obstacle] - DX[direction], DY[obstacle] - DY[direction])
    this.#next = this.#look()
  }

  /** Turns past blocking cells until a free one is found; -1 after all four sides. */
  #look(): Direction {
    const obstacles = this.#rover.obstaclesAround()
    for (let tries = 0; tries < 5; tries++) {
      this.#notes.feel(this.obstacle)
      const past = stepPast(this.obstacle, this.#turn)
      if (!isIn(obstacles, past)) return past
      this.obstacle = past
    }
    return -1
  }
}

/** A step was refused: notes the hit point and begins to follow the obstacle that refused it. */
export function hitObstacle(
  rover: Rover,
  refused: Direction,
  turn: Turn,
  notes: DriveNotes,
): BoundaryWalk {
  const obstacle = obstacleInTheWay(rover.obstaclesAround(), refused)
  notes.hit(obstacle)
  notes.turn(turn)
  return new BoundaryWalk(rover, obstacle, turn, notes)
}

/** How a drive ends that cannot begin: all four sides of the rover are blocked. */
export function boxedIn(status: 'unreachable' | 'dead-end', place: Point): DriveAnswer {
  return { status, reason: `the rover is boxed in at ${placeName(place)}` }
}

/** When a state was there before. Not "at step 2": whoever plays a plan counts other steps, too. */
export const afterSteps = (steps: number): string => `after ${steps} ${plural(steps, 'step')}`
