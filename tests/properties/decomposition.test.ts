import { test } from 'vitest'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { mustBeComplete, mustNotExceed, run } from '../reference/run'
import { lengthOf, shortestWay } from '../reference/shortest'
import { freeCells } from '../reference/world'

test('decomposition finds a path of least cost, or there is none', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    const free = freeCells(world).length
    for (const cost of ['cells', 'euclidean'] as const) {
      const found = run(world, 'decomposition', { cost })
      const { name, outcome } = found
      mustBeComplete(world, found)
      // A shortest path comes to no cell twice, and Dijkstra closes none twice.
      mustNotExceed(free - 1, found)
      must(outcome.expanded <= free, () => `${name}: ${outcome.expanded} cells expanded of ${free}`)
      const best = shortestWay(world, cost)
      if (!best) continue
      const least = cost === 'cells' ? best.steps : lengthOf(best)
      must(isClose(outcome.cost, least), () => `${name}: costs ${outcome.cost} instead of ${least}`)
      must(
        isClose(outcome.measure.length, lengthOf(best)),
        () => `${name}: is ${outcome.measure.length} long instead of ${lengthOf(best)}`,
      )
    }
  })
})
