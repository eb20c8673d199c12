import { test } from 'vitest'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { mustBeComplete, mustNotExceed, run } from '../reference/run'
import { lengthOf, shortestWay } from '../reference/shortest'
import { freeCells } from '../reference/world'

const SEARCHES = ['dijkstra', 'a-star', 'jump-point']

test('decomposition finds a path of least cost, or there is none', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    const free = freeCells(world).length
    for (const cost of ['cells', 'euclidean'] as const) {
      const best = shortestWay(world, cost)
      // Dijkstra closes no cell twice, and the others none that it does not close.
      let most = free
      for (const search of SEARCHES) {
        const found = run(world, 'decomposition', { cost, search })
        const { name, outcome } = found
        mustBeComplete(world, found)
        // A shortest path comes to no cell twice.
        mustNotExceed(free - 1, found)
        must(outcome.expanded <= most, () => `${name}: ${outcome.expanded} expanded, not ${most}`)
        if (search === 'dijkstra') most = outcome.expanded
        if (!best) continue
        const least = cost === 'cells' ? best.steps : lengthOf(best)
        must(isClose(outcome.cost, least), () => `${name}: costs ${outcome.cost}, not ${least}`)
        const { length } = outcome.measure
        must(
          isClose(length, lengthOf(best)),
          () => `${name}: ${length} long, not ${lengthOf(best)}`,
        )
      }
    }
  })
})
