import { expect } from 'vitest'
import { openMap } from '../../../src/grid/formats/open-map'
import { InputError } from '../../../src/index'

/** Refused with this in the message, as bad input and not as a bug. */
export function mustRefuse(text: string, message: string): void {
  expect(() => openMap(text)).toThrow(InputError)
  expect(() => openMap(text)).toThrow(message)
}

/** A sound project file of a 3 × 2 map, with some of its keys changed. */
export const project = (change: object = {}): string =>
  JSON.stringify({
    format: 'path-planner',
    version: 1,
    diagonal: 'if-at-most-one-obstacle',
    start: [0, 0],
    goal: [2, 1],
    rows: ['..#', '#..'],
    ...change,
  })
