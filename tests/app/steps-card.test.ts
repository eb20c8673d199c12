import { describe, expect, it } from 'vitest'
import { plan } from '../../src/algorithms/plan'
import { planners } from '../../src/algorithms/planners'
import { loopBegan } from '../../src/app/playback/loop'
import { type Moment, Moments } from '../../src/app/playback/moment'
import { timelineOf } from '../../src/app/playback/timeline'
import { toNextLandmark, toStep } from '../../src/app/playback/transport'
import { maps } from '../../src/app/scenarios/scenario-maps'
import { plannerOf, valuesOf } from '../../src/app/state/setup'
import { planArrived } from '../../src/app/state/transitions'
import { cellFactsInWords } from '../../src/app/words/cell-line'
import { codeSection } from '../../src/app/words/code-section'
import { numberInWords } from '../../src/app/words/numbers'
import { stepNumbers } from '../../src/app/words/step-numbers'
import { landmarkInWords, stepInWords } from '../../src/app/words/steps-in-words'
import { problemFromText } from '../../src/grid/text-map'
import { stepsOf } from '../../src/trace/landmarks'
import { Tape } from '../../src/trace/tape'
import { randomProblem } from '../render/scenes'
import { planned, setupFrom, stateFrom } from './setups'

const MAP = ['S....', '.###.', '...#.', '.###.', '....G'].join('\n')
/** In which Bug2 as in the report goes round for ever. */
const SPIRAL = [
  '..S......',
  '.#######.',
  '.......#.',
  '.#####.#.',
  '.#..G#.#.',
  '.#.###.#.',
  '.#.....#.',
  '.#######.',
  '.........',
].join('\n')

function stateOf(plannerId: string, text = MAP) {
  const setup = setupFrom(text, plannerId)
  const state = { ...stateFrom(text), setup, committed: setup }
  return planArrived(state, planned(setup))
}

function momentAt(state: ReturnType<typeof stateOf>): Moment {
  const moment = new Moments().of(state)
  if (!moment) throw new Error('There is no plan.')
  return moment
}

describe('the section of the pseudocode', () => {
  it.each(planners.map(({ id }) => id))('has the line of every event of %s', (id) => {
    for (const variant of ['report', 'classic']) {
      const setup = { ...setupFrom(MAP, id) }
      const hasVariants = plannerOf(setup).params.some(({ name }) => name === 'variant')
      const chosen = hasVariants ? { ...setup, params: { [id]: { variant } } } : setup
      const lines = codeSection(plannerOf(chosen), valuesOf(chosen)).map(({ line }) => line)
      const { tape } = planned(chosen)
      for (let i = 0; i < tape.length; i++) expect(lines).toContain(tape.line(i))
    }
  })

  it.each(planners)('of $id has no line that is marked at no step', (planner) => {
    const problems = [
      ...Object.values(maps).map((text) => problemFromText(text)),
      ...Array.from({ length: 40 }, (_, i) => randomProblem(14, 11, 0.15 + 0.1 * (i % 5), i)),
    ]
    const choices = planner.params.flatMap((param) =>
      param.kind === 'choice' ? param.choices.map((value) => ({ [param.name]: value })) : [],
    )
    const marked = new Set<number>()
    for (const problem of problems) {
      for (const params of [{}, ...choices]) {
        const tape = new Tape()
        plan(problem, planner.id, { params, tape })
        for (const time of stepsOf(tape)) if (time > 0) marked.add(tape.line(time - 1))
      }
    }
    const never = planner.pseudocode.filter((text, i) => !marked.has(i) && !/^variant/.test(text))
    expect(never).toEqual([])
  })

  it.each([
    ['potential-field', 'S..G\n....', /^Start|^The end/, /^while not at the goal/],
    ['potential-field-memory', 'S..G\n....', /^Start|^The end/, /^while not at the goal/],
    [
      'tangent-bug',
      '........\n.S..###.\n....#G#.\n....###.\n........',
      /^Round|^Loop|^The end/,
      /if that came round once/,
    ],
  ])('of %s on %j is marked at %s by what happens there', (id, text, sentence, line) => {
    const state = stateOf(id, text)
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const moments = Array.from(steps, (_, step) => momentAt(toStep(state, step)))
    const { pseudocode } = plannerOf(state.setup)
    const marked = moments
      .filter((moment) => sentence.test(stepInWords(moment)))
      .map(({ frame }) => pseudocode[frame.line])
    expect(marked.length).toBeGreaterThan(1)
    for (const text of marked) expect(text).toMatch(line)
  })

  it('is that of the chosen variant, and what both have in common', () => {
    const planner = planners.find(({ id }) => id === 'tangent-bug')
    if (!planner) throw new Error('There is no Tangent Bug.')
    const texts = (variant: string) => codeSection(planner, { variant }).map(({ text }) => text)
    for (const variant of ['report', 'classic']) {
      const shown = texts(variant)
      expect(shown[0]).toBe(planner.pseudocode[0])
      expect(shown.at(-1)).toBe(planner.pseudocode.at(-1))
      expect(shown.filter((text) => /^variant/.test(text))).toEqual([
        expect.stringContaining(variant),
      ])
    }
    const both = new Set([...texts('report'), ...texts('classic')])
    expect(both).toEqual(new Set(planner.pseudocode))
  })
})

