import { directionOf, stepOffsets } from '../grid/directions'
import type { Cell } from '../grid/grid'
import type { Cells } from '../trace/frame'

/** East to south-west: a line in any of the other directions is one of these from its other end. */
const ONWARD = [2, 3, 4, 5] as const

/**
 * All that a roadmap's edges cover, as straight lines that do not overlap: pairs of cells. An edge
 * is the simplest path from its first cell to its second, so it lies on the lines between the
 * cells' centres, and thousands of edges share few of these.
 * @param edges pairs of cells, one after the other
 */
export function edgeLines(columns: number, rows: number, edges: Cells): Cell[] {
  if (edges.length === 0) return []
  // For each direction and cell: how many edges begin there, less those that end.
  const changes = ONWARD.map(() => new Int32Array(columns * rows))
  const add = (from: Cell, to: Cell) => {
    const dx = (to % columns) - (from % columns)
    const dy = Math.floor(to / columns) - Math.floor(from / columns)
    const direction = directionOf(dx, dy)
    if (direction < 0) return
    const isOnward = direction >= 2 && direction <= 5
    const change = changes[(isOnward ? direction : direction ^ 4) - 2]
    change[isOnward ? from : to]++
    change[isOnward ? to : from]--
  }
  for (let i = 0; i + 1 < edges.length; i += 2) {
    const bend = bendOf(columns, edges[i], edges[i + 1])
    add(edges[i], bend)
    add(bend, edges[i + 1])
  }
  const offsets = stepOffsets(columns)
  const lines: Cell[] = []
  ONWARD.forEach((direction, i) => {
    collectRuns(changes[i], offsets[direction], lines)
  })
  return lines
}

/** Where the simplest path between two cells stops being diagonal. */
function bendOf(columns: number, from: Cell, to: Cell): Cell {
  const dx = (to % columns) - (from % columns)
  const dy = Math.floor(to / columns) - Math.floor(from / columns)
  const diagonal = Math.min(Math.abs(dx), Math.abs(dy))
  return from + diagonal * (Math.sign(dy) * columns + Math.sign(dx))
}

/** Adds each run of cells that something covers, and takes it out of `changes`. */
function collectRuns(changes: Int32Array, offset: number, lines: Cell[]): void {
  for (let cell = 0; cell < changes.length; cell++) {
    let covering = changes[cell]
    if (covering === 0) continue
    changes[cell] = 0
    let end = cell
    while (covering > 0) {
      end += offset
      covering += changes[end]
      changes[end] = 0
    }
    lines.push(cell, end)
  }
}
