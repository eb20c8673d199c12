import type { Size } from '../grid'
import type { GeneratedMap } from './generator'

/** A map with the start near its left side and the goal near its right one, both made free. */
export function withEndsMadeFree({ width, height }: Size, walls: Uint8Array): GeneratedMap {
  const middle = Math.floor((height - 1) / 2) * width
  const margin = Math.floor((width - 1) / 12)
  const start = middle + margin
  const goal = middle + width - 1 - margin
  walls[start] = 0
  walls[goal] = 0
  return { walls, start, goal }
}
