import { describe, expect, test } from 'vitest'
import { scenarios } from '../../src/app/scenarios/scenarios'
import { checkProblem, plan } from '../../src/index'
import expected from './expected.json'

const { fig05, fig06, fig07, fig09, fig11, fig12, fig14 } = expected
const reached = (cells: number) => ({ status: 'reached', cells })

/** What each scenario must give for its sentence to be true; where only a bound is known, no cells. */
const answers: Record<string, { status: string; cells?: number }> = {
  fig05: reached(fig05.visibilityGraph.cells),
  fig06: { status: fig06.potentialField.status, cells: fig06.potentialField.path.length },
  fig07: reached(fig07.potentialFieldMemory.manhattanRepulsion.length),
  fig09: reached(fig09.bug1.path.length),
  'fig11-bug1': fig11.bug1,
  'fig11-bug2': reached(fig11.bug2.path.length),
  'fig12-bug1': fig12.bug1,
  'fig12-bug2': { status: fig12.bug2.status },
  fig13: { status: 'reached' },
  'fig14-bug2': reached(fig14.bug2.path.length),
  'fig14-tangent-bug': { status: 'reached' },
  banner: { status: 'reached' },
  'banner-a-star': { status: 'reached' },
}

test('each scenario has an expectation and an id of its own', () => {
  expect(scenarios.map((scenario) => scenario.id).sort()).toEqual(Object.keys(answers).sort())
})

describe.each(scenarios)('scenario $id', ({ id, title, see, problem, planner, params }) => {
  test('is told in a title and one sentence', () => {
    expect(title).not.toBe('')
    expect(see).toMatch(/^[A-Z].*\.$/)
  })

  test('gives what it promises', () => {
    checkProblem(problem)
    const outcome = plan(problem, planner, { params })
    const { status, cells } = answers[id]
    expect(outcome.status).toBe(status)
    if (cells !== undefined) expect(outcome.path.length).toBe(cells)
  })
})

test('what is said of lengths is true', () => {
  const cells = (id: string): number => {
    const scenario = scenarios.find((candidate) => candidate.id === id)
    if (!scenario) throw new Error(`no scenario ${id}`)
    return plan(scenario.problem, scenario.planner, { params: scenario.params }).path.length
  }
  expect(cells('fig11-bug2')).toBeLessThan(cells('fig11-bug1') / 2)
  expect(cells('fig13')).toBeLessThan(cells('fig11-bug2'))
  expect(cells('fig14-tangent-bug')).toBeGreaterThan(cells('fig14-bug2'))
})

test('what is said of A* is true', () => {
  const scenario = scenarios.find(({ id }) => id === 'banner-a-star')
  if (!scenario) throw new Error('no scenario of A*')
  const { problem, planner, see } = scenario
  const by = (search: string) => plan(problem, planner, { params: { search } })
  expect(see).toContain(`closes ${by('a-star').expanded} cells`)
  expect(see).toContain(`closes ${by('dijkstra').expanded} for`)
  expect(by('a-star').cost).toBe(by('dijkstra').cost)
})