describe('the words of a step', () => {
  it('begin before the first step and end with the reason of the outcome', () => {
    const state = stateOf('bug2')
    expect(stepInWords(momentAt(toStep(state, 0)))).toBe('Before the first step.')
    const end = stepInWords(momentAt(state))
    expect(end).toBe('The end at (4, 4): the goal is reached. The rover is at the goal.')
  })

  it('are those of the latest landmark when it goes too fast to read', () => {
    const state = toNextLandmark(toStep(stateOf('bug2'), 0))
    const hit = stepInWords(momentAt(state))
    expect(hit).toMatch(/hit point 1/)
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const later = momentAt(toStep(state, steps.indexOf(state.time) + 2))
    expect(landmarkInWords(later)).toBe(hit)
    expect(stepInWords(later)).not.toBe(hit)
    expect(landmarkInWords(momentAt(toStep(state, 1)))).toBe('Bug2 begins.')
  })

  it('tell of a step that is not over yet', () => {
    const state = { ...stateOf('bug2'), time: 2 }
    expect(stepInWords(momentAt(state))).not.toBe('')
  })
})

describe('the numbers of a step', () => {
  it.each(planners.map(({ id }) => id))('of %s stay in their places', (id) => {
    const state = stateOf(id)
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const labels = stepNumbers(momentAt(state)).map(({ label }) => label)
    expect(labels.length).toBeGreaterThan(1)
    expect(new Set(labels).size).toBe(labels.length)
    for (let step = 0; step < steps.length; step += 3) {
      const rows = stepNumbers(momentAt(toStep(state, step)))
      expect(rows.map(({ label }) => label)).toEqual(labels)
      expect(rows.map(({ value }) => value).join()).not.toMatch(/undefined|NaN/)
    }
  })

  it('are those of the frame', () => {
    const rows = Object.fromEntries(
      stepNumbers(momentAt(stateOf('decomposition'))).map(({ label, value }) => [label, value]),
    )
    expect(rows).toMatchObject({ Phase: 'Path', Cost: '7' })
  })

  it('tell on which side the boundary is, of planners with a rover only', () => {
    const boundary = (moment: Moment) =>
      stepNumbers(moment).find(({ label }) => label === 'Boundary')?.value
    const begin = toStep(stateOf('bug2'), 0)
    const hit = momentAt(toNextLandmark(begin))
    expect(boundary(momentAt(begin))).toBe('not followed')
    expect(boundary(hit)).toBe('on the left')
    expect(boundary({ ...hit, frame: { ...hit.frame, turn: 1 } })).toBe('on the right')
    expect(boundary(momentAt(stateOf('decomposition')))).toBeUndefined()
  })

  it('say that a roadmap has more edges than are on the tape', () => {
    const state = stateOf('visibility-graph')
    const moment = momentAt(state)
    const cut = { ...moment, frame: { ...moment.frame, edgesCut: true } }
    const edges = (at: Moment) => stepNumbers(at).find(({ label }) => label === 'Edges')?.value
    expect(edges(moment)).toMatch(/^\d+$/)
    expect(edges(cut)).toBe(`more than ${edges(moment)}`)
    const { problem } = state.setup
    const start = (at: Moment) => cellFactsInWords(at, problem, problem.start)
    expect(start(moment)).toMatch(/ertex with \d edges?/)
    expect(start(cut)).toMatch(/ertex with at least \d edges?/)
  })

  it('say "none" where the rover is not on the m-line', () => {
    const state = toNextLandmark(toStep(stateOf('bug2'), 0))
    const values = (time: number) => {
      const rows = stepNumbers(momentAt({ ...state, time }))
      return rows.find(({ label }) => label === 'Cell of the m-line')?.value
    }
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const seen = new Set(Array.from(steps, values))
    expect(seen).toContain('none')
    expect(seen).toContain('4')
    expect(seen).not.toContain('-1')
  })

  it('of a field with memory leave out what was visited, and say "none" in a dead end', () => {
    const state = stateOf('potential-field-memory', 'S..#G\n#####')
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const lowest = Array.from(steps, (_, step) =>
      stepNumbers(momentAt(toStep(state, step))).find(
        ({ label }) => label === 'Lowest potential to choose from',
      ),
    )
    const told = lowest.map((row) => row?.value)
    expect(Array.from(new Set(told))).toEqual(['–', '39', '34', 'none'])
  })

  it.each([
    ['bug1', 'Distance to the goal', ['13', '8']],
    ['bug1', 'Least distance on this boundary', ['13', '8']],
    ['tangent-bug', 'd_reach', ['13', '8']],
    ['tangent-bug', 'd_followed', ['12', '7']],
  ])('of %s are those of this boundary from its hit point on: %s', (id, label, values) => {
    const state = stateOf(id, maps.fig11)
    const { steps } = timelineOf(momentAt(state).shown.tape)
    const hits = Array.from(steps, (_, step) => momentAt(toStep(state, step))).filter((moment) =>
      stepInWords(moment).includes('hit point'),
    )
    const value = (moment: Moment) => stepNumbers(moment).find((row) => row.label === label)?.value
    expect(hits.map(value)).toEqual(values)
  })

  it.each([
    [3, '3'],
    [999, '999'],
    [1000, '1,000'],
    [-123456, '-123,456'],
    [-1.5, '-1.5'],
    [Math.SQRT2, '1.41'],
    [12345.678, '12,345.68'],
    [1e7, '10,000,000'],
    [Number.POSITIVE_INFINITY, '∞'],
    [Number.NEGATIVE_INFINITY, '−∞'],
    [Number.NaN, '–'],
  ])('are short: %d', (number, words) => {
    expect(numberInWords(number)).toBe(words)
  })
})

