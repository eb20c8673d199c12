import { describe, expect, it } from 'vitest'
import { withScenario } from '../../../src/app/scenarios/scenario'
import { scenarios } from '../../../src/app/scenarios/scenarios'
import { beginWith, firstSetup } from '../../../src/app/start'
import { settingsOf, valuesOf, withParam, withSettings } from '../../../src/app/state/setup'
import { planned, setupFrom } from '../setups'

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
