import type { Cell, Size } from '../grid'
import { randomInteger } from '../random'
import { generator } from './generator'

export const maze = generator({
  id: 'maze',
  title: 'Maze',
  help: 'Corridors one cell wide; without loops there is exactly one way between any two cells.',
  params: [
    {
      name: 'loops',
      label: 'Loops',
      kind: 'integer',
      min: 0,
      max: 100,
      default: 5,
      unit: '%',
      help: 'Share of the walls between corridors that are removed again, each one making a loop.',
    },
  ],

  build(size, { loops }, random) {
    const { width, height } = size
    const walls = new Uint8Array(width * height).fill(1)
    carve(size, walls, random)
    extendToBorder(size, walls)
    removeWalls(size, walls, loops / 100, random)
    return { walls, start: 0, goal: cornerCell(size, walls) }
  },
})

/**
 * Corridors join the cells with even x and y by a depth-first search that goes to a random
 * unvisited one two cells away, and back where there is none.
 */
function carve({ width, height }: Size, walls: Uint8Array, random: () => number): void {
  const right = width - 1 - ((width - 1) % 2)
  const bottom = height - 1 - ((height - 1) % 2)
  const trail = new Int32Array((right / 2 + 1) * (bottom / 2 + 1))
  const choices = new Int32Array(4)
  let length = 1
  walls[0] = 0
  while (length > 0) {
    const cell: Cell = trail[length - 1]
    const x = cell % width
    const y = (cell - x) / width
    let count = 0
    if (y > 0 && walls[cell - 2 * width]) choices[count++] = -width
    if (x < right && walls[cell + 2]) choices[count++] = 1
    if (y < bottom && walls[cell + 2 * width]) choices[count++] = width
    if (x > 0 && walls[cell - 2]) choices[count++] = -1
    if (count === 0) {
      length--
      continue
    }
    const step = choices[randomInteger(random, count)]
    walls[cell + step] = 0
    walls[cell + 2 * step] = 0
    trail[length++] = cell + 2 * step
  }
}

/** With an even side the last column or row lies beyond all corridors: each one grows into it. */
function extendToBorder({ width, height }: Size, walls: Uint8Array): void {
  if (width % 2 === 0) for (let y = 0; y < height; y += 2) walls[y * width + width - 1] = 0
  if (height % 2 === 0) for (let x = 0; x < width; x += 2) walls[(height - 1) * width + x] = 0
}

/** Removes a share of the walls between two corridors; those at odd x and odd y are pillars. */
function removeWalls(
  { width, height }: Size,
  walls: Uint8Array,
  share: number,
  random: () => number,
): void {
  if (share === 0) return
  for (let y = 0; y < height; y++) {
    for (let x = (y + 1) % 2; x < width; x += 2) {
      const cell = y * width + x
      if (walls[cell] && random() < share) walls[cell] = 0
    }
  }
}

/** The bottom right cell, or the one above it where that is a pillar. */
function cornerCell({ width, height }: Size, walls: Uint8Array): Cell {
  const corner = width * height - 1
  return walls[corner] ? corner - width : corner
}
