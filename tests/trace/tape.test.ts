import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { EVENT, Tape, type TapeColumns } from '../../src/index'
import { type Event, events, HEIGHT, tapeOf, WIDTH } from './arbitraries'

const written = (tape: TapeColumns): Event[] =>
  Array.from({ length: tape.length }, (_, i) => ({
    kind: tape.kinds[i] as Event['kind'],
    line: tape.lines[i],
    cell: tape.cells[i],
    other: tape.others[i],
    value: tape.values[i],
  }))

test('what is written is on the tape, in order, with the line it was written at', () => {
  fc.assert(
    fc.property(events, (list) => {
      expect(written(tapeOf(list))).toEqual(list)
    }),
  )
})

test('without a second cell and a value an event holds -1 and 0', () => {
  const tape = new Tape()
  tape.begin(2, 2)
  tape.write(EVENT.vertex, 3)
  expect(written(tape)).toEqual([{ kind: EVENT.vertex, line: 0, cell: 3, other: -1, value: 0 }])
})

test('nothing is lost when the tape grows', () => {
  const tape = new Tape()
  tape.begin(100, 100)
  const room = tape.kinds.length
  const list = Array.from({ length: 4 * room + 1 }, (_, i) => ({
    kind: EVENT.open,
    line: i % 7,
    cell: i,
    other: i - 1,
    value: i / 3,
  }))
  for (const e of list) tape.at(e.line).write(e.kind, e.cell, e.other, e.value)
  expect(tape.length).toBe(list.length)
  expect(written(tape)).toEqual(list)
})

test('a tape that begins anew has forgotten all', () => {
  const tape = tapeOf([{ kind: EVENT.step, line: 3, cell: 1, other: 0, value: 2 }])
  tape.begin(7, 8)
  expect([tape.width, tape.height, tape.length, tape.line]).toEqual([7, 8, 0, 0])
  tape.write(EVENT.step, 5)
  expect(written(tape)).toEqual([{ kind: EVENT.step, line: 0, cell: 5, other: -1, value: 0 }])
})

describe('release', () => {
  test('gives the events, in little more room than they need, and all buffers to transfer', () => {
    fc.assert(
      fc.property(events, (list) => {
        const { columns, buffers } = tapeOf(list).release()
        expect([columns.width, columns.height, columns.length]).toEqual([
          WIDTH,
          HEIGHT,
          list.length,
        ])
        expect(written(columns)).toEqual(list)
        const { kinds, lines, cells, others, values } = columns
        for (const column of [kinds, lines, cells, others, values]) {
          expect(column.length).toBeGreaterThanOrEqual(list.length)
          expect(column.length).toBeLessThanOrEqual(2 * list.length)
          expect(buffers).toContain(column.buffer)
        }
        expect(new Set(buffers).size).toBe(5)
      }),
    )
  })

  test('what was released can be transferred; the tape is empty and can be written on', () => {
    const list = [{ kind: EVENT.step, line: 1, cell: 4, other: 3, value: 0.5 }] as const
    const tape = tapeOf(list)
    const { columns, buffers } = tape.release()
    const received = Tape.from(structuredClone(columns, { transfer: buffers }))
    expect(columns.kinds.length).toBe(0)
    expect(written(received)).toEqual(list)
    tape.at(2).write(EVENT.step, 5, 4)
    expect(written(tape).map((e) => e.cell)).toEqual([5])
    expect(received.length).toBe(1)
  })

  test('a tape made from columns can be written on', () => {
    fc.assert(
      fc.property(events, events, (before, after) => {
        const tape = Tape.from(tapeOf(before).release().columns)
        expect(tape).toBeInstanceOf(Tape)
        for (const e of after) tape.at(e.line).write(e.kind, e.cell, e.other, e.value)
        expect(written(tape)).toEqual([...before, ...after])
      }),
    )
  })
})

describe('a tape with more events than it has room for', () => {
  /** Searches on a map of 9 cells until so many events are written. */
  const long = (count: number, most: number): Tape => {
    const tape = new Tape(most)
    tape.begin(3, 3)
    for (let i = 0; i < count; i++) {
      if (i % 3 === 2) tape.at(1).write(EVENT.close, i % 9, -1, i)
      else tape.at(2).write(EVENT.open, i % 9, (i + 1) % 9, i)
    }
    tape.write(EVENT.end, 5, 0)
    return tape
  }
  const kindsOf = (tape: TapeColumns) => new Set(written(tape).map(({ kind }) => kind))

  test('keeps all as long as it can', () => {
    const tape = long(1999, 2000)
    expect([tape.thinning, tape.length]).toEqual(['whole', 2000])
  })

  test('leaves out small events then, those before and those after', () => {
    const tape = long(2700, 2000)
    expect(tape.thinning).toBe('thinned')
    expect(kindsOf(tape)).toEqual(new Set([EVENT.close, EVENT.end]))
    const closed = Array.from({ length: 900 }, (_, i) => 3 * i + 2)
    const end = { kind: EVENT.end, line: 1, cell: 5, other: 0, value: 0 }
    expect(written(tape)).toEqual([
      ...closed.map((i) => ({ kind: EVENT.close, line: 1, cell: i % 9, other: -1, value: i })),
      end,
    ])
  })

  test('is cut if that is not enough, but says how it ended', () => {
    const tape = long(9000, 2000)
    expect([tape.thinning, tape.length]).toEqual(['cut', 2000])
    expect(written(tape).at(-1)?.kind).toBe(EVENT.end)
    expect(written(tape).at(-2)).toEqual({
      kind: EVENT.close,
      line: 1,
      cell: (3 * 1998 + 2) % 9,
      other: -1,
      value: 3 * 1998 + 2,
    })
  })

  test('knows where it comes from a worker, and begins anew whole', () => {
    const tape = Tape.from(long(2700, 2000).release().columns)
    tape.write(EVENT.open, 1)
    expect([tape.thinning, tape.length]).toEqual(['thinned', 901])
    tape.begin(3, 3)
    tape.write(EVENT.open, 1)
    expect([tape.thinning, tape.length]).toEqual(['whole', 1])
  })
})

describe('a field', () => {
  const field = Float64Array.from({ length: 9 }, (_, cell) => cell / 3)
  const oneByOne = (most: number, before: number): Tape => {
    const tape = new Tape(most)
    tape.begin(3, 3)
    for (let i = 0; i < before; i++) tape.write(EVENT.open, i % 9)
    return tape.at(4)
  }

  test.each([
    ['with room to grow', 5000, 1020],
    ['on a tape that becomes full, so that small events are left out', 1024, 1020],
  ])('is written as cell by cell, %s', (_, most, before) => {
    for (const kind of [EVENT.potential, EVENT.attraction] as const) {
      const tape = oneByOne(most, before)
      tape.writeField(kind, field)
      const same = oneByOne(most, before)
      for (let cell = 0; cell < 9; cell++) same.write(kind, cell, -1, field[cell])
      expect(written(tape)).toEqual(written(same))
      expect(tape.thinning).toBe(most === 5000 ? 'whole' : 'thinned')
    }
  })
})

test('room that is reserved is there, and what was written stays', () => {
  const list = [{ kind: EVENT.step, line: 1, cell: 4, other: 3, value: 0.5 }] as const
  const tape = tapeOf(list)
  tape.reserve(5000)
  expect(tape.kinds.length).toBe(5001)
  expect(written(tape)).toEqual(list)
  tape.reserve(10)
  expect(tape.kinds.length).toBe(5001)
})
