import { expect, it } from 'vitest'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { simplestPath } from '../../src/grid/simplest-path'
import { edgeLines } from '../../src/render/edge-lines'
import { runToEnd } from './run-to-end'

/** The steps between neighbours that a list of paths covers, each named by its two cells. */
function stepsOf(paths: Iterable<ArrayLike<number>>): string[] {
  const steps: string[] = []
  for (const path of paths) {
    for (let i = 1; i < path.length; i++) {
      steps.push([path[i - 1], path[i]].sort((a, b) => a - b).join('-'))
    }
  }
  return steps.sort()
}

function pairs(cells: readonly number[]): [number, number][] {
  return Array.from({ length: cells.length / 2 }, (_, i) => [cells[2 * i], cells[2 * i + 1]])
}

it('covers what the simplest paths of the edges cover, each step once', () => {
  const random = randomNumbers(3)
  for (let i = 0; i < 300; i++) {
    const width = 2 + randomInteger(random, 9)
    const height = 2 + randomInteger(random, 9)
    const cells = 2 * (1 + randomInteger(random, 20))
    const edges = Array.from({ length: cells }, () => randomInteger(random, width * height))
    const paths = (ends: readonly number[]) =>
      pairs(ends).map(([from, to]) => simplestPath(width, from, to))
    const covered = stepsOf(paths(runToEnd(edgeLines(width, height, edges))))
    expect(covered).toEqual([...new Set(stepsOf(paths(edges)))].sort())
  }
})

it('joins edges on one line, and bends an edge where its simplest path bends', () => {
  // On a map 5 cells wide: 0 → 2 and 4 → 1 lie on the first row; 0 → 8 is diagonal up to 6.
  expect(pairs(runToEnd(edgeLines(5, 3, [0, 2, 4, 1])))).toEqual([[0, 4]])
  expect(pairs(runToEnd(edgeLines(5, 3, [0, 8])))).toEqual([
    [6, 8],
    [0, 6],
  ])
  expect(runToEnd(edgeLines(5, 3, [7, 7]))).toEqual([])
})
