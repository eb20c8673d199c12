import { InputError } from '../grid/errors'
import { generators } from '../grid/generators'
import { type Cell, type Grid, pointOf } from '../grid/grid'
import type { Problem } from '../grid/problem'
import { MAX_SEED, randomInteger, randomNumbers } from '../grid/random'
import { distance } from '../grid/simplest-path'
import type { DiagonalRule } from '../grid/steps'
import { gridFromRows } from '../grid/text-map'
import { type ExperimentSettings, type MapKind, mapKinds } from './settings'

/** A map of an experiment, with start and goal: what all planners are run on. */
export interface TestMap {
  /** From 0; with the settings it is all that is needed to make the map again. */
  readonly number: number
  readonly kind: MapKind
  /** What the generator was given; for given maps what start and goal were drawn with. */
  readonly seed: number
  readonly problem: Problem
  /** Steps of the simplest path from start to goal. */
  readonly distance: number
  /** No two free cells at the least distance were found in so many tries; these are the farthest. */
  readonly tooNear: boolean
  /** The seed for planners in which chance plays a part. */
  readonly plannerSeed: number
}

/** How often start and goal are drawn before the farthest pair must do. */
const MOST_DRAWS = 1000

/**
 * Map number `number` of an experiment. Kinds of maps take turns, so that the first maps of an
 * experiment that is broken off, and each shard, have all kinds alike.
 * @param settings as `checkSettings` gave them
 * @param number from 0
 * @throws InputError if the number is not such a one
 */
export function testMap(settings: ExperimentSettings, number: number): TestMap {
  if (!Number.isSafeInteger(number) || number < 0) {
    throw new InputError(`The map's number is ${number}: it must be a whole number from 0.`)
  }
  const kinds = mapKinds(settings)
  const kind = kinds[number % kinds.length]
  const seed = derivedSeed(settings.seed, number)
  const grid = gridOf(kind, seed, settings.diagonal)
  const ends = drawEnds(grid, settings.leastDistance, randomNumbers(derivedSeed(seed, 1)))
  const { diagonal } = settings
  return {
    number,
    kind,
    seed,
    problem: { grid, start: ends.start, goal: ends.goal, diagonal },
    distance: ends.distance,
    tooNear: ends.distance < settings.leastDistance,
    plannerSeed: derivedSeed(seed, 2),
  }
}

/**
 * A seed from a seed and a number, so that neighbours have nothing to do with each other. Each use
 * of chance gets its own: with the map's, samples would fall by the numbers that made its obstacles.
 */
function derivedSeed(seed: number, number: number): number {
  const first = randomInteger(randomNumbers(number), 2 ** 32)
  return randomInteger(randomNumbers(seed ^ first), MAX_SEED + 1)
}

function gridOf(kind: MapKind, seed: number, diagonal: DiagonalRule): Grid {
  if (kind.given) return gridFromRows(kind.given.rows)
  const generator = generators.find(({ id }) => id === kind.family)
  if (!generator)
    throw new Error(`There is no generator ${kind.family}: these settings were not checked.`)
  return generator.generate(kind.size, kind.params, seed, diagonal).grid
}

interface Ends {
  readonly start: Cell
  readonly goal: Cell
  readonly distance: number
}

/** Two random free cells at least so far apart, or else the farthest pair of all that were drawn. */
function drawEnds({ width, walls }: Grid, least: number, random: () => number): Ends {
  const free: Cell[] = []
  for (let cell = 0; cell < walls.length; cell++) if (!walls[cell]) free.push(cell)
  let farthest: Ends = { start: free[0], goal: free[1], distance: 0 }
  for (let draw = 0; draw < MOST_DRAWS && farthest.distance < least; draw++) {
    const start = free[randomInteger(random, free.length)]
    const goal = free[randomInteger(random, free.length)]
    const apart = distance(pointOf(width, start), pointOf(width, goal))
    if (apart > farthest.distance) farthest = { start, goal, distance: apart }
  }
  return farthest
}
