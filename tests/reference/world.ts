import type { Problem } from '../../src/index'

/**
 * The world once more, in the plainest words: the tests' own idea of what is free and which step
 * is legal. Nothing here calls the code under test.
 */
export interface World {
  readonly width: number
  readonly height: number
  /** Row by row, `#` for an obstacle. */
  readonly rows: readonly string[]
  readonly start: XY
  readonly goal: XY
  readonly rule: Rule
}

export type XY = readonly [x: number, y: number]
export type Rule = Problem['diagonal']
export const RULES: readonly Rule[] = ['if-at-most-one-obstacle', 'only-when-no-obstacles']

/** The steps to the neighbours of a cell, clockwise from north. */
export const DIRECTIONS: readonly XY[] = [
  [0, -1],
  [1, -1],
  [1, 0],
  [1, 1],
  [0, 1],
  [-1, 1],
  [-1, 0],
  [-1, -1],
]

export const isSame = (a: XY, b: XY): boolean => a[0] === b[0] && a[1] === b[1]

export function isWall(world: World, x: number, y: number): boolean {
  if (x < 0 || y < 0 || x >= world.width || y >= world.height) return true
  return world.rows[y][x] === '#'
}

/** Whether the step from one free cell to another cell is legal. */
export function isLegal(world: World, [x, y]: XY, [nx, ny]: XY): boolean {
  const dx = nx - x
  const dy = ny - y
  if (Math.max(Math.abs(dx), Math.abs(dy)) !== 1) return false
  if (isWall(world, nx, ny)) return false
  if (dx === 0 || dy === 0) return true
  const one = isWall(world, x + dx, y)
  const other = isWall(world, x, y + dy)
  return world.rule === 'if-at-most-one-obstacle' ? !(one && other) : !one && !other
}

/** The neighbours that a legal step leads to. */
export function legalNeighbours(world: World, [x, y]: XY): XY[] {
  const found: XY[] = []
  for (let ny = y - 1; ny <= y + 1; ny++) {
    for (let nx = x - 1; nx <= x + 1; nx++) {
      if (isLegal(world, [x, y], [nx, ny])) found.push([nx, ny])
    }
  }
  return found
}

export function freeCells(world: World): XY[] {
  const cells: XY[] = []
  for (let y = 0; y < world.height; y++) {
    for (let x = 0; x < world.width; x++) if (!isWall(world, x, y)) cells.push([x, y])
  }
  return cells
}

/** The cells that straight steps lead to from the start; a goal among them is reachable. */
export function flood(world: World): Set<string> {
  const reached = new Set([String(world.start)])
  const waiting: XY[] = [world.start]
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const [x, y] = next
    const beside: XY[] = [
      [x + 1, y],
      [x - 1, y],
      [x, y + 1],
      [x, y - 1],
    ]
    for (const cell of beside) {
      if (isWall(world, cell[0], cell[1]) || reached.has(String(cell))) continue
      reached.add(String(cell))
      waiting.push(cell)
    }
  }
  return reached
}

const reachable = new WeakMap<World, boolean>()

/** Whether there is any way to the goal. Remembered, because it is asked for every run. */
export function isReachable(world: World): boolean {
  const known = reachable.get(world) ?? flood(world).has(String(world.goal))
  reachable.set(world, known)
  return known
}

/** "The distance": the number of steps of the simplest path. */
export function steps(a: XY, b: XY): number {
  return Math.max(Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]))
}

/** Whether `a` is nearer to `to` than `b`: fewer steps, or as many and less Euclidean distance. */
export function isNearer(a: XY, b: XY, to: XY): boolean {
  const square = (p: XY) => (p[0] - to[0]) ** 2 + (p[1] - to[1]) ** 2
  return steps(a, to) < steps(b, to) || (steps(a, to) === steps(b, to) && square(a) < square(b))
}

/** The simplest path, both ends included: diagonal while both axes differ, then straight. */
export function simplest(from: XY, to: XY): XY[] {
  const path: XY[] = [from]
  let [x, y] = from
  while (x !== to[0] || y !== to[1]) {
    if (x < to[0]) x++
    else if (x > to[0]) x--
    if (y < to[1]) y++
    else if (y > to[1]) y--
    path.push([x, y])
  }
  return path
}

/** Whether every step of a path is legal, and its first cell is free. */
export function isFree(world: World, path: readonly XY[]): boolean {
  if (isWall(world, path[0][0], path[0][1])) return false
  for (let i = 1; i < path.length; i++) if (!isLegal(world, path[i - 1], path[i])) return false
  return true
}

export function problemOf(world: World): Problem {
  const { width, height, rule } = world
  const walls = new Uint8Array(width * height)
  for (let i = 0; i < walls.length; i++) {
    walls[i] = world.rows[Math.floor(i / width)][i % width] === '#' ? 1 : 0
  }
  const cell = ([x, y]: XY) => y * width + x
  return {
    grid: { width, height, walls },
    start: cell(world.start),
    goal: cell(world.goal),
    diagonal: rule,
  }
}

/** The cells of a planner's path as places. */
export function placesOf(world: World, cells: Iterable<number>): XY[] {
  return Array.from(cells, (cell): XY => [cell % world.width, Math.floor(cell / world.width)])
}

/** The map as text, `S` start, `G` goal, `*` both at once. */
export function textOf({ rows, start, goal, rule }: World): string {
  const signs = rows.map((row) => [...row])
  signs[start[1]][start[0]] = 'S'
  signs[goal[1]][goal[0]] = isSame(start, goal) ? '*' : 'G'
  return `${rule}\n${signs.map((row) => row.join('')).join('\n')}`
}
