import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { EVENT, type EventKind, type Frame, frameAt, Player, Tape } from '../../src/index'
import { withArrival, withFelt, withKnown } from '../../src/trace/cell-state'
import { foldWhole } from '../../src/trace/checkpoints'
import { type Field, packed } from '../../src/trace/frame'
import { DIRECTIONS } from '../reference/world'
import { type Event, events, HEIGHT, tapeOf, WIDTH } from './arbitraries'
import { withOpened } from './written'

const FIELDS: readonly Field[] = ['attraction', 'repulsion', 'potential']

/** How many steps cells are apart: as the tapes here have it, a diagonal step costs 1. */
const steps = (a: number, b: number): number =>
  Math.max(
    Math.abs((a % WIDTH) - (b % WIDTH)),
    Math.abs(Math.floor(a / WIDTH) - Math.floor(b / WIDTH)),
  )

const directionTo = (from: number, to: number): number =>
  DIRECTIONS.findIndex(([dx, dy]) => to - from === dy * WIDTH + dx)

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
  const lastOf = (...kinds: EventKind[]) => list.findLast((e) => kinds.includes(e.kind))
  const since = (...kinds: EventKind[]) =>
    list.slice(list.findLastIndex((e) => kinds.includes(e.kind)) + 1)
  const fieldOf = (kind: EventKind): Float64Array | null =>
    all(kind).length === 0
      ? null
      : Float64Array.from(perCell((cell) => lastAt(cell, kind)?.value ?? Number.NaN))
  const searched = withOpened(list, WIDTH)
  const search = perCell((cell) => {
    const found = searched.findLast(
      (e) => e.cell === cell && (e.kind === EVENT.open || e.kind === EVENT.close),
    )
    return found === undefined ? 0 : found.kind === EVENT.open ? 1 : 2
  })
  const known = perCell((cell) => {
    const found = lastAt(cell, EVENT.sense)
    return found === undefined ? 0 : found.other === 1 ? 2 : 1
  })
  const isFelt = perCell((cell) => lastAt(cell, EVENT.feel) !== undefined)
  const field = lastOf(EVENT.attraction, EVENT.repulsion, EVENT.potential)
  const test = since(EVENT.phase).findLast((e) => e.kind === EVENT.test)
  const refusal = since(EVENT.phase, EVENT.edge).findLast((e) => e.kind === EVENT.refuse)
  const values: number[] = []
  let estimate: Frame['estimate'] = null
  for (const e of list) {
    if (e.kind === EVENT.estimate) estimate = { goal: e.cell, variable: e.other }
    if (e.kind === EVENT.value) values[e.other] = e.value
  }
  const root = all(EVENT.close).at(0)?.cell ?? -1
  const arrivals = new Map(
    searched
      .filter((e) => e.kind === EVENT.open && !list.includes(e))
      .map(({ cell, other }) => [cell, directionTo(other, cell)]),
  )
  /** Each step costs 1 here. A way that leads nowhere is followed for as many steps as there are cells. */
  const costOf = ({ kind, cell, other, value }: Event): number => {
    if (kind !== EVENT.close || other < 0) return value
    let at = cell
    let steps = 0
    for (; at !== root && steps < WIDTH * HEIGHT; steps++) {
      const [dx, dy] = DIRECTIONS[arrivals.get(at) ?? 0]
      at -= dy * WIDTH + dx
    }
    return steps
  }
  const closed = lastOf(EVENT.close)
  if (estimate && closed) {
    values[estimate.variable] = costOf(closed) + steps(closed.cell, estimate.goal)
  }
  const opened = lastOf(EVENT.open, EVENT.close)
  return {
    time: list.length,
    phase: lastOf(EVENT.phase)?.other ?? -1,
    open: search.filter((state) => state === 1).length,
    closed: search.filter((state) => state === 2).length,
    cost: opened ? costOf(opened) : 0,
    searchedBy: opened ? list.lastIndexOf(opened) : -1,
    closedBy: closed ? list.lastIndexOf(closed) : -1,
    root,
    rows: all(EVENT.row).length,
    fields: {
      attraction: fieldOf(EVENT.attraction),
      repulsion: fieldOf(EVENT.repulsion),
      potential: fieldOf(EVENT.potential),
    },
    field: FIELDS.find((name) => EVENT[name] === field?.kind) ?? null,
    test: test ? { cell: test.cell, obstacle: test.other, passed: test.value === 1 } : null,
    refusal: refusal ? { from: refusal.cell, to: refusal.other, at: refusal.value } : null,
    cells: Uint8Array.from(search, (searched, cell) => {
      const state = withArrival(withKnown(searched, known[cell]), arrivals.get(cell) ?? 0)
      return isFelt[cell] ? withFelt(state) : state
    }),
    vertices: Int32Array.from(cells(EVENT.vertex)),
    edges: Int32Array.from(all(EVENT.edge).flatMap((e) => [e.cell, e.other])),
    edgesCut: all(EVENT.cut).length > 0,
    mLine: cells(EVENT.mLine),
    hits: cells(EVENT.hit),
    leaves: cells(EVENT.leave),
    trail: cells(EVENT.step),
    path: cells(EVENT.path),
    nodes: since(EVENT.scan, EVENT.hit, EVENT.leave)
      .filter((e) => e.kind === EVENT.node)
      .map((e) => e.cell),
    rover: last(all(EVENT.step), 'cell'),
    target: last(
      since(EVENT.hit, EVENT.leave).filter((e) => e.kind === EVENT.target),
      'cell',
    ),
    atSide: last(
      since(EVENT.target).filter((e) => e.kind === EVENT.feel),
      'cell',
    ),
    following: lastOf(EVENT.hit, EVENT.leave)?.kind === EVENT.hit,
    turn: lastOf(EVENT.turn)?.other ?? 0,
    values,
    estimate,
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

describe('checkpoints', () => {
  test('are frames of the tape at rising times, none of them far from the one before', () => {
    const lengths = fc.integer({ min: 1, max: 20 })
    fc.assert(
      fc.property(events, lengths, lengths, (list, spacing, before) => {
        const tape = tapeOf(list)
        const beforeEnd = Math.min(before, spacing)
        const { last, checkpoints } = foldWhole(tape, spacing, beforeEnd)
        expect(last).toEqual(picture(list))
        let time = 0
        for (const frame of checkpoints) {
          expect(frame).toEqual(picture(list.slice(0, frame.time)))
          expect(frame.time).toBeGreaterThan(time)
          expect(frame.time - time).toBeLessThanOrEqual(spacing)
          time = frame.time
        }
        expect(list.length - time).toBeLessThanOrEqual(spacing)
        if (list.length > spacing) expect(time).toBe(list.length - beforeEnd)
      }),
    )
  })

  test('share the memory of the lists that may be long', () => {
    const kinds = [EVENT.vertex, EVENT.edge]
    const list = Array.from({ length: 200 }, (_, i) => {
      return { kind: kinds[i % 2], line: 0, cell: 1, other: 2, value: 0 }
    })
    const { last, checkpoints } = foldWhole(tapeOf(list), 20, 10)
    expect(checkpoints.length).toBeGreaterThan(5)
    for (const { vertices, edges } of checkpoints.map(packed)) {
      expect(vertices.buffer).toBe(last.vertices.buffer)
      expect(edges.buffer).toBe(last.edges.buffer)
    }
  })

  test('are fewer where frames are large, but for the one before the end', () => {
    const cells = 1000 * 1000
    const timesWith = (...fields: readonly ('attraction' | 'repulsion' | 'potential')[]) => {
      const tape = new Tape()
      tape.begin(1000, 1000)
      for (const field of fields) tape.write(EVENT[field], cells - 1, -1, 1)
      while (tape.length < 8) tape.write(EVENT.close, 0)
      return foldWhole(tape, 2, 1).checkpoints.map(({ time }) => time)
    }
    expect(timesWith()).toEqual([2, 4, 6, 7])
    // With a field 9 MB each, then with all three 25 MB: 48 MB in all.
    expect(timesWith('attraction')).toEqual([2, 4, 6, 7])
    expect(timesWith('attraction', 'repulsion', 'potential')).toEqual([2, 4, 7])
  })
})

describe('a player', () => {
  test('shows the same frame however it came there, forwards and backwards', () => {
    const some = fc.integer({ min: 1, max: 80 })
    const moves = fc.array(fc.integer({ min: -5, max: 70 }), { minLength: 1, maxLength: 12 })
    fc.assert(
      fc.property(events, moves, some, some, some, (list, times, reach, spacing, beforeEnd) => {
        const tape = tapeOf(list)
        const { checkpoints } = foldWhole(tape, spacing, Math.min(beforeEnd, spacing))
        const player = new Player(tape, checkpoints.map(packed), reach)
        expect(player.frame).toEqual(picture([]))
        for (const time of times) {
          const clamped = Math.max(0, Math.min(time, list.length))
          expect(player.moveTo(time)).toEqual(picture(list.slice(0, clamped)))
        }
      }),
      { numRuns: 200 },
    )
  })

  test.each([0.5, Number.NaN])('has no moment %d', (time) => {
    const player = new Player(tapeOf([]))
    expect(() => player.moveTo(time)).toThrow(`The moment ${time} is not a whole number.`)
  })

  test('comes to a moment a little at a time, and may be called elsewhere on the way', () => {
    const some = fc.integer({ min: 1, max: 20 })
    const moves = fc.array(fc.tuple(fc.nat({ max: 60 }), fc.integer({ min: 1, max: 4 })))
    fc.assert(
      fc.property(
        events,
        moves,
        some,
        some,
        fc.nat({ max: 60 }),
        (list, times, reach, spacing, end) => {
          const tape = tapeOf(list)
          const { checkpoints } = foldWhole(tape, spacing, spacing)
          const player = new Player(tape, checkpoints.map(packed), reach)
          const isUp = () => true
          for (const [time, patience] of times) {
            for (let i = 0; i < patience && !player.approach(time, isUp); i++);
          }
          let calls = 1
          while (!player.approach(end, isUp)) calls++
          expect(player.frame).toEqual(picture(list.slice(0, end)))
          // From the start, or from the checkpoint before, to a frame on the way and on from there.
          expect(calls).toBeLessThanOrEqual(2 + Math.ceil(list.length / reach))
        },
      ),
      { numRuns: 500 },
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
