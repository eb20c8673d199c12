import { describe, expect, test } from 'vitest'
import { EVENT, problemFromText, STATUSES, Tape } from '../../src/index'
import { type Trace, traceText } from './posthoc-trace'

const problem = problemFromText('S..\n.#G', 'only-when-no-obstacles')

const info = {
  plannerId: 'planner',
  title: 'The "Planner"',
  phases: ['Look', 'Go'],
  variables: ['d', 'e'],
  problem,
  mapFile: 'my "map".map',
}

type Written = [kind: keyof typeof EVENT, cell?: number, other?: number, value?: number]

function tapeOf(events: readonly Written[]): Tape {
  const tape = new Tape()
  tape.begin(3, 2)
  events.forEach(([kind, ...columns], i) => {
    tape.at(i).write(EVENT[kind], ...columns)
  })
  return tape
}

/** The events after source and destination, without the lines of the pseudocode. */
function written(...events: Written[]): unknown[] {
  const trace: Trace = JSON.parse(traceText(tapeOf(events), info))
  return trace.events.slice(2).map(({ line, ...event }) => event)
}

describe('the events of a trace', () => {
  test('begin with start and goal, and what the trace is of', () => {
    const trace: Trace = JSON.parse(traceText(tapeOf([]), info))
    expect(trace.events).toEqual([
      {
        type: 'source',
        id: '0,0',
        x: 0,
        y: 0,
        planner: 'planner',
        title: 'The "Planner"',
        map: 'my "map".map',
        diagonal: 'only-when-no-obstacles',
      },
      { type: 'destination', id: '2,1', x: 2, y: 1 },
    ])
    expect(trace.pivot).toEqual({
      x: '$'.concat('{{ $.x + 0.5 }}'),
      y: '$'.concat('{{ $.y + 0.5 }}'),
      scale: 1,
    })
  })

  test('of a search have the id of their cell and of its parent', () => {
    expect(
      written(
        ['phase', -1, 1],
        ['open', 0],
        ['close', 0],
        ['open', 1, 0, 1],
        ['open', 3, 0, 5 / 3],
        ['close', 1, -1, 1],
        ['open', 3, 1, 1.25],
        ['path', 0],
        ['path', 1],
        ['end', 1, STATUSES.indexOf('not-found')],
      ),
    ).toEqual([
      { type: 'phase', id: 'phase 2', name: 'Go' },
      { type: 'generating', id: '0,0', x: 0, y: 0, g: 0 },
      { type: 'expanding', id: '0,0', x: 0, y: 0, g: 0 },
      { type: 'generating', id: '1,0', pId: '0,0', x: 1, y: 0, g: 1 },
      { type: 'generating', id: '0,1', pId: '0,0', x: 0, y: 1, g: 1.666667 },
      { type: 'closing', id: '0,0', x: 0, y: 0, g: 0 },
      { type: 'expanding', id: '1,0', pId: '0,0', x: 1, y: 0, g: 1 },
      { type: 'updating', id: '0,1', pId: '1,0', x: 0, y: 1, g: 1.25 },
      { type: 'closing', id: '1,0', pId: '0,0', x: 1, y: 0, g: 1 },
      { type: 'path', id: 'path 0', x: 0, y: 0 },
      { type: 'path', id: 'path 1', pId: 'path 0', x: 1, y: 0 },
      { type: 'end', id: '1,0', pId: '0,0', x: 1, y: 0, status: 'not-found' },
    ])
  })

  test('of a search over cells have a line for each neighbour that is opened', () => {
    const [east, southEast, south] = [1 << 2, 1 << 3, 1 << 4]
    const least = 'd'
    const tape = tapeOf([
      ['open', 0],
      ['estimate', 2, 0],
      ['close', 0, east + south],
      ['close', 1, southEast],
      ['close', 3, 0],
      ['end', 3, STATUSES.indexOf('unreachable')],
    ])
    tape.diagonalCost = 1.25
    const trace: Trace = JSON.parse(traceText(tape, info))
    const [start, west, below] = [
      { id: '0,0', x: 0, y: 0, g: 0 },
      { id: '1,0', pId: '0,0', x: 1, y: 0, g: 1 },
      { id: '0,1', pId: '0,0', x: 0, y: 1, g: 1 },
    ]
    expect(trace.events.slice(2)).toEqual([
      { type: 'generating', ...start, line: 1 },
      { type: 'expanding', ...start, line: 3, [least]: 2 },
      { type: 'generating', ...below, line: 3 },
      { type: 'generating', ...west, line: 3 },
      { type: 'closing', ...start },
      { type: 'expanding', ...west, line: 4, [least]: 2 },
      { type: 'generating', id: '2,1', pId: '1,0', x: 2, y: 1, g: 2.25, line: 4 },
      { type: 'closing', ...west },
      // From (0, 1) to (2, 0) it is a diagonal step and a straight one.
      { type: 'expanding', ...below, line: 5, [least]: 3.25 },
      { type: 'closing', ...below },
      { type: 'end', id: '0,1', pId: '0,0', x: 0, y: 1, status: 'unreachable', line: 6 },
    ])
  })

  test('of a graph and of fields', () => {
    expect(
      written(
        ['row', 3, 2],
        ['test', 2, 4, 1],
        ['vertex', 2],
        ['edge', 2, 0, 2.5],
        ['cut', 2, -1, 1],
        ['refuse', 2, 3, 4],
        ['refuse', 5, 1, -1],
        ['attraction', 1, -1, 4],
        ['repulsion', 1, -1, Number.POSITIVE_INFINITY],
        ['potential', 1, -1, 1e12],
        ['end', -1, 1],
      ),
    ).toEqual([
      { type: 'row', id: 'row 0,1', x: 0, y: 1, cells: 2 },
      { type: 'test', id: '2,0', x: 2, y: 0, obstacleX: 1, obstacleY: 1, corner: true },
      { type: 'vertex', id: '2,0', x: 2, y: 0 },
      { type: 'edge', id: '2,0-0,0', pId: '2,0', x: 2, y: 0, toX: 0, toY: 0, weight: 2.5 },
      { type: 'cut', id: 'cut', edges: 1 },
      { type: 'refuse', id: '2,0-0,1', pId: '2,0', x: 2, y: 0, toX: 0, toY: 1, atX: 1, atY: 1 },
      { type: 'refuse', id: '2,1-1,0', pId: '2,1', x: 2, y: 1, toX: 1, toY: 0 },
      { type: 'attraction', id: '1,0', x: 1, y: 0, value: 4 },
      { type: 'repulsion', id: '1,0', x: 1, y: 0, value: 'infinite' },
      { type: 'potential', id: '1,0', x: 1, y: 0, value: 1e12 },
      { type: 'end', id: 'end', status: 'unreachable' },
    ])
  })

  test('of the first cell of the map are not of its border', () => {
    const here = { id: 'step 0', x: 1, y: 0 }
    const first = { id: '0,0', pId: 'step 0', x: 0, y: 0 }
    expect(
      written(
        ['step', 1],
        ['hit', 1, 0, 1],
        ['feel', 0],
        ['target', 0, -1, 2],
        ['node', 0, -1, 3],
        ['end', 1, STATUSES.indexOf('loop')],
      ),
    ).toEqual([
      { type: 'step', ...here },
      { type: 'hit', ...here, number: 1, obstacleX: 0, obstacleY: 0 },
      { type: 'feel', ...first },
      { type: 'target', ...first, distance: 2 },
      { type: 'node', ...first, distance: 3 },
      { type: 'end', ...here, status: 'loop' },
    ])
    expect(written(['vertex', 0], ['end', 0, 0])).toMatchObject([{}, { type: 'end', id: '0,0' }])
  })

  test('of a rover have the id of its step, or of what it learned there', () => {
    expect(
      written(
        ['step', 0],
        ['mLine', 0],
        ['mLine', 1],
        ['sense', 4, 1],
        ['value', -1, 1, 0.5],
        ['value', -1, 1, 1 / 3],
        ['step', 1, 0],
        ['hit', 1, 4, 1],
        ['turn', 1, 1],
        ['feel', 4],
        ['feel', -1],
        ['hit', 1, -1, 2],
        ['scan', 1],
        ['node', 2, -1, 7],
        ['target', 2, -1, 7],
        ['target', -1, -1, 3],
        ['node', -1, -1, 4],
        ['around', 1, -1, 9],
        ['leave', 1, -1, 2],
        ['loop', 1, -1, 0],
        ['end', 1, STATUSES.indexOf('loop')],
      ),
    ).toEqual([
      { type: 'step', id: 'step 0', x: 0, y: 0 },
      { type: 'm-line', id: '0,0', x: 0, y: 0 },
      { type: 'm-line', id: '1,0', pId: '0,0', x: 1, y: 0, e: 0.333333 },
      { type: 'sense', id: '1,1', pId: 'step 0', x: 1, y: 1, obstacle: true },
      { type: 'step', id: 'step 1', pId: 'step 0', x: 1, y: 0 },
      {
        type: 'hit',
        id: 'step 1',
        pId: 'step 0',
        x: 1,
        y: 0,
        number: 1,
        obstacleX: 1,
        obstacleY: 1,
        obstacleOn: 'right',
      },
      { type: 'feel', id: '1,1', pId: 'step 1', x: 1, y: 1 },
      { type: 'feel-outside', id: 'step 1', pId: 'step 0', x: 1, y: 0 },
      {
        type: 'hit',
        id: 'step 1',
        pId: 'step 0',
        x: 1,
        y: 0,
        number: 2,
        obstacle: 'the border of the map',
      },
      { type: 'scan', id: 'step 1', pId: 'step 0', x: 1, y: 0 },
      { type: 'node', id: '2,0', pId: 'step 1', x: 2, y: 0, distance: 7 },
      { type: 'target', id: '2,0', pId: 'step 1', x: 2, y: 0, distance: 7 },
      { type: 'target-outside', id: 'step 1', pId: 'step 0', x: 1, y: 0, distance: 3 },
      { type: 'node-outside', id: 'step 1', pId: 'step 0', x: 1, y: 0, distance: 4 },
      { type: 'around', id: 'step 1', pId: 'step 0', x: 1, y: 0, steps: 9 },
      { type: 'leave', id: 'step 1', pId: 'step 0', x: 1, y: 0, number: 2 },
      { type: 'loop', id: 'step 1', pId: 'step 0', x: 1, y: 0, since: 0 },
      { type: 'end', id: 'step 1', pId: 'step 0', x: 1, y: 0, status: 'loop' },
    ])
  })

  test('name their line of the pseudocode, counted from 1', () => {
    const tape = tapeOf([
      ['open', 0],
      ['open', 1, 0, 1],
    ])
    const { events }: Trace = JSON.parse(traceText(tape, info))
    expect(events.map(({ line }) => line)).toEqual([undefined, undefined, 1, 2])
  })
})
