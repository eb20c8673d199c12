import { describe, expect, it } from 'vitest'
import { plan } from '../../../src/algorithms/plan'
import { planners } from '../../../src/algorithms/planners'
import { COLUMNS, medianInWords, sortEntries } from '../../../src/app/compare/columns'
import { comparedPaths, styleOf } from '../../../src/app/compare/paths'
import {
  comparisonFailed,
  comparisonInWords,
  comparisonReady,
  planCompared,
  planTimed,
  toggleComparison,
  togglePath,
} from '../../../src/app/compare/transitions'
import { defaultPreferences } from '../../../src/app/state/preferences'
import { withMark, withSettings } from '../../../src/app/state/setup'
import { initialState } from '../../../src/app/state/state'
import { setupFrom } from '../setups'
import { entriesOf, walled } from './setups'

const entryOf = (plannerId: string, setup = walled) => {
  const entry = entriesOf(setup).find(({ plan }) => plan.plannerId === plannerId)
  if (!entry) throw new Error(`no ${plannerId}`)
  return entry
}

const textOf = (title: string, entry: ReturnType<typeof entryOf>) =>
  COLUMNS.find((column) => column.title === title)?.show(entry)

describe('a compared plan', () => {
  it('tells what plan() tells, with the parameters as set', () => {
    const setup = withSettings(walled, 'tangent-bug', { range: 1, variant: 'classic' })
    const told = entryOf('tangent-bug', setup).plan
    const params = setup.params['tangent-bug']
    const { status, measure, sensed, path } = plan(setup.problem, 'tangent-bug', { params })
    expect(told).toMatchObject({ status, ...measure, effort: sensed, walked: path.length - 1 })
    expect([...told.path]).toEqual([...path])
    expect(told.milliseconds).toBeGreaterThanOrEqual(0)
    expect(told.milliseconds).toBeLessThan(performance.now())
    const usual = entryOf('tangent-bug').plan
    expect(told.effort).not.toBe(usual.effort)
  })

  it('holds the path against the optimum under the planner’s own rule', () => {
    const optimum = entryOf('decomposition').plan
    const bug = entryOf('bug1').plan
    expect(optimum).toMatchObject({ ratio: 1, ratioBy: 'cells' })
    expect(bug.ratio).toBeCloseTo(bug.walked / optimum.walked, 5)
    expect(bug.ratio).toBeGreaterThan(1)
    const byLength = withSettings(walled, 'visibility-graph', { cost: 'euclidean' })
    const graph = entryOf('visibility-graph', byLength)
    const { measure } = plan(walled.problem, 'decomposition', { params: { cost: 'euclidean' } })
    expect(graph.plan.ratio).toBeCloseTo(graph.plan.length / measure.length, 5)
    expect(textOf('Ratio', graph)).toMatch(/^\d\.\d\d\*$/)
  })

  it('has bounds beside what Bug1 and Bug2 walked, and says which are not promised', () => {
    const closer = withSettings(walled, 'bug2', { leave: 'closer' })
    for (const entry of [entryOf('bug1'), entryOf('bug2', closer)]) {
      expect(entry.plan.walked).toBeLessThanOrEqual(Number(entry.plan.bound))
      expect(textOf('At most', entry)).toBe(`≤ ${entry.plan.bound}`)
    }
    expect(textOf('At most', entryOf('bug2'))).toBe(`${entryOf('bug2').plan.bound}†`)
    expect(textOf('At most', entryOf('tangent-bug'))).toBe('–')
  })

  it('has no ratio where there is no path', () => {
    const shut = setupFrom('S#.\n##.\n..G')
    for (const { plan } of entriesOf(shut)) expect(plan.ratio).toBeNull()
    expect(textOf('Outcome', entryOf('bug1', shut))).toBe('Unreachable')
  })

  it('tells why a planner cannot be run as set', () => {
    const wrong = withSettings(walled, 'probabilistic-roadmap', { samples: -3 })
    const { plan } = entryOf('probabilistic-roadmap', wrong)
    expect(plan.status).toBe('refused')
    expect(plan.reason).toMatch(/samples/i)
  })
})

