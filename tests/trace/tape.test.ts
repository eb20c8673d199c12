import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { EVENT, frameAt, InputError, Tape, type TapeData } from '../../src/index'
import { events, HEIGHT, tapeOf, WIDTH } from './arbitraries'
import { kindsOf, written } from './written'

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

/** Longer than a few chunks. */
const LONG = 20_000

test('nothing is lost when the tape grows', () => {
  const tape = new Tape()
  tape.begin(400, 400)
  const list = Array.from({ length: LONG }, (_, i) => ({
    kind: EVENT.open,
    line: i % 7,
    cell: i,
    other: i - 1,
    value: i / 3,
  }))
  for (const e of list) tape.at(e.line).write(e.kind, e.cell, e.other, e.value)
  expect(tape.length).toBe(list.length)
  expect(written(tape)).toEqual(list)
  expect(written(Tape.from(tape.release()))).toEqual(list)
})

test('there is room in an event for the cells of the largest map, and for what is none', () => {
  const last = 2048 * 2048 - 1
  const list = [
    { kind: EVENT.cut, line: 255, cell: last, other: -1, value: Number.POSITIVE_INFINITY },
    { kind: EVENT.edge, line: 0, cell: 0, other: last, value: -1e300 },
    { kind: EVENT.edge, line: 255, cell: -1, other: last, value: 0.1 },
    { kind: EVENT.phase, line: 0, cell: -1, other: -1, value: 0 },
  ]
  expect(written(tapeOf(list))).toEqual(list)
})

test('a tape that begins anew has forgotten all', () => {
  const tape = tapeOf([{ kind: EVENT.step, line: 3, cell: 1, other: 0, value: 2 }])
  tape.begin(7, 8)
  expect([tape.width, tape.height, tape.length, tape.diagonalCost]).toEqual([7, 8, 0, 1])
  tape.write(EVENT.step, 5)
  expect(written(tape)).toEqual([{ kind: EVENT.step, line: 0, cell: 5, other: -1, value: 0 }])
})

const bytesOf = ({ buffers }: TapeData): number =>
  buffers.reduce((sum, { byteLength }) => sum + byteLength, 0)

test('values need room only near those that are not 0', () => {
  const tape = new Tape()
  tape.begin(400, 400)
  for (let i = 0; i < LONG; i++) tape.write(EVENT.close, i, 1, i === LONG / 2 ? 0.5 : 0)
  expect(tape.value(LONG / 2)).toBe(0.5)
  expect(written(tape).filter(({ value }) => value !== 0)).toHaveLength(1)
  const bytes = bytesOf(tape.release())
  expect(bytes).toBeGreaterThan(8 * LONG)
  expect(bytes).toBeLessThan(12 * LONG)
})

test('a chunk that is written on anew keeps no value of before', () => {
  const tape = new Tape()
  tape.begin(9, 9)
  for (let i = 0; i < 5; i++) tape.write(EVENT.edge, i, 0, 7)
  tape.begin(9, 9)
  for (let i = 0; i < 3; i++) tape.write(EVENT.edge, i, 0, i % 2)
  expect(written(tape).map(({ value }) => value)).toEqual([0, 1, 0])
})

describe('release', () => {
  test('gives the events, in no more room than they need', () => {
    fc.assert(
      fc.property(events, (list) => {
        const data = tapeOf(list).release()
        expect([data.width, data.height, data.length]).toEqual([WIDTH, HEIGHT, list.length])
        const hasValues = list.some(({ value }) => value !== 0)
        expect(bytesOf(data)).toBe((hasValues ? 16 : 8) * list.length)
        expect(written(Tape.from(data))).toEqual(list)
      }),
    )
  })

  test('what was released can be transferred; the tape is empty and can be written on', () => {
    const list = [{ kind: EVENT.step, line: 1, cell: 4, other: 3, value: 0.5 }] as const
    const tape = tapeOf(list)
    tape.diagonalCost = Math.SQRT2
    const data = tape.release()
    const received = Tape.from(structuredClone(data, { transfer: data.buffers }))
    expect(data.buffers[0].byteLength).toBe(0)
    expect(written(received)).toEqual(list)
    expect([received.width, received.height]).toEqual([WIDTH, HEIGHT])
    expect(received.diagonalCost).toBe(Math.SQRT2)
    tape.at(2).write(EVENT.step, 5, 4)
    expect(written(tape).map((e) => e.cell)).toEqual([5])
    expect(received.length).toBe(1)
  })

  test('a tape made of what was released can be written on', () => {
    fc.assert(
      fc.property(events, events, (before, after) => {
        const tape = Tape.from(tapeOf(before).release())
        expect(tape).toBeInstanceOf(Tape)
        for (const e of after) tape.at(e.line).write(e.kind, e.cell, e.other, e.value)
        expect(written(tape)).toEqual([...before, ...after])
      }),
    )
  })
})

