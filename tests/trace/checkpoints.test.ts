import { expect, test } from 'vitest'
import { EVENT, Tape } from '../../src/index'
import { foldWhole } from '../../src/trace/checkpoints'

test('checkpoints of large frames are fewer: all together have 48 MiB, and the last one', () => {
  const tape = new Tape()
  tape.begin(2048, 2048)
  for (let cell = 0; cell < 200; cell++) tape.write(EVENT.vertex, cell)
  const { checkpoints } = foldWhole(tape, 10, 5)
  // 4 MiB each: 12 of 20.
  const first = Array.from({ length: 12 }, (_, i) => 10 * (i + 1))
  expect(checkpoints.map(({ time }) => time)).toEqual([...first, 195])
})

test('what their fields take counts, too', () => {
  const tape = new Tape()
  tape.begin(512, 512)
  tape.write(EVENT.potential, 0, -1, 1)
  for (let cell = 1; cell < 400; cell++) tape.write(EVENT.vertex, cell)
  const { checkpoints } = foldWhole(tape, 10, 5)
  // 2.25 MiB each: 21 of 40.
  const first = Array.from({ length: 21 }, (_, i) => 10 * (i + 1))
  expect(checkpoints.map(({ time }) => time)).toEqual([...first, 395])
})