describe('the table', () => {
  const sorted = (title: string, descending: boolean) => {
    const column = COLUMNS.findIndex((candidate) => candidate.title === title)
    return sortEntries(entriesOf(), { column, descending }).map(({ plan }) => plan)
  }

  it('is sorted by numbers, with what has none last either way', () => {
    const numbers = (descending: boolean) => sorted('Ratio', descending).map(({ ratio }) => ratio)
    const known = numbers(false).filter((ratio) => ratio !== null)
    expect(known).toEqual(known.toSorted((a, b) => a - b))
    expect(known.length).toBeLessThan(planners.length)
    expect(numbers(false).at(-1)).toBeNull()
    expect(numbers(true).at(-1)).toBeNull()
    expect(numbers(true)[0]).toBe(known.at(-1))
  })

  it('is sorted by names', () => {
    expect(sorted('Planner', false)[0].plannerId).toBe('bug1')
    expect(sorted('Planner', true)[0].plannerId).toBe('visibility-graph')
  })

  it('has the numbers of a path of one cell, whose start is the goal, and none of no path', () => {
    const titles = ['Cells', 'Length', 'Ratio', 'Turns', 'Walked', 'At most']
    const numbers = (entry: ReturnType<typeof entryOf>) =>
      titles.map((title) => textOf(title, entry))
    const there = withMark(walled, 'goal', walled.problem.start)
    expect(numbers(entryOf('bug1', there))).toEqual(['1', '0.00', '–', '0', '0', '≤ 0'])
    const shut = setupFrom('S#.\n##.\n..G')
    expect(numbers(entryOf('decomposition', shut))).toEqual(titles.map(() => '–'))
  })

  it('says whether its effort was expanded or sensed, if there was any', () => {
    const [search, bug] = [entryOf('decomposition'), entryOf('bug1')]
    expect(textOf('Effort', search)).toBe(`${search.plan.effort} exp.`)
    expect(textOf('Effort', bug)).toBe(`${bug.plan.effort} sensed`)
    expect(textOf('Effort', entryOf('potential-field'))).toBe('–')
  })

  it('has a time when it was taken, a sign that it will be, or none for what cannot be run', () => {
    const entry = entryOf('bug1')
    expect(textOf('Time', entry)).toBe('…')
    expect(textOf('Time', { ...entry, milliseconds: 0.25 })).toBe('250 µs')
    const wrong = withSettings(walled, 'probabilistic-roadmap', { samples: -3 })
    expect(textOf('Time', entryOf('probabilistic-roadmap', wrong))).toBe('–')
  })

  it('tells times below a millisecond in microseconds', () => {
    expect([0.0123, 0.0996, 0.9994, 0.9996, 12].map(medianInWords)).toEqual([
      '12 µs',
      '100 µs',
      '999 µs',
      '1 ms',
      '12 ms',
    ])
  })
})

describe('the comparison in the state', () => {
  const begun = toggleComparison(initialState(walled, defaultPreferences))
  const full = entriesOf().reduceRight(
    (state, { subject, plan }) => planCompared(state, subject, plan),
    begun,
  )

  it('lists planners in their order, whichever comes first, and replaces older plans', () => {
    const again = planCompared(full, walled, entryOf('bug1').plan)
    const ids = again.comparison.entries.map(({ plan }) => plan.plannerId)
    expect(ids).toEqual(planners.map(({ id }) => id))
  })

  it('takes times of its own subject only', () => {
    const other = { ...walled, seed: 2 }
    const timeIn = (state: typeof full) => state.comparison.entries[0].milliseconds
    expect(timeIn(planTimed(full, other, 'decomposition', 3))).toBeNull()
    expect(timeIn(planTimed(full, walled, 'decomposition', 3))).toBe(3)
  })

  it('draws the paths that are not hidden, and none on a map of another size', () => {
    const walks = full.comparison.entries.filter(({ plan }) => plan.path.length > 1)
    expect(comparedPaths(full).length).toBe(walks.length)
    const without = togglePath(full, 'bug1')
    expect(comparedPaths(without).length).toBe(walks.length - 1)
    expect(comparedPaths(togglePath(without, 'bug1'))).toEqual(comparedPaths(full))
    expect(comparedPaths({ ...full, setup: setupFrom('S.\n.G') })).toEqual([])
  })

  it('draws nothing of planners that came nowhere', () => {
    const shut = setupFrom('S#.\n##.\n..G')
    const state = entriesOf(shut).reduce(
      (state, { plan }) => planCompared(state, shut, plan),
      toggleComparison(initialState(shut, defaultPreferences)),
    )
    expect(state.comparison.entries.map(({ plan }) => plan.path.length)).toContain(1)
    expect(comparedPaths(state)).toEqual([])
  })

  it('draws each planner in a style of its own', () => {
    expect(new Set(planners.map(({ id }) => styleOf(id))).size).toBe(planners.length)
  })

  it('is said in one sentence when it is ready for the map on screen', () => {
    const reached = full.comparison.entries.filter(({ plan }) => plan.status === 'reached').length
    const words = comparisonInWords(full.comparison)
    const { cells } = entryOf('decomposition').plan
    expect(words).toBe(
      `Compared: ${reached} of ${planners.length} planners reach the goal; the shortest path has ${cells} cells (Grid decomposition).`,
    )
    expect(comparisonReady(full, walled).said.text).toBe(words)
    expect(comparisonReady(full, { ...walled, seed: 2 })).toBe(full)
  })

  it('says why there is none, if it is the map on screen that was not compared', () => {
    const failed = comparisonFailed(full, walled, 'out of memory')
    expect(failed.comparison).toMatchObject({
      entries: [],
      fault: 'Nothing was compared: out of memory.',
    })
    expect(comparisonFailed(full, { ...walled, seed: 2 }, 'old')).toBe(full)
    const ended = toggleComparison(full)
    expect(comparisonFailed(ended, walled, 'late')).toBe(ended)
    expect(planCompared(failed, walled, entryOf('bug1').plan).comparison.fault).toBe('')
  })

  it('ends, and takes nothing that comes late', () => {
    const ended = toggleComparison(togglePath(full, 'bug1'))
    expect(ended.comparison).toEqual({ isOn: false, entries: [], hidden: ['bug1'], fault: '' })
    expect(planCompared(ended, walled, entryOf('bug1').plan)).toBe(ended)
  })
})
