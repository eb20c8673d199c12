import { generators } from '../../src/grid/generators'
import { type Cell, emptyGrid, type Grid, pointOf, type Size } from '../../src/grid/grid'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { distance } from '../../src/grid/simplest-path'
import { Flood } from './plain/flood'

export const RULE = 'only-when-no-obstacles'
export const MAP_KINDS = ['random', 'rooms', 'maze', 'open'] as const
/** Rooms and mazes as large maps have them; the generators' defaults suit a map of 60×40. */
export const WIDE_KINDS = ['large rooms', 'wide maze'] as const
export type MapKind = (typeof MAP_KINDS)[number] | (typeof WIDE_KINDS)[number]

export interface Query {
  readonly start: Cell
  readonly goal: Cell
}

/** A map with what is asked on it. */
export interface BenchMap {
  /** How lines of the bench name it: its kind and size, or its file. */
  readonly name: string
  /** All that is needed to make it again. */
  readonly origin: string
  readonly grid: Grid
  readonly queries: readonly Query[]
}

/** All else are the generators' own defaults. */
const DENSITY = 20
const LARGE_ROOM = 30
const WIDE_CORRIDOR = 8

/** Made anew each time it is asked for, so that maps that are done with can be forgotten. */
export function generatedMap(kind: MapKind, size: Size, seed: number, queries: number): BenchMap {
  const grid = gridOf(kind, size, seed)
  const random = randomNumbers(seed)
  return {
    name: `${kind} ${size.width}×${size.height}`,
    origin: `${kind} ${size.width}×${size.height}, seed ${seed}`,
    grid,
    queries: Array.from({ length: queries }, () => farApart(grid, random)),
  }
}

function gridOf(kind: MapKind, size: Size, seed: number): Grid {
  switch (kind) {
    case 'open':
      return emptyGrid(size.width, size.height)
    case 'random':
      return generated('random', size, seed, { density: DENSITY })
    case 'large rooms':
      return generated('rooms', size, seed, { room: LARGE_ROOM })
    case 'wide maze':
      return widened('maze', size, seed)
    default:
      return generated(kind, size, seed)
  }
}

function generated(
  id: string,
  size: Size,
  seed: number,
  params: Readonly<Record<string, number>> = {},
): Grid {
  const generator = generators.find((candidate) => candidate.id === id)
  if (!generator) throw new Error(`There is no generator ${id}.`)
  return generator.generate(size, params, seed, RULE).grid
}

/** A smaller map of which each cell is made a square. */
function widened(id: string, { width, height }: Size, seed: number): Grid {
  const share = (side: number) => Math.ceil(side / WIDE_CORRIDOR)
  const small = generated(id, { width: share(width), height: share(height) }, seed)
  const walls = Uint8Array.from({ length: width * height }, (_, cell) => {
    const x = Math.floor((cell % width) / WIDE_CORRIDOR)
    const y = Math.floor(Math.floor(cell / width) / WIDE_CORRIDOR)
    return small.walls[y * small.width + x]
  })
  return { width, height, walls }
}

/** Two random free cells joined by a path, at least three quarters of the longer side apart. */
function farApart(grid: Grid, random: () => number): Query {
  const { width, height, walls } = grid
  const least = 0.75 * Math.max(width, height)
  for (;;) {
    const start = randomInteger(random, walls.length)
    const goal = randomInteger(random, walls.length)
    if (walls[start] || walls[goal]) continue
    if (distance(pointOf(width, start), pointOf(width, goal)) < least) continue
    if (cellsAround(grid, start).includes(goal)) return { start, goal }
  }
}

/** All cells that can be reached from one, the farthest by straight steps last. */
function cellsAround(grid: Grid, start: Cell): Int32Array {
  const flood = new Flood(grid)
  return flood.reached(flood.run(start))
}

/** From one end of what can be reached from a cell to the other: hardly a cell is spared. */
export function acrossAll(grid: Grid, from: Cell): Query {
  const anywhere = cellsAround(grid, from)
  const start = anywhere[anywhere.length - 1]
  const cells = cellsAround(grid, start)
  return { start, goal: cells[cells.length - 1] }
}
