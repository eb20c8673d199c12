import type { Point } from './grid'

/**
 * The 8 directions, clockwise from north: N, NE, E, SE, S, SW, W, NW. Even ones are straight, odd
 * ones diagonal; `d ^ 4` is the opposite one.
 */
export type Direction = number

export const DX = Int8Array.of(0, 1, 1, 1, 0, -1, -1, -1)
export const DY = Int8Array.of(-1, -1, 0, 1, 1, 1, 0, -1)
export const DIRECTION_NAMES = ['N', 'NE', 'E', 'SE', 'S', 'SW', 'W', 'NW'] as const

export const isDiagonal = (direction: Direction): boolean => (direction & 1) === 1
export const opposite = (direction: Direction): Direction => direction ^ 4

// Indexed by 3 * (sign(dy) + 1) + sign(dx) + 1.
const BY_SIGNS = Int8Array.of(7, 0, 1, 6, -1, 2, 5, 4, 3)

/** The direction in which (dx, dy) points: diagonal while both differ from 0; -1 for (0, 0). */
export function directionOf(dx: number, dy: number): Direction {
  return BY_SIGNS[3 * (Math.sign(dy) + 1) + Math.sign(dx) + 1]
}

/** What is added to a cell's index by a step in each direction, on a map `width` cells wide. */
export function stepOffsets(width: number): Int32Array {
  return Int32Array.from(DX, (dx, d) => DY[d] * width + dx)
}

/** The place one step from `place` in a direction. */
export function stepped({ x, y }: Point, direction: Direction): Point {
  return { x: x + DX[direction], y: y + DY[direction] }
}
