import { describe, expect, it } from 'vitest'
import { withScenario } from '../../src/app/scenario'
import { scenarios } from '../../src/app/scenarios'
import {
  emptyProblem,
  resizedProblem,
  settingsOf,
  valuesOf,
  withParam,
  withSettings,
} from '../../src/app/setup'
import { beginWith, firstSetup } from '../../src/app/start'
import { checkProblem } from '../../src/grid/problem'
import { problemFromText, problemToText } from '../../src/grid/text-map'
import { planned, setupFrom } from './setups'

const RULE = 'if-at-most-one-obstacle'

describe('new maps', () => {
  it.each([
    [2, 2],
    [2, 2048],
    [3, 7],
    [60, 40],
  ])('of %d × %d cells are empty, with start and goal apart', (width, height) => {
    const problem = emptyProblem(width, height, RULE)
    checkProblem(problem)
    expect(problem.grid.walls.includes(1)).toBe(false)
    expect(problem.start).not.toBe(problem.goal)
  })

  it('that are too small or too large are refused in words', () => {
    expect(() => emptyProblem(1, 5, RULE)).toThrow("The map's width is 1")
    expect(() => emptyProblem(5, 2049, RULE)).toThrow("The map's height is 2049")
  })

  it('keep the drawing where it was', () => {
    const drawn = problemFromText('S.#\n.G.')
    expect(problemToText(resizedProblem(drawn, 5, 3))).toBe('S.#..\n.G...\n.....\n')
  })

  it('move a start or goal that is cut off to the nearest free cell', () => {
    const drawn = problemFromText('..#S\n.#..\n...G')
    const cut = resizedProblem(drawn, 3, 2)
    checkProblem(cut)
    expect([cut.start, cut.goal]).toEqual([1, 5])
  })

  it('without a free cell are refused in words', () => {
    const drawn = problemFromText('##S\n##G')
    expect(() => resizedProblem(drawn, 2, 2)).toThrow('no cell is free')
  })
})

describe('settings', () => {
  const setup = setupFrom('S.\n.G', 'bug2')

  it('belong to their planner and stay when another one is chosen', () => {
    const closer = withParam(setup, 'bug2', 'leave', 'closer')
    expect(settingsOf({ ...closer, plannerId: 'bug1' })).toEqual({})
    expect(valuesOf(closer)).toMatchObject({ leave: 'closer', turn: 'left' })
    expect(settingsOf(setup)).toEqual({})
  })

  it('go back to their defaults, one by one and all at once', () => {
    const both = withParam(withParam(setup, 'bug2', 'leave', 'closer'), 'bug2', 'turn', 'right')
    expect(settingsOf(withParam(both, 'bug2', 'leave', undefined))).toEqual({ turn: 'right' })
    expect(settingsOf(withSettings(both, 'bug2', {}))).toEqual({})
  })
})

describe('the beginning', () => {
  it('is a map that is solved already', () => {
    const { outcome } = planned(firstSetup())
    expect(outcome.status).toBe('reached')
    expect(outcome.path.length).toBeGreaterThan(10)
  })

  it('is what was kept, else the first map, with a word if it was broken', () => {
    const setup = setupFrom('S.\n.G')
    expect(beginWith({ kind: 'setup', setup })).toEqual({ setup, isFirstVisit: false, message: '' })
    expect(beginWith({ kind: 'nothing' })).toMatchObject({ isFirstVisit: true, message: '' })
    expect(beginWith({ kind: 'broken' }).message).toContain('could not be read')
  })

  it.each(scenarios.map((scenario) => [scenario.id, scenario] as const))(
    'scenario %s can be planned with its settings, whatever was set before',
    (_, scenario) => {
      const before = {
        ...setupFrom('S.\n.G'),
        params: { [scenario.planner]: { cost: 'nonsense' } },
      }
      const setup = withScenario(before, scenario)
      expect(setup.problem).toBe(scenario.problem)
      expect(() => planned(setup)).not.toThrow()
    },
  )
})
