import { expect, test } from 'vitest'
import { EVENT, frameAt, Tape } from '../../src/index'
import { explain } from '../../src/trace/explain'

const [east, southEast, south] = [1 << 2, 1 << 3, 1 << 4]
const CLOSED = 'Of all open ones (4, 5) comes first, with cost 3.414: its shortest path is final.'

test('a cell that A* closes tells what is left from it at least', () => {
  const tape = new Tape()
  tape.begin(10, 10, Math.SQRT2)
  tape.write(EVENT.estimate, 57, 0)
  tape.write(EVENT.close, 34, 0, 4)
  expect(explain(tape, 1, frameAt(tape, 2), [])).toBe(
    'Of all open ones (4, 3) comes first, with cost 4 and at least 3.828 left: its shortest path is final.',
  )
})

test.each([
  ['no neighbour', 0, ''],
  ['neighbours that have events of their own', -1, ''],
  ['one neighbour', east, ' It gives (5, 5) a shorter way.'],
  ['two', east | south, ' It gives (4, 6) and (5, 5) a shorter way.'],
  ['more', east | southEast | south, ' It gives (4, 6), (5, 6) and (5, 5) a shorter way.'],
])('a cell that is closed tells of %s', (_, directions, more) => {
  const tape = new Tape()
  tape.begin(10, 10)
  tape.write(EVENT.close, 54, directions, 2 + Math.SQRT2)
  expect(explain(tape, 0, frameAt(tape, 1), [])).toBe(CLOSED + more)
})
