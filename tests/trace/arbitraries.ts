import fc from 'fast-check'
import { EVENT, EVENT_NAMES, type EventKind, Tape } from '../../src/index'
import { directionsInside } from './written'

export const WIDTH = 6
export const HEIGHT = 4

export interface Event {
  readonly kind: EventKind
  readonly line: number
  readonly cell: number
  readonly other: number
  readonly value: number
}

/** The variable of the estimate: a planner writes no other value of it. */
const ESTIMATED = WIDTH * HEIGHT

const cells = fc.nat({ max: WIDTH * HEIGHT - 1 })

/**
 * Any event as a planner may write it: those that have no cell carry -1, and those that close a cell
 * the directions of some of its neighbours.
 */
const event: fc.Arbitrary<Event> = fc
  .record({
    name: fc.constantFrom(...EVENT_NAMES),
    line: fc.nat({ max: 20 }),
    cell: cells,
    other: cells,
    directions: fc.nat({ max: 255 }),
    outside: fc.boolean(),
    value: fc.oneof(
      fc.integer(),
      fc.constant(Number.POSITIVE_INFINITY),
      fc.double({ noNaN: true }),
    ),
  })
  .map(({ name, line, cell, other, directions, outside, value }) => {
    const noCell = name === 'value' || (outside && (name === 'feel' || name === 'target'))
    const small = name === 'sense' || name === 'turn' ? other % 2 : other
    const opened = outside ? -1 : directions & directionsInside(cell, WIDTH, HEIGHT)
    const second = name === 'close' ? opened : name === 'estimate' ? ESTIMATED : small
    return { kind: EVENT[name], line, cell: noCell ? -1 : cell, other: second, value: value + 0 }
  })

export const events = fc.array(event, { maxLength: 60 })

export function tapeOf(events: readonly Event[]): Tape {
  const tape = new Tape()
  tape.begin(WIDTH, HEIGHT)
  for (const { kind, line, cell, other, value } of events) {
    tape.at(line).write(kind, cell, other, value)
  }
  return tape
}
