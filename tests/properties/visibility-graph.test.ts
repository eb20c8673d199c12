import { test } from 'vitest'
import { Tape } from '../../src/index'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { allEdges, obstacleVertices } from '../reference/roadmap'
import { mustBeAsGood, mustBeBestOnRoadmap, mustHaveOnTape } from '../reference/roadmap-checks'
import { mustBeComplete, mustNotExceed, run } from '../reference/run'
import { lengthOf, shortestWay } from '../reference/shortest'

test('visibility-graph is the graph of all pairs, and complete', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    const vertices = obstacleVertices(world)
    const edges = allEdges(world, vertices)
    for (const cost of ['cells', 'euclidean'] as const) {
      const tape = new Tape()
      const drawn = run(world, 'visibility-graph', { cost }, tape)
      mustHaveOnTape(world, drawn.name, tape, vertices, edges, cost)
      const found = run(world, 'visibility-graph', { cost })
      const { name, outcome } = found
      must(drawn.outcome.cost === outcome.cost, () => `${name}: costs other with a tape`)
      mustBeComplete(world, found)
      mustBeBestOnRoadmap(world, found, vertices, edges, cost)
      const starred = run(world, 'visibility-graph', { cost, search: 'a-star' })
      mustBeBestOnRoadmap(world, starred, vertices, edges, cost)
      mustBeAsGood(starred, found)
      // No vertex comes twice, and the path between two has fewer steps than the map's longer side.
      mustNotExceed((vertices.length - 1) * (Math.max(world.width, world.height) - 1), found)
      const best = shortestWay(world, cost)
      if (!best) continue
      const least = cost === 'cells' ? best.steps : lengthOf(best)
      must(
        outcome.cost > least || isClose(outcome.cost, least),
        () => `${name}: costs ${outcome.cost}, less than can be (${least})`,
      )
      if (cost === 'cells' && world.rule === 'only-when-no-obstacles') {
        must(outcome.cost === least, () => `${name}: ${outcome.cost} is not optimal (${least})`)
      }
    }
  })
})
