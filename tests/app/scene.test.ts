import { describe, expect, it } from 'vitest'
import { Moments } from '../../src/app/playback/moment'
import { toStep } from '../../src/app/playback/transport'
import { sceneOf } from '../../src/app/scene'
import type { State } from '../../src/app/state/state'
import { edit, hidePath, prefer } from '../../src/app/state/transitions'
import { themes } from '../../src/render/theme'
import { HOOK, shownState } from './setups'

const sceneAt = (state: State) => sceneOf(state, new Moments().of(state), themes.light)

describe('what is drawn', () => {
  const bug2 = shownState(HOOK)
  const field = shownState(HOOK, 'potential-field')

  it('is the map on screen and the plan at the moment of the cursor, in the theme', () => {
    const state = toStep(bug2, 4)
    const { problem, theme, plan } = sceneAt(state)
    expect([problem, theme]).toEqual([bug2.setup.problem, themes.light])
    expect(plan?.tape).toBe(bug2.shown.tape)
    expect(plan?.frame.time).toBe(state.time)
    expect(sceneAt(hidePath(bug2)).plan).toBeNull()
  })

  it('has the keyboard’s cell while that is on show, and the one under the mouse', () => {
    const pointed = { ...bug2, cursor: 7, hovered: 3 }
    expect(sceneAt(pointed)).toMatchObject({ cursor: -1, hovered: 3 })
    expect(sceneAt({ ...pointed, cursorShown: true })).toMatchObject({ cursor: 7, hovered: 3 })
  })

  it('has the sensor of the planner whose plan is on screen', () => {
    expect(sceneAt(bug2).sensorRange).toBe(1)
    expect(sceneAt(field).sensorRange).toBe(0)
    const tangent = shownState(HOOK, 'tangent-bug')
    expect(sceneAt(tangent).sensorRange).toBe(2)
    const chosen = edit(tangent, { ...tangent.setup, plannerId: 'bug1' })
    expect(sceneAt(chosen).sensorRange).toBe(2)
    expect(sceneAt(hidePath(chosen)).sensorRange).toBe(1)
  })

  it('has the potentials of a plan that has any, if they are wanted', () => {
    expect(sceneAt(field).showPotential).toBe(true)
    expect(sceneAt(prefer(field, { showPotential: false })).showPotential).toBe(false)
    expect(sceneAt(bug2).showPotential).toBe(false)
    expect(sceneAt(hidePath(field)).showPotential).toBe(false)
    expect(sceneAt(prefer(bug2, { sight: 'known' })).sight).toBe('known')
  })
})
