import type { Direction } from '../grid/directions'
import type { Point } from '../grid/grid'
import type { Directions } from '../grid/steps'

export interface SensorSettings {
  /** The rover senses the square of this many cells around it (report, Fig. 10). */
  readonly range: number
  /** Whether obstacles hide what is behind them. */
  readonly lineOfSight: boolean
}

export type Knowledge = 'unknown' | 'free' | 'obstacle'

/**
 * All that an online planner is given. It knows where it is, where the goal is, and what it has
 * sensed; the map is out of its reach. Places are map coordinates; those outside the map are
 * obstacles once they are sensed.
 */
export interface Rover {
  readonly position: Point
  readonly goal: Point
  readonly range: number
  /** How many steps it has made. */
  readonly steps: number
  /** How many it had made when it last sensed something new; since then it knows the same. */
  readonly stepsAtNews: number
  /** Senses the square around the rover; without it a new place tells nothing. */
  sense(): void
  /** What has been sensed so far at a place. */
  known(x: number, y: number): Knowledge
  /** The directions in which an obstacle was sensed next to a place; its own if none is given. */
  obstaclesAround(place?: Point): Directions
  /** The steps from a place that are legal by what was sensed; what is unknown counts as obstacle. */
  legalSteps(place?: Point): Directions
  /** The steps from a place that sensed obstacles refuse; what is unknown refuses none. */
  refusedSteps(place: Point): Directions
  /** Moves one cell; an illegal step is refused: false, and the rover stays. */
  step(direction: Direction): boolean
}
