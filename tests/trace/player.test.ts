import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { EVENT, type EventKind, type Frame, frameAt, Player } from '../../src/index'
import { type Event, events, HEIGHT, tapeOf, WIDTH } from './arbitraries'

/** The picture after some events, each part of it asked of the list on its own. */
function picture(list: readonly Event[]): Frame {
  const all = (kind: EventKind) => list.filter((e) => e.kind === kind)
  const last = (events: readonly Event[], what: 'cell' | 'line'): number =>
    events.at(-1)?.[what] ?? -1
  const perCell = <T>(of: (cell: number) => T): T[] =>
    Array.from({ length: WIDTH * HEIGHT }, (_, cell) => of(cell))
  const lastAt = (cell: number, ...kinds: EventKind[]) =>
    list.findLast((e) => e.cell === cell && kinds.includes(e.kind))
  const cells = (kind: EventKind) => all(kind).map((e) => e.cell)
  const values: number[] = []
  for (const e of all(EVENT.value)) values[e.other] = e.value
  return {
    time: list.length,
    search: Uint8Array.from(
      perCell((cell) => {
        const found = lastAt(cell, EVENT.open, EVENT.close)
        return found === undefined ? 0 : found.kind === EVENT.open ? 1 : 2
      }),
    ),
    known: Uint8Array.from(
      perCell((cell) => {
        const found = lastAt(cell, EVENT.sense)
        return found === undefined ? 0 : found.other === 1 ? 2 : 1
      }),
    ),
    felt: Uint8Array.from(perCell((cell) => (lastAt(cell, EVENT.feel) ? 1 : 0))),
    potential:
      all(EVENT.potential).length === 0
        ? null
        : Float64Array.from(perCell((cell) => lastAt(cell, EVENT.potential)?.value ?? Number.NaN)),
    vertices: cells(EVENT.vertex),
    edges: all(EVENT.edge).flatMap((e) => [e.cell, e.other]),
    mLine: cells(EVENT.mLine),
    hits: cells(EVENT.hit),
    leaves: cells(EVENT.leave),
    trail: cells(EVENT.step),
    path: cells(EVENT.path),
    rover: last(all(EVENT.step), 'cell'),
    target: last(all(EVENT.target), 'cell'),
    values,
    line: last(list, 'line'),
  }
}

test('the frame at any time is the picture of the events before it', () => {
  fc.assert(
    fc.property(events, fc.nat({ max: 60 }), (list, time) => {
      expect(frameAt(tapeOf(list), time)).toEqual(picture(list.slice(0, time)))
    }),
    { numRuns: 500 },
  )
})

describe('a player', () => {
  test('shows the same frame however it came there, forwards and backwards', () => {
    const moves = fc.array(fc.integer({ min: -5, max: 70 }), { minLength: 1, maxLength: 12 })
    fc.assert(
      fc.property(events, moves, (list, times) => {
        const tape = tapeOf(list)
        const player = new Player(tape)
        expect(player.frame).toEqual(picture([]))
        for (const time of times) {
          const clamped = Math.max(0, Math.min(time, list.length))
          expect(player.moveTo(time)).toEqual(picture(list.slice(0, clamped)))
          expect(player.frame).toEqual(frameAt(tape, clamped))
        }
      }),
    )
  })

  test('leaves the frames of its past as they were when it goes back', () => {
    const step = (cell: number): Event => ({ kind: EVENT.step, line: 0, cell, other: -1, value: 0 })
    const player = new Player(tapeOf([step(0), step(1), step(2)]))
    const late = player.moveTo(3)
    player.moveTo(1)
    expect(late.trail).toEqual([0, 1, 2])
    expect(player.frame.trail).toEqual([0])
  })
})
