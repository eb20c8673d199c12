import { describe, expect, it } from 'vitest'
import { promisesInWords } from '../../src/app/dialogs/about-planner'
import { reportOf } from '../../src/app/panels/result-card'
import { withParam } from '../../src/app/state/setup'
import {
  hidePath,
  planArrived,
  planCancelled,
  planFailed,
  planIsSlow,
  planStarted,
} from '../../src/app/state/transitions'
import { planned, setupFrom, stateFrom } from './setups'

describe('the result card', () => {
  const begin = stateFrom('S...\n.##.\n...G')
  const running = planStarted(begin)
  const settled = planArrived(running, planned(begin.setup))

  it('says what came out', () => {
    expect(reportOf(settled)).toMatchObject({ tone: 'good', words: 'Reached in 5 cells' })
    expect(reportOf(settled).rows.map((row) => row.label)).toContain('Expanded')
  })

  it('says that a goal is proven unreachable, and why', () => {
    const walled = stateFrom('S.#.\n..##\n#..G\n..##').setup
    const cut = { ...walled, problem: { ...walled.problem, goal: 3 } }
    const { tone, words, detail } = reportOf({
      ...planArrived(running, planned(cut)),
      setup: cut,
    })
    expect(tone).toBe('proof')
    expect(words).toMatch(/^Proven unreachable: ./)
    expect(detail).toBe('')
  })

  it('keeps what it said while a short plan is made, and says so of a long one', () => {
    const again = planStarted(settled)
    expect(reportOf(again).words).toBe('Reached in 5 cells')
    expect(reportOf(planIsSlow(again))).toMatchObject({
      tone: 'busy',
      words: 'Planning…',
      rows: [],
    })
    expect(reportOf(running).words).toBe('Planning…')
  })

  it('says when there is no plan, and why', () => {
    expect(reportOf(planCancelled(running))).toMatchObject({ words: 'Cancelled', rows: [] })
    expect(reportOf(planFailed(running, begin.setup, 'The seed is no number.'))).toMatchObject({
      words: 'No plan',
      detail: 'The seed is no number.',
    })
    expect(reportOf(hidePath(settled)).words).toBe('Path cleared')
  })
})

it('what a planner promises depends on its settings and on the diagonal rule', () => {
  const setup = setupFrom('S.\n.G', 'bug2')
  expect(promisesInWords(setup)).toContain('not complete')
  expect(promisesInWords(withParam(setup, 'bug2', 'leave', 'closer'))).toContain(': complete')
  const graph = setupFrom('S.\n.G', 'visibility-graph')
  const strict = { ...graph.problem, diagonal: 'only-when-no-obstacles' as const }
  expect(promisesInWords(graph)).toContain('not optimal')
  expect(promisesInWords({ ...graph, problem: strict })).toContain('and optimal')
})