describe('the last event near a cell', () => {
  const cells = fc.nat({ max: WIDTH * HEIGHT - 1 })
  test('is found, and none that is too late or too far', () => {
    const reaches = fc.nat({ max: 10 })
    const times = fc.nat({ max: 60 })
    fc.assert(
      fc.property(events, times, cells, reaches, (list, time, cell, reach) => {
        const before = Math.min(time, list.length)
        const isIt = (i: number) => list[i].kind % 3 === 0
        const expected = list.findLastIndex(
          (e, i) => i < before && Math.abs(e.cell - cell) <= reach && isIt(i),
        )
        expect(tapeOf(list).findLast(before, cell, reach, isIt)).toBe(expected)
      }),
    )
  })

  test('is found on a long tape', () => {
    const tape = new Tape()
    tape.begin(10, 10)
    for (let i = 0; i < LONG; i++) tape.write(EVENT.open, i === 12_345 ? 7 : 50 + (i % 50))
    expect(tape.findLast(LONG, 7, 11, () => true)).toBe(12_345)
    expect(tape.findLast(12_345, 7, 11, () => true)).toBe(-1)
    expect(tape.findLast(LONG, 99, 0, () => true)).toBe(LONG - 1)
  })
})

describe.each([
  ['fewer than in a chunk', 2000],
  ['more than in several chunks', 20_000],
])('a tape that may have %s', (_, most) => {
  /** Searches on a map of 9 cells until so many events are written. */
  const long = (count: number): Tape => {
    const tape = new Tape(most)
    tape.begin(3, 3)
    for (let i = 0; i < count; i++) {
      if (i % 3 === 2) tape.at(1).write(EVENT.close, i % 9, -1, i)
      else tape.at(2).write(EVENT.open, i % 9, (i + 1) % 9, i)
    }
    tape.write(EVENT.end, 5, 0)
    return tape
  }

  test('keeps all as long as it can', () => {
    const tape = long(most - 1)
    expect([tape.thinning, tape.length]).toEqual(['whole', most])
  })

  test('leaves out small events then, those before and those after', () => {
    const tape = long(1.35 * most)
    expect(tape.thinning).toBe('thinned')
    expect(new Set(kindsOf(tape))).toEqual(new Set([EVENT.close, EVENT.end]))
    const closed = Array.from({ length: 0.45 * most }, (_, i) => 3 * i + 2)
    const end = { kind: EVENT.end, line: 1, cell: 5, other: 0, value: 0 }
    expect(written(tape)).toEqual([
      ...closed.map((i) => ({ kind: EVENT.close, line: 1, cell: i % 9, other: -1, value: i })),
      end,
    ])
  })

  test('is cut if that is not enough, but says how it ended', () => {
    const tape = long(4.5 * most)
    expect([tape.thinning, tape.length]).toEqual(['cut', most])
    expect(written(tape).at(-1)?.kind).toBe(EVENT.end)
    expect(written(tape).at(-2)).toEqual({
      kind: EVENT.close,
      line: 1,
      cell: (3 * (most - 2) + 2) % 9,
      other: -1,
      value: 3 * (most - 2) + 2,
    })
  })

  test('knows where it comes from a worker, and begins anew whole', () => {
    const tape = Tape.from(long(1.35 * most).release())
    tape.write(EVENT.open, 1)
    expect([tape.thinning, tape.length]).toEqual(['thinned', 0.45 * most + 1])
    tape.begin(3, 3)
    tape.write(EVENT.open, 1)
    expect([tape.thinning, tape.length]).toEqual(['whole', 1])
  })
})

test.each([0, -1, 1.5, Number.NaN])('no tape has room for %d events', (most) => {
  expect(() => new Tape(most)).toThrow(InputError)
})

test.each([-1, 0.5, Number.NaN])('there is no frame of the moment %d', (time) => {
  const tape = tapeOf([])
  expect(() => frameAt(tape, time)).toThrow(InputError)
  expect(() => frameAt(tape, time)).toThrow(`The moment ${time} is not a whole number`)
})
