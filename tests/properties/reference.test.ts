import { describe, expect, test } from 'vitest'
import { bug1 } from '../reference/bug1'
import { bug2 } from '../reference/bug2'
import { mapNumber } from '../reference/maps'
import { descend } from '../reference/potential'
import { allEdges, obstacleVertices, shortestOnRoadmap } from '../reference/roadmap'
import { shortestWay } from '../reference/shortest'
import { shrink } from '../reference/shrink'
import { freeCells, isReachable, isSame, type World, type XY } from '../reference/world'

/** The tests' own reckoning must itself give what the report's figures show. */
function figure(text: string): World {
  const rows = text.trim().split(/\s+/)
  const find = (sign: string): XY => {
    const y = rows.findIndex((row) => row.includes(sign))
    return [rows[y].indexOf(sign), y]
  }
  return {
    width: rows[0].length,
    height: rows.length,
    rows,
    start: find('S'),
    goal: find('G'),
    rule: 'if-at-most-one-obstacle',
  }
}

const FIG05 = figure(`
  .....................
  ...##................
  ...##.....#####......
  S..##.....#...#.....G
  ..........#...#......
  ..........#...#......
  ..........#####......
  .....................`)
const FIG07 = figure(`
  ................
  ................
  .......##.......
  ........#.......
  S.......#.....G.
  ........#.......
  .......##.......
  ................`)
const FIG09 = figure(`
  ..G.
  ..#.
  .##.
  .S..`)
const FIG11 = figure(`
  ....G.....
  ..........
  ..........
  ..........
  ...####...
  ...####...
  ...####...
  ...####...
  ..........
  ..........
  ..........
  ...##.....
  ...##.....
  ..........
  ..........
  ..........
  ....S.....`)
const FIG12 = figure(`
  .......S......
  ..............
  ..............
  ...##########.
  ............#.
  ............#.
  ..#########.#.
  ..#.......#.#.
  ..#.......#.#.
  ..#.#####.#.#.
  ..#.#...#.#.#.
  ..#.#.G.#.#.#.
  ..#.#.....#.#.
  ..#.#.....#.#.
  ..#.#######.#.
  ..#.........#.
  ..#.........#.
  ..###########.`)

describe('the figures, by the reference', () => {
  test('Fig. 5: the vertices and the shortest path', () => {
    const vertices = obstacleVertices(FIG05)
    const corners = '2,0 5,0 9,1 15,1 0,3 20,3 2,4 5,4 9,7 15,7'
    expect(vertices.map(String).join(' ')).toBe(corners)
    const edges = allEdges(FIG05, vertices)
    expect(shortestOnRoadmap(vertices.length, edges, 4, 5, 'cells')?.steps).toBe(20)
    expect(shortestWay(FIG05, 'cells')?.steps).toBe(20)
  })

  test('Fig. 7: the descent with memory, by both distances', () => {
    const walk = (repulsionDistance: 'manhattan' | 'euclidean') =>
      descend(FIG07, { influence: 1, repulsiveValue: 30, repulsionDistance }, true)
        .path.slice(8, 15)
        .join(' ')
    expect(walk('manhattan')).toBe('7,3 6,3 5,3 5,2 6,1 7,0 8,0')
    expect(walk('euclidean')).toBe('7,3 6,3 5,3 5,2 5,1 6,0 7,0')
  })

  test('Fig. 9: both Bugs around a complex obstacle', () => {
    const shown = '1,3 2,3 3,3 3,2 3,1 3,0 2,0'
    expect(bug1(FIG09, 'left').path.join(' ')).toBe(shown)
    expect(bug2(FIG09, 'left', 'report').path.join(' ')).toBe(shown)
  })

  test('Fig. 11: Bug1 goes around twice in full, Bug2 as drawn', () => {
    expect(bug1(FIG11, 'left').path).toHaveLength(55)
    expect(bug2(FIG11, 'left', 'report').path.join(' ')).toBe(
      '4,16 4,15 4,14 4,13 5,13 5,12 5,11 5,10 4,10 4,9 4,8 5,8 6,8 7,8 7,7 7,6 7,5 7,4 7,3 6,3 5,3 4,3 4,2 4,1 4,0',
    )
  })

  test('Fig. 12: Bug1 arrives, Bug2 loops, Bug2 that leaves closer arrives', () => {
    const walk = bug1(FIG12, 'left')
    expect([walk.status, walk.path.length]).toEqual(['reached', 262])
    expect(bug2(FIG12, 'left', 'report').status).toBe('loop')
    const closer = bug2(FIG12, 'left', 'closer')
    expect([closer.status, closer.path.length]).toEqual(['reached', 334])
    expect(shortestWay(FIG12, 'cells')?.steps).toBe(46)
  })
})

describe('the maps', () => {
  const maps = Array.from({ length: 2000 }, (_, i) => mapNumber(1, i, 'only-when-no-obstacles'))

  test('are the same each time, and others with another seed', () => {
    expect(mapNumber(1, 77, 'only-when-no-obstacles')).toEqual(maps[77])
    expect(mapNumber(2, 77, 'only-when-no-obstacles').rows).not.toEqual(maps[77].rows)
  })

  test('have all sizes, and every special case often enough', () => {
    const sides = new Set(maps.flatMap(({ width, height }) => [width, height]))
    expect(sides.size).toBe(39)
    expect([Math.min(...sides), Math.max(...sides)]).toEqual([2, 40])
    const count = (isSo: (world: World) => boolean) => maps.filter(isSo).length
    const onBorder = ({ width, height, rows }: World) =>
      rows[0].includes('#') ||
      rows[height - 1].includes('#') ||
      rows.some((r) => r[width - 1] === '#')
    expect(count(({ start, goal }) => isSame(start, goal))).toBeGreaterThan(50)
    expect(count((world) => !isReachable(world))).toBeGreaterThan(200)
    expect(count((world) => isReachable(world))).toBeGreaterThan(1000)
    expect(count(onBorder)).toBeGreaterThan(500)
    expect(count(({ width, height }) => width * height === 4)).toBeGreaterThan(5)
    expect(count((world) => freeCells(world).length === 1)).toBeGreaterThan(2)
  })

  test('that fail are cut down to what makes them fail', () => {
    const world = maps.find(({ rows }) => rows.filter((row) => row.includes('##')).length > 3)
    if (!world) throw new Error('no such map')
    const smallest = shrink(world, ({ rows }) => rows.some((row) => row.includes('##')))
    expect(smallest.rows.join('').replaceAll('.', '')).toBe('##')
    expect(smallest.width * smallest.height).toBeLessThan(world.width * world.height)
  })
})
