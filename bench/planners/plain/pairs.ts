import type { Cell, Grid } from '../../../src/grid/grid'

/**
 * Whether each step of the simplest path (diagonal while both axes differ, then straight) is legal
 * under `only-when-no-obstacles`: walked cell by cell until a step is refused.
 */
export function walkIsFree({ width, walls }: Grid, from: Cell, to: Cell): boolean {
  const dx = (to % width) - (from % width)
  const dy = Math.floor(to / width) - Math.floor(from / width)
  const across = Math.sign(dx)
  const down = Math.sign(dy) * width
  let cell = from
  for (let left = Math.min(Math.abs(dx), Math.abs(dy)); left > 0; left--) {
    if (walls[cell + across] || walls[cell + down]) return false
    cell += across + down
    if (walls[cell]) return false
  }
  const straight = Math.abs(dx) > Math.abs(dy) ? across : down
  while (cell !== to) {
    cell += straight
    if (walls[cell]) return false
  }
  return true
}

/**
 * The edges of a roadmap by walking pairs: calls `edge` for each pair of vertices whose simplest
 * path is free in at least one direction. Of the vertices only every so many is joined with those
 * after it. Returns the part of all pairs that was walked.
 */
export function walkPairs(
  grid: Grid,
  vertices: ArrayLike<Cell>,
  every: number,
  edge: (from: Cell, to: Cell) => void,
): number {
  const count = vertices.length
  let walked = 0
  for (let i = 0; i < count; i += every) {
    for (let j = i + 1; j < count; j++) {
      const a = vertices[i]
      const b = vertices[j]
      if (walkIsFree(grid, a, b) || walkIsFree(grid, b, a)) edge(a, b)
    }
    walked += count - 1 - i
  }
  return walked / ((count * (count - 1)) / 2)
}
