import { expect, it } from 'vitest'
import { announcement } from '../../src/app/announcer'
import { mapAttributes } from '../../src/app/map-attributes'
import { withMark } from '../../src/app/setup'
import {
  change,
  hidePath,
  planArrived,
  planCancelled,
  planFailed,
  planStarted,
  say,
} from '../../src/app/transitions'
import { planned, stateFrom } from './setups'

const begin = stateFrom('S...\n....\n...G')
const edited = change(begin, withMark(begin.setup, 'goal', 10), 'The goal is now at (2, 2).')
const running = planStarted(edited)
const settled = planArrived(running, planned(edited.setup))

it('what was done is said together with what came of it, once', () => {
  expect(announcement(running, null)).toBeNull()
  expect(announcement(settled, null)).toBe('The goal is now at (2, 2). Reached in 3 cells.')
  expect(announcement(settled, settled.said)).toBeNull()
})

it('what has no plan is said at once', () => {
  expect(announcement(say(running, '(1, 0), free'), running.said)).toBe('(1, 0), free')
  expect(announcement(begin, null)).toBeNull()
})

it('a plan that was cancelled or refused is said to be', () => {
  expect(announcement(planCancelled(running), null)).toBe(
    'The goal is now at (2, 2). Planning was cancelled.',
  )
  const failed = planFailed(running, edited.setup, 'The seed is no number.')
  expect(announcement(failed, null)).toBe(
    'The goal is now at (2, 2). No plan: The seed is no number.',
  )
})

it('the map says of itself where it lies and what came out', () => {
  expect(mapAttributes(settled, false)).toMatchObject({
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
  expect(mapAttributes(running, false).status).toBe('planning')
  expect(mapAttributes(planCancelled(running), false).status).toBe('cancelled')
  expect(mapAttributes(hidePath(settled), false).status).toBe('hidden')
})