describe('a loop', () => {
  const state = stateOf('bug2', SPIRAL)
  const moment = momentAt(state)

  it('is told at the end and one step before it, and nowhere else', () => {
    expect(moment.shown.outcome.status).toBe('loop')
    const last = timelineOf(moment.shown.tape).steps.length - 1
    const began = Array.from({ length: last + 1 }, (_, step) =>
      loopBegan(momentAt(toStep(state, step))),
    )
    expect(began.slice(0, -2).every((step) => step === null)).toBe(true)
    expect(began.at(-1)).not.toBeNull()
    expect(began.at(-2)).toBe(began.at(-1))
  })

  it('began where the rover stood at the same place', () => {
    const before = momentAt(toStep(state, loopBegan(moment) ?? -1))
    expect(before.frame.rover).toBe(moment.frame.rover)
    expect(moment.shown.outcome.reason).toContain(`after ${before.frame.trail.length - 1} steps`)
  })
})

describe('what is known of a cell, in words', () => {
  it('is empty where nothing is known', () => {
    const first = momentAt(toStep(stateOf('decomposition'), 0))
    expect(cellFactsInWords(first, stateOf('decomposition').setup.problem, 3)).toBe('')
  })

  it('is one sentence', () => {
    const words = (id: string, cell: number, text = MAP) => {
      const state = stateOf(id, text)
      return cellFactsInWords(momentAt(state), state.setup.problem, cell)
    }
    expect(words('decomposition', 1)).toBe('Vertex; closed, cost 1 by way of (0, 0).')
    expect(words('decomposition', 0)).toBe('Cell 0 of the path; vertex; closed, cost 0.')
    // (1, 1) is an obstacle, and no vertex of the grid's graph.
    expect(words('decomposition', 6)).toBe('')
    expect(words('bug2', 6)).toMatch(
      /^Cell 1 of the m-line; at its side while it followed the boundary; sensed /,
    )
    expect(words('potential-field', 24)).toMatch(/^Attraction 0; repulsion 0; potential 0/)
    expect(words('bug2', 0)).toMatch(/^Hit point 1; cell 0 of the m-line; stood on after 0 steps;/)
    // The latest three times of three, and of four.
    expect(words('bug1', 81, maps.fig12)).toMatch(/^Stood on after \d+, \d+, \d+ steps; /)
    expect(words('bug1', 213, maps.banner)).toMatch(
      /^Stood on after \d+, \d+, \d+ steps \(4 times\);/,
    )
  })
})
