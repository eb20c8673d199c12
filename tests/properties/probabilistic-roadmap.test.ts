import { test } from 'vitest'
import { EVENT, type ParamSettings, Tape } from '../../src/index'
import { LONG, must, onEveryMap } from '../reference/cases'
import { allEdges } from '../reference/roadmap'
import { mustBeAsGood, mustBeBestOnRoadmap, mustHaveOnTape } from '../reference/roadmap-checks'
import { mustBeModest, mustNotExceed, run } from '../reference/run'
import { freeCells, isWall, placesOf, type World, type XY } from '../reference/world'

function drawnVertices(world: World, tape: Tape): XY[] {
  const cells: number[] = []
  for (let i = 0; i < tape.length; i++) {
    if (tape.kind(i) === EVENT.vertex) cells.push(tape.cell(i))
  }
  return placesOf(world, cells)
}

/** Start, goal and as many other free cells, or all there are. */
function mustBeSamples(name: string, world: World, vertices: readonly XY[], samples: number): void {
  const names = new Set(vertices.map(String))
  must(names.size === vertices.length, () => `${name}: a vertex comes twice`)
  must(
    vertices.every(([x, y]) => !isWall(world, x, y)),
    () => `${name}: a vertex is an obstacle`,
  )
  const ends = new Set([String(world.start), String(world.goal)])
  for (const end of ends) must(names.has(end), () => `${name}: ${end} is no vertex`)
  const expected = Math.min(freeCells(world).length, samples + ends.size)
  must(names.size === expected, () => `${name}: ${names.size} vertices instead of ${expected}`)
}

test('the roadmap joins its samples as all pairs do', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const given: ParamSettings[] = [{}, { samples: 1 + (index % 60) }]
    const cost = index % 2 === 0 ? 'cells' : 'euclidean'
    for (const settings of given) {
      const tape = new Tape()
      const found = run(world, 'probabilistic-roadmap', { ...settings, cost }, tape)
      const vertices = drawnVertices(world, tape)
      const edges = allEdges(world, vertices)
      mustBeSamples(found.name, world, vertices, Number(settings.samples ?? world.width))
      mustBeModest(world, found)
      mustHaveOnTape(world, found.name, tape, vertices, edges, cost)
      mustBeBestOnRoadmap(world, found, vertices, edges, cost)
      const starred = run(world, 'probabilistic-roadmap', { ...settings, cost, search: 'a-star' })
      mustBeBestOnRoadmap(world, starred, vertices, edges, cost)
      mustBeAsGood(starred, found)
      // As for the visibility graph.
      mustNotExceed((vertices.length - 1) * (Math.max(world.width, world.height) - 1), found)
    }
  })
})
