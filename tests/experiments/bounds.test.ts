import { expect, test } from 'vitest'
import { bug1Bound, bug2Bound, type LengthBound } from '../../src/experiments/bounds'
import { type ParamSettings, type Problem, plan, problemFromText } from '../../src/index'
import { isBoxedIn, obstacleInTheWay, onceAround, type Turn } from '../reference/boundary'
import { bug1 } from '../reference/bug1'
import { LONG, must, onEveryMap } from '../reference/cases'
import { mustNotExceed, type Run, run } from '../reference/run'
import { flood, problemOf, simplest, steps, type World, type XY } from '../reference/world'

/** Each obstacle that refuses a step from one of the cells: its perimeter and how often it does. */
function obstaclesAt(world: World, cells: readonly XY[], turn: Turn) {
  const rings = new Map<string, { perimeter: number; refusals: number }>()
  for (const cell of cells) {
    const next = simplest(cell, world.goal)[1]
    const obstacle = next && obstacleInTheWay(world, cell, next)
    if (!obstacle || isBoxedIn(world, cell)) continue
    const lap = onceAround(world, { at: cell, obstacle }, turn, () => false)
    const taken = lap.slice(1).map((place, i) => `${lap[i]} ${place}`)
    const name = taken.sort()[0]
    const ring = rings.get(name) ?? { perimeter: taken.length, refusals: 0 }
    ring.refusals++
    rings.set(name, ring)
  }
  return [...rings.values()]
}

/** The bound may not be exceeded, and neither may it be looser than it is by its definition. */
function mustBound(found: Run, bound: LengthBound, expected: number): void {
  mustNotExceed(bound.steps, found)
  must(bound.steps === expected, () => `${found.name}: bound ${bound.steps}, not ${expected}`)
}

test('bug1 stays within D + 1.5 Σ p, and one round more where it is refused as it leaves', {
  timeout: LONG,
}, async () => {
  await onEveryMap((world) => {
    for (const turn of ['left', 'right'] as const) {
      const found = run(world, 'bug1', { turn })
      const { hits } = bug1(world, turn)
      const obstacles = obstaclesAt(world, hits, turn)
      let expected = steps(world.start, world.goal)
      for (const { perimeter, refusals } of obstacles) {
        expected += (0.5 + refusals) * perimeter
        if (refusals === 1) continue
        must(refusals === 2, () => `${found.name}: met an obstacle ${refusals} times`)
        must(found.outcome.status === 'unreachable', () => `${found.name}: round twice`)
      }
      mustBound(found, bug1Bound(problemOf(world), turn), expected)
    }
  })
})

test('bug2 with closer stays within D + ½ Σ n p', { timeout: LONG }, async () => {
  await onEveryMap((world) => {
    const inside = flood(world)
    const line = simplest(world.start, world.goal).filter((cell) => inside.has(String(cell)))
    const bound = bug2Bound(problemOf(world))
    for (const turn of ['left', 'right'] as const) {
      const found = run(world, 'bug2', { leave: 'closer', turn })
      let expected = steps(world.start, world.goal)
      for (const { perimeter, refusals } of obstaclesAt(world, line, turn)) {
        expected += perimeter * refusals
      }
      mustBound(found, bound, expected)
    }
  })
})

test('a bound by hand: one obstacle, both sides of a thin wall', () => {
  const problem = problemFromText(`
    .......
    ...#...
    .S.#.G.
    .......
  `)
  // Around two cells: a side of 2, a side of 1, each twice, and 4 corners of 1 step more.
  expect(bug1Bound(problem, 'left')).toEqual({
    distance: 4,
    obstacles: [{ hit: 16, perimeter: 10, rounds: 1.5 }],
    steps: 19,
  })
  expect(bug2Bound(problem)).toEqual({
    distance: 4,
    obstacles: [{ hit: 16, perimeter: 10, rounds: 1 }],
    steps: 14,
  })
})

const stepsOf = (problem: Problem, id: string, params: ParamSettings) =>
  plan(problem, id, { params }).measure.cells - 1

test('bug1 can need nearly all that its bound allows', () => {
  const wall = '...#...\n'
  const problem = problemFromText(`.......\n${wall.repeat(3)}.S.#.G.\n${wall.repeat(4)}.......`)
  expect(bug1Bound(problem, 'left').steps).toBe(37)
  expect(stepsOf(problem, 'bug1', { turn: 'left' })).toBe(34)
})

test('bug1 that is refused as it leaves can need more than one round and a half', () => {
  const problem = problemFromText('S.#\n.#G')
  expect(bug1Bound(problem, 'left')).toEqual({
    distance: 2,
    obstacles: [{ hit: 0, perimeter: 4, rounds: 2.5 }],
    steps: 12,
  })
  expect(stepsOf(problem, 'bug1', { turn: 'left' })).toBe(9)
})

test('bug2 can need nearly all that its bound allows', () => {
  const problem = problemFromText(`
    ......
    .S.##.
    ...#G#
    ....#.
  `)
  expect(bug2Bound(problem).steps).toBe(23)
  expect(stepsOf(problem, 'bug2', { leave: 'closer' })).toBe(21)
})

test('an obstacle that the m-line enters twice counts twice for bug2', () => {
  const problem = problemFromText(`
    .........
    ..#####..
    S.#...#.G
    ..#.#.#..
    ....#....
  `)
  const [share, ...others] = bug2Bound(problem).obstacles
  expect(others).toEqual([])
  expect(share.rounds).toBe(2)
})

test('of what is no problem there is no bound', () => {
  const problem = problemFromText('S.\n.G')
  // These would be walked round for ever.
  for (const start of [Number.NaN, -1, 0.5, 4]) {
    expect(() => bug1Bound({ ...problem, start }, 'left')).toThrow(`The start is cell ${start}`)
    expect(() => bug2Bound({ ...problem, start })).toThrow(`The start is cell ${start}`)
  }
  const turn = 'up' as unknown as 'left'
  expect(() => bug1Bound(problem, turn)).toThrow('"up" is not one of left, right')
})
