import { describe, expect, it } from 'vitest'
import { Moments } from '../../../src/app/playback/moment'
import { timelineOf } from '../../../src/app/playback/timeline'
import {
  played,
  stepForward,
  togglePlay,
  toNextLandmark,
  toStep,
} from '../../../src/app/playback/transport'
import { withMark } from '../../../src/app/state/setup'
import type { State } from '../../../src/app/state/state'
import {
  change,
  hidePath,
  planArrived,
  planCancelled,
  planFailed,
  planIsSlow,
  planStarted,
  say,
} from '../../../src/app/state/transitions'
import { mapKey } from '../../../src/app/tools/keys'
import { announcement, announcer } from '../../../src/app/words/announcer'
import { mapAttributes } from '../../../src/app/words/map-attributes'
import { planned, setupFrom, stateFrom } from '../setups'

const begin = stateFrom('S...\n....\n...G')
const edited = change(begin, withMark(begin.setup, 'goal', 10), 'The goal is now at (2, 2).')
const running = planStarted(edited)
const settled = planArrived(running, planned(edited.setup))

it('what was done is said together with what came of it, once', () => {
  expect(announcement(running, null, null)).toBeNull()
  expect(announcement(settled, null, null)).toBe('The goal is now at (2, 2). Reached in 3 cells.')
  expect(announcement(settled, null, settled.said)).toBeNull()
})

it('the same words are said again if they are meant again, as others or not at all', () => {
  const region = { textContent: '' }
  const announce = announcer(region)
  const heard: string[] = []
  const first = say(begin, 'Nothing to undo.')
  for (const state of [
    begin,
    first,
    first,
    say(first, 'Nothing to undo.'),
    say(first, 'Undone.'),
  ]) {
    announce(state, null)
    heard.push(region.textContent)
  }
  const again = 'Nothing to undo.\u00a0'
  expect(heard).toEqual(['', 'Nothing to undo.', 'Nothing to undo.', again, 'Undone.'])
})

it('what has no plan is said at once', () => {
  expect(announcement(say(running, '(1, 0), free'), null, running.said)).toBe('(1, 0), free')
  expect(announcement(begin, null, null)).toBeNull()
  const wordless = { ...settled, said: { ...settled.said, text: '' } }
  expect(announcement(wordless, null, null)).toBeNull()
})

it('a plan that was cancelled or refused is said to be', () => {
  expect(announcement(planCancelled(running), null, null)).toBe(
    'The goal is now at (2, 2). Planning was cancelled.',
  )
  const failed = planFailed(running, edited.setup, 'The seed is no number.')
  expect(announcement(failed, null, null)).toBe(
    'The goal is now at (2, 2). No plan: The seed is no number.',
  )
})

it('what came of a long wait is said, even if something else was said meanwhile', () => {
  const meanwhile = say(planIsSlow(running), 'Theme: light.')
  const planner = 'Planner: Grid decomposition.'
  const said = (state: State) => announcement(state, null, meanwhile.said)
  expect(said(planArrived(meanwhile, planned(edited.setup)))).toBe(`${planner} Reached in 3 cells.`)
  expect(said(planCancelled(meanwhile))).toBe(`${planner} Planning was cancelled.`)
  expect(said(planFailed(meanwhile, edited.setup, 'No.'))).toBe(`${planner} No plan: No.`)
  // Of a plan that is there at once nobody expects a word more, nor before anything was done.
  const quick = say(running, 'Theme: light.')
  expect(planArrived(quick, planned(edited.setup)).said).toBe(quick.said)
  const opening = planIsSlow(planStarted(begin))
  expect(announcement(planArrived(opening, planned(begin.setup)), null, null)).toBeNull()
})

it('the map says of itself where it lies and what came out', () => {
  expect(mapAttributes(settled)).toMatchObject({
    left: '0',
    top: '0',
    scale: '40',
    width: '4',
    height: '3',
    start: '0,0',
    goal: '2,2',
    status: 'reached',
    cells: '3',
  })
  expect(mapAttributes(running).status).toBe('planning')
  expect(mapAttributes(planCancelled(running)).status).toBe('cancelled')
  expect(mapAttributes(hidePath(settled)).status).toBe('hidden')
})

/** What is said of a state that came after another one. */
function saidAfter(state: State, before: State): string | null {
  return announcement(state, new Moments().of(state), before.said)
}

/** Bug2 at the beginning of a plan with hit and leave points. */
function bug2AtStart(): State {
  const setup = setupFrom('S...\n.##.\n...G', 'bug2')
  const state = { ...begin, setup, committed: setup }
  return { ...planArrived(state, planned(setup)), time: 0 }
}

describe('steps', () => {
  const start = bug2AtStart()
  const landmark = toNextLandmark(start)

  it('are said as they are taken', () => {
    const first = stepForward(start)
    expect(saidAfter(first, start)).toBe('Start at (0, 0).')
    expect(saidAfter(stepForward(first), first)).toMatch(/^The m-line: /)
  })

  it('are said by landmarks', () => {
    expect(saidAfter(landmark, start)).toMatch(/hit point 1 at .*, follow the boundary/)
  })

  it('of the scrubber are only said at landmarks, because it says the others itself', () => {
    expect(saidAfter(toStep(start, 1), start)).toBeNull()
    const { steps } = timelineOf(planned(start.setup).tape)
    expect(saidAfter(toStep(start, steps.indexOf(landmark.time)), start)).toMatch(/hit point 1/)
  })
})

describe('playing', () => {
  const start = bug2AtStart()
  const at = (speed: 5 | 10 | 'moment') =>
    togglePlay({ ...start, preferences: { ...start.preferences, speed } })
  const landmark = toNextLandmark(start).time
  const end = start.shown?.tape.length ?? 0

  it('says each landmark if it is slow, and no other step', () => {
    const slow = at(5)
    expect(saidAfter(played(slow, 1), slow)).toBeNull()
    expect(saidAfter(played(slow, landmark), slow)).toMatch(/hit point 1/)
  })

  it.each([10, 'moment'] as const)('says nothing before its end at speed %s', (speed) => {
    const fast = at(speed)
    expect(saidAfter(played(fast, landmark), fast)).toBeNull()
    expect(saidAfter(played(fast, end), fast)).toMatch(
      /^The end at \(3, 2\): the goal is reached\./,
    )
  })

  it('of a new plan says nothing: what came out has been said', () => {
    const tempo = { kind: 'whole', duration: 1000, times: 1, pause: 0, asked: false } as const
    const welcomed = { ...start, playing: tempo }
    expect(saidAfter(played(welcomed, landmark), welcomed)).toBeNull()
    expect(saidAfter(played(welcomed, end), welcomed)).toBeNull()
  })

  it('tells that it begins, and where it was stopped', () => {
    expect(saidAfter(at(5), start)).toBe('Playing.')
    const stopped = togglePlay(played(at(10), landmark))
    expect(saidAfter(stopped, start)).toMatch(/hit point 1/)
  })
})

it('of the cell that the cursor moves to, what the planner knows is said', () => {
  const start = bug2AtStart()
  const shown = { ...start, time: Number.POSITIVE_INFINITY, cursorShown: true }
  const moved = mapKey({ key: 'ArrowRight', command: false, shift: false }, true)?.(shown)
  expect(moved && saidAfter(moved, shown)).toMatch(/^\(1, 0\), free\. Sensed from the start\.$/)
})
