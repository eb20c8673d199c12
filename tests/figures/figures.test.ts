import { describe, expect, test } from 'vitest'
import { maps } from '../../src/app/scenarios/scenario-maps'
import {
  frameAt,
  type Outcome,
  type ParamSettings,
  type Problem,
  plan,
  problemFromText,
  Tape,
} from '../../src/index'
import expected from './expected.json'

/** What the figures of the report show, reckoned by a program that shares nothing with this one. */
const { fig05, fig06, fig07, fig09, fig11, fig12, fig14 } = expected

type XY = number[]

const sorted = (points: XY[]): XY[] => points.toSorted((a, b) => a[0] - b[0] || a[1] - b[1])

function on(map: keyof typeof maps, planner: string, params: ParamSettings = {}) {
  const problem = problemFromText(maps[map])
  const tape = new Tape()
  const outcome = plan(problem, planner, { params, tape })
  return { problem, outcome, tape, path: points(problem, outcome.path) }
}

function points(problem: Problem, cells: Iterable<number>): XY[] {
  const { width } = problem.grid
  return Array.from(cells, (cell) => [cell % width, Math.floor(cell / width)])
}

const answer = ({ status, path }: Outcome) => ({ status, cells: path.length })

test('every entry of the expectations is known here', () => {
  const entries = Object.entries(expected)
    .filter(([name]) => name !== 'rule')
    .flatMap(([name, entry]) => Object.keys(entry).map((key) => `${name} ${key}`))
  expect(entries.sort()).toEqual(
    [
      'fig05 visibilityGraph',
      'fig05 decomposition',
      'fig06 potentialField',
      'fig07 potentialFieldMemory',
      'fig09 bug1',
      'fig09 bug2',
      'fig11 bug1',
      'fig11 bug2',
      'fig11 fig13',
      'fig12 bug1',
      'fig12 bug2',
      'fig12 bug2Classic',
      'fig12 decomposition',
      'fig14 bug2',
      'fig14 tangentBug',
    ].sort(),
  )
})

describe('Fig. 5', () => {
  test('the vertices of the roadmap are the corners of the obstacles', () => {
    const { problem, tape } = on('fig05', 'visibility-graph')
    const ends = [problem.start, problem.goal]
    const corners = frameAt(tape, tape.length).vertices.filter((cell) => !ends.includes(cell))
    expect(sorted(points(problem, corners))).toEqual(sorted(fig05.visibilityGraph.vertices))
  })

  test('the path on the roadmap is as short as any', () => {
    const roadmap = on('fig05', 'visibility-graph').outcome
    expect(answer(roadmap)).toEqual({ status: 'reached', cells: fig05.visibilityGraph.cells })
    const cells = on('fig05', 'decomposition').outcome
    expect(answer(cells)).toEqual({ status: 'reached', cells: fig05.decomposition.cells })
  })
})

describe('Fig. 6', () => {
  const { repulsiveValue, influence, status, path, potential } = fig06.potentialField
  const run = on('fig06', 'potential-field', { repulsiveValue, influence })

  test('the agent ends in the local minimum', () => {
    expect(run.outcome.status).toBe(status)
    expect(run.path).toEqual(path)
  })

  test('the potentials', () => {
    const found = frameAt(run.tape, run.tape.length).fields.potential
    for (const [place, value] of Object.entries(potential)) {
      const [x, y] = place.split(',').map(Number)
      expect(found?.[y * run.problem.grid.width + x], place).toBe(Number(value))
    }
  })
})

describe('Fig. 7', () => {
  const { repulsiveValue, influence, ...paths } = fig07.potentialFieldMemory

  test.each([
    ['manhattan', paths.manhattanRepulsion],
    ['euclidean', paths.euclideanRepulsion],
  ])('with %s repulsion', (repulsionDistance, path) => {
    const params = { repulsiveValue, influence, repulsionDistance }
    const run = on('fig07', 'potential-field-memory', params)
    expect(run.outcome.status).toBe('reached')
    expect(run.path).toEqual(path)
  })
})

describe('Fig. 9', () => {
  test.each(['bug1', 'bug2'] as const)('%s goes round the bend', (planner) => {
    const run = on('fig09', planner)
    expect(run.outcome.status).toBe('reached')
    expect(run.path).toEqual(fig09[planner].path)
  })
})

describe('Fig. 11', () => {
  test('Bug1 walks around each obstacle in full', () => {
    const { problem, outcome, tape } = on('fig11', 'bug1')
    const { status, cells } = fig11.bug1
    expect(answer(outcome)).toEqual({ status, cells })
    const frame = frameAt(tape, tape.length)
    expect([frame.hits.length, frame.leaves.length]).toEqual([2, 2])
    const walked = new Set(outcome.path)
    const { width, walls } = problem.grid
    const beside = Array.from(walls, (_, cell) => cell).filter(
      (cell) =>
        !walls[cell] &&
        (walls[cell - width] || walls[cell + width] || walls[cell - 1] || walls[cell + 1]),
    )
    expect(beside.filter((cell) => !walked.has(cell))).toEqual([])
  })

  test('Bug2 leaves where it meets its first path', () => {
    expect(on('fig11', 'bug2').path).toEqual(fig11.bug2.path)
  })
})

test('Fig. 13: Tangent Bug needs fewer cells than Bug2 on the same map', () => {
  const { outcome } = on('fig11', 'tangent-bug')
  expect(outcome.status).toBe('reached')
  expect(outcome.path.length).toBeLessThan(fig11.bug2.path.length)
})

describe('Fig. 12', () => {
  test('Bug1 gets into the spiral', () => {
    expect(answer(on('fig12', 'bug1').outcome)).toEqual(fig12.bug1)
  })

  test('Bug2 goes round for ever', () => {
    const { leave, status } = fig12.bug2
    const { outcome } = on('fig12', 'bug2', { leave })
    expect(outcome.status).toBe(status)
    const last = outcome.path.length - 1
    expect(outcome.path.indexOf(outcome.path[last])).toBeLessThan(last)
  })

  test('Bug2 that only leaves further along arrives', () => {
    const { leave, ...answered } = fig12.bug2Classic
    expect(answer(on('fig12', 'bug2', { leave }).outcome)).toEqual(answered)
  })

  test('the shortest path', () => {
    const { outcome } = on('fig12', 'decomposition')
    expect(answer(outcome)).toEqual({ status: 'reached', cells: fig12.decomposition.cells })
  })
})

describe('Fig. 14', () => {
  test('Bug2', () => {
    expect(on('fig14', 'bug2').path).toEqual(fig14.bug2.path)
  })

  test('Tangent Bug needs more cells than Bug2', () => {
    const { outcome } = on('fig14', 'tangent-bug', { variant: 'report', range: 2 })
    expect(outcome.status).toBe('reached')
    expect(outcome.path.length).toBeGreaterThan(fig14.bug2.path.length)
  })
})
