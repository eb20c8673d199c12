import { describe, expect, it } from 'vitest'
import type { ParamSettings } from '../../src/algorithms/params'
import { plan } from '../../src/algorithms/plan'
import { planners } from '../../src/algorithms/planners'
import { problemFromText } from '../../src/grid/text-map'
import { type CellFacts, cellFacts } from '../../src/trace/cell-facts'
import { KNOWN, SEARCH } from '../../src/trace/cell-state'
import { EVENT, EVENT_NAMES } from '../../src/trace/events'
import { frameAt } from '../../src/trace/fold'
import { knownOf, searchOf } from '../../src/trace/frame'
import { Tape } from '../../src/trace/tape'
import { withOpened, written } from './written'

const problem = problemFromText(
  [
    'S....#....',
    '..##.#.##.',
    '..#..#..#.',
    '.##.##..#.',
    '....#...#G',
    '..#...#.#.',
    '..#...#...',
  ].join('\n'),
)
const cells = problem.grid.walls.length

/** Each planner, and the searches of the one that has several. */
const runs: readonly (readonly [id: string, params: ParamSettings])[] = [
  ...planners.map(({ id }) => [id, {}] as const),
  ...['dijkstra', 'a-star', 'jump-point'].map(
    (search) => ['decomposition', { search, cost: 'euclidean' }] as const,
  ),
]

function tapeOf(plannerId: string, params: ParamSettings): Tape {
  const tape = new Tape()
  plan(problem, plannerId, { tape, params })
  return tape
}

/** The first `time` events as words, so that the facts can be read off once more, another way. */
function eventsOf(tape: Tape, time: number) {
  const first = written(tape).slice(0, time)
  return withOpened(first, tape.width, tape.diagonalCost).map((event) => ({
    ...event,
    kind: EVENT_NAMES[event.kind],
  }))
}

function naiveFacts({ width }: Tape, events: ReturnType<typeof eventsOf>, cell: number): CellFacts {
  const here = events.filter((event) => event.cell === cell)
  const ofKind = (...kinds: string[]) => here.filter(({ kind }) => kinds.includes(kind))
  const last = (...kinds: string[]) => ofKind(...kinds).at(-1)
  const places = (kind: string) =>
    events.filter((event) => event.kind === kind).flatMap((e, i) => (e.cell === cell ? [i] : []))
  const sensedAt = events.findIndex((event) => event.kind === 'sense' && event.cell === cell)
  const walkedBy = events.slice(0, sensedAt).filter(({ kind }) => kind === 'step').length - 1
  const nodesSince = events.findLastIndex(({ kind }) => ['scan', 'hit', 'leave'].includes(kind))
  const nodes = events.slice(nodesSince + 1).filter((e) => e.kind === 'node' && e.cell === cell)
  const row = Math.floor(cell / width)
  const search = last('open', 'close')
  return {
    isVertex:
      ofKind('vertex').length > 0 ||
      events.some((e) => e.kind === 'row' && Math.floor(e.cell / width) === row),
    edges: events.filter((e) => e.kind === 'edge' && [e.cell, e.other].includes(cell)).length,
    search: search ? (search.kind === 'open' ? 'open' : 'closed') : null,
    cost: search?.value ?? null,
    parent: last('open')?.other ?? null,
    attraction: last('attraction')?.value ?? null,
    repulsion: last('repulsion')?.value ?? null,
    potential: last('potential')?.value ?? null,
    sensed: sensedAt < 0 ? null : { isObstacle: events[sensedAt].other === 1, walked: walkedBy },
    isFelt: ofKind('feel').length > 0,
    visits: places('step'),
    onMLine: places('mLine').at(-1) ?? null,
    onPath: places('path').at(-1) ?? null,
    hits: ofKind('hit').map(({ value }) => value),
    leaves: ofKind('leave').map(({ value }) => value),
    node: nodes.at(-1)?.value ?? null,
  }
}

describe('what a planner knows of a cell', () => {
  it.each(runs)('is what the tape of %s %j tells of it', (id, params) => {
    const tape = tapeOf(id, params)
    const stride = Math.max(1, Math.floor(tape.length / 9))
    for (let time = 0; time <= tape.length; time += stride) {
      const frame = frameAt(tape, time)
      const events = eventsOf(tape, time)
      for (let cell = 0; cell < cells; cell++) {
        expect(cellFacts(tape, frame, cell)).toEqual(naiveFacts(tape, events, cell))
      }
    }
  })

  it.each(runs)('agrees with the picture of %s %j', (id, params) => {
    const tape = tapeOf(id, params)
    for (const time of [0, Math.floor(tape.length / 2), tape.length]) {
      const frame = frameAt(tape, time)
      for (let cell = 0; cell < cells; cell++) {
        const facts = cellFacts(tape, frame, cell)
        const search = { open: SEARCH.open, closed: SEARCH.closed, none: SEARCH.untouched }
        expect(searchOf(frame, cell)).toBe(search[facts.search ?? 'none'])
        const known = facts.sensed?.isObstacle ? KNOWN.obstacle : KNOWN.free
        expect(knownOf(frame, cell)).toBe(facts.sensed ? known : KNOWN.unknown)
        expect(frame.hits.filter((hit) => hit === cell).length).toBe(facts.hits.length)
        expect(frame.trail.filter((place) => place === cell).length).toBe(facts.visits.length)
        expect(frame.path.indexOf(cell)).toBe(facts.onPath ?? -1)
        expect(frame.nodes.includes(cell)).toBe(facts.node !== null)
      }
    }
  })

  it('has no way to a cell that a thinned tape only tells to be closed', () => {
    const tape = new Tape()
    tape.begin(3, 2)
    tape.write(EVENT.close, 4, -1, 7)
    const frame = frameAt(tape, tape.length)
    expect([frame.open, frame.closed]).toEqual([0, 1])
    expect(cellFacts(tape, frame, 4)).toMatchObject({ search: 'closed', cost: 7, parent: null })
  })
})
