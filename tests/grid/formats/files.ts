import { expect } from 'vitest'
import { openMap } from '../../../src/grid/formats/open-map'
import { InputError } from '../../../src/index'

/** Refused with this in the message, as bad input and not as a bug. */
export function mustRefuse(text: string, message: string): void {
  expect(() => openMap(text)).toThrow(InputError)
  expect(() => openMap(text)).toThrow(message)
}

/** The whole of a text that comes in parts. */
export const whole = (parts: Iterable<string>): string => [...parts].join('')
