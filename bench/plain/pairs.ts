import type { Cell, Grid } from '../../src/grid/grid'

/**
 * Whether each step of the simplest path (diagonal while both axes differ, then straight) is legal
 * under `only-when-no-obstacles`: walked cell by cell until a step is refused.
 */
export function walkIsFree({ width, walls }: Grid, from: Cell, to: Cell): boolean {
  let x = from % width
  let y = (from - x) / width
  const goalX = to % width
  const goalY = (to - goalX) / width
  while (x !== goalX || y !== goalY) {
    const nextX = x + Math.sign(goalX - x)
    const nextY = y + Math.sign(goalY - y)
    if (walls[nextY * width + nextX]) return false
    // For a straight step these two are the cells that it joins, both free.
    if (walls[y * width + nextX] || walls[nextY * width + x]) return false
    x = nextX
    y = nextY
  }
  return true
}

/**
 * The edges of a roadmap by walking pairs: calls `edge` for each pair of vertices whose simplest
 * path is free in at least one direction. Of the pairs, only the given part is walked, spread evenly.
 */
export function walkPairs(
  grid: Grid,
  vertices: ArrayLike<Cell>,
  part: number,
  edge: (from: Cell, to: Cell) => void,
): void {
  let due = 0
  for (let i = 0; i < vertices.length; i++) {
    for (let j = i + 1; j < vertices.length; j++) {
      due += part
      if (due < 1) continue
      due--
      const a = vertices[i]
      const b = vertices[j]
      if (walkIsFree(grid, a, b) || walkIsFree(grid, b, a)) edge(a, b)
    }
  }
}
