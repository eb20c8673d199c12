import type { Point } from './grid'

/**
 * The 8 directions, clockwise from north: N, NE, E, SE, S, SW, W, NW. Even ones are straight, odd
 * ones diagonal; `d ^ 4` is the opposite one.
 */
export type Direction = number

export const DX = Int8Array.of(0, 1, 1, 1, 0, -1, -1, -1)
export const DY = Int8Array.of(-1, -1, 0, 1, 1, 1, 0, -1)

export const isDiagonal = (direction: Direction): boolean => (direction & 1) === 1
export const opposite = (direction: Direction): Direction => direction ^ 4

// Indexed by 3 * (sign(dy) + 1) + sign(dx) + 1.
const BY_SIGNS = Int8Array.of(7, 0, 1, 6, -1, 2, 5, 4, 3)

/** The direction in which (dx, dy) points: diagonal while both differ from 0; -1 for (0, 0). */
export function directionOf(dx: number, dy: number): Direction {
  return stepDirection(Math.sign(dx), Math.sign(dy))
}

/** The direction of a step by -1, 0 or 1 column and row; -1 if it is no step. */
export function stepDirection(dx: number, dy: number): Direction {
  return BY_SIGNS[3 * dy + dx + 4]
}

/** What is added to a cell's index by a step in each direction, on a map `width` cells wide. */
export function stepOffsets(width: number): Int32Array {
  const offsets = new Int32Array(8)
  for (let d = 0; d < 8; d++) offsets[d] = DY[d] * width + DX[d]
  return offsets
}

/** The place one step from `place` in a direction. */
export function stepped({ x, y }: Point, direction: Direction): Point {
  return { x: x + DX[direction], y: y + DY[direction] }
}
