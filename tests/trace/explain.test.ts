import { expect, test } from 'vitest'
import { plannerById } from '../../src/algorithms/plan'
import { maps } from '../../src/app/scenarios/scenario-maps'
import { EVENT, frameAt, type PlanOptions, plan, problemFromText, Tape } from '../../src/index'
import { explain } from '../../src/trace/explain'
import { stepsOf } from '../../src/trace/landmarks'

const [east, southEast, south] = [1 << 2, 1 << 3, 1 << 4]
const CLOSED = 'Of all open ones (4, 5) comes first, with cost 3.414: the way to it is final.'

test('a cell that A* closes tells what is left from it at least', () => {
  const tape = new Tape()
  tape.begin(10, 10, Math.SQRT2)
  tape.write(EVENT.estimate, 57, 0)
  tape.write(EVENT.close, 34, -1, 4)
  expect(explain(tape, 1, frameAt(tape, 2), [])).toBe(
    'Of all open ones (4, 3) comes first, with cost 4 and at least 3.828 left: the way to it is final.',
  )
})

test('large numbers are written as everywhere on the page', () => {
  const tape = new Tape()
  tape.begin(10, 10)
  tape.write(EVENT.close, 54, -1, 12345 + Math.SQRT2)
  expect(explain(tape, 0, frameAt(tape, 1), [])).toBe(
    'Of all open ones (4, 5) comes first, with cost 12,346.414: the way to it is final.',
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
  tape.begin(10, 10, Math.SQRT2)
  tape.write(EVENT.close, 23, southEast)
  tape.write(EVENT.close, 34, south)
  tape.write(EVENT.close, 44, south)
  tape.write(EVENT.close, 54, directions, directions < 0 ? 2 + Math.SQRT2 : 0)
  expect(explain(tape, 3, frameAt(tape, 4), [])).toBe(CLOSED + more)
})

type Written = Parameters<Tape['write']>

/** What is said of a step that is these events, on a map of 10 × 10 cells. */
function sentenceOf(...written: readonly Written[]): string {
  const tape = new Tape()
  tape.begin(10, 10)
  for (const event of written) tape.write(...event)
  return explain(tape, 0, frameAt(tape, tape.length), ['Build', 'Search'])
}

const SENTENCES: readonly (readonly [string, ...Written[]])[] = [
  ['Search.', [EVENT.phase, -1, 1]],
  ['Phase 3.', [EVENT.phase, -1, 2]],
  ['The end at (4, 5): the goal is reached.', [EVENT.end, 54, 0]],
  ['The end at (0, 0): a dead end.', [EVENT.end, 0, 4]],
  ['The end: it is proven that no path exists.', [EVENT.end, -1, 1]],
  ['Row 3: 1 free cell of the graph.', [EVENT.row, 30, 1]],
  ['Row 0: 7 free cells of the graph.', [EVENT.row, 0, 7]],
  [
    '(4, 5), diagonal to obstacle (5, 6): it is free and so are both cells between them, so it is a vertex.',
    [EVENT.test, 54, 65, 1],
  ],
  [
    '(4, 5), diagonal to obstacle (5, 6): not all three cells are free, so it is no corner of this obstacle.',
    [EVENT.test, 54, 65, 0],
  ],
  ['(4, 5) is a vertex of the roadmap.', [EVENT.vertex, 54]],
  [
    'The simplest path from (4, 5) to (0, 0) is free: an edge of cost 6.667.',
    [EVENT.edge, 54, 0, 20 / 3],
  ],
  [
    'There are more than 1,000 edges: those from (4, 5) on are used, but not shown.',
    [EVENT.cut, 54, -1, 1000],
  ],
  [
    'The simplest paths between (4, 5) and (0, 0) are refused, the one from (4, 5) at (3, 4): no edge.',
    [EVENT.refuse, 54, 0, 43],
  ],
  ['Start at (4, 5) with cost 0.', [EVENT.open, 54]],
  ['(4, 5) gets a shorter way, over (0, 0): cost 7.', [EVENT.open, 54, 0, 7]],
  ['The parents lead back from the goal: a path of 2 cells.', [EVENT.path, 0], [EVENT.path, 1]],
  ['Row 5: the attraction is the square of the distance to the goal.', [EVENT.attraction, 50]],
  ['Row 5: the closest obstacle repels where it is within influence.', [EVENT.repulsion, 50]],
  ['Row 5: attraction and repulsion added up.', [EVENT.potential, 50]],
  ['Start at (0, 0).', [EVENT.step, 0]],
  ['Step to (1, 0): the way is free.', [EVENT.step, 1, 0]],
  ['No end of an obstacle is in reach of (4, 5).', [EVENT.scan, 54]],
  ['1 node in reach of (4, 5).', [EVENT.scan, 54], [EVENT.node, 3]],
  ['The m-line: the simplest path from start to goal, 1 cell.', [EVENT.mLine, 0]],
  [
    'The border of the map: hit point 2 at (0, 0), follow the boundary with the obstacle on the right.',
    [EVENT.hit, 0, -1, 2],
    [EVENT.turn, 0, 1],
  ],
  [
    '(0, 0) is an obstacle: hit point 1 at (1, 0), follow the boundary with the obstacle on the left.',
    [EVENT.hit, 1, 0, 1],
    [EVENT.turn, 1, 0],
  ],
  ...(['left', 'right'] as const).map((side, turn): (typeof SENTENCES)[number] => [
    `Step to (9, 5), keeping the border of the map on the ${side}.`,
    [EVENT.step, 59, turn === 0 ? 49 : 69],
    [EVENT.hit, 59, -1, 1],
    [EVENT.turn, 59, turn],
    [EVENT.feel, -1],
  ]),
  ['Round the obstacle once, in 12 steps, and back at (4, 5).', [EVENT.around, 54, -1, 12]],
  [
    'Leave point 3 at (4, 5): of this boundary it is the nearest to the goal.',
    [EVENT.leave, 54, 1, 3],
  ],
  [
    'Loop: the same place and the same state as after 1 step, so the rover goes round for ever.',
    [EVENT.loop, 54, -1, 1],
  ],
]

test('each event has its sentence', () => {
  for (const [sentence, ...events] of SENTENCES) expect(sentenceOf(...events)).toBe(sentence)
})

/** What is said of each step of a plan. */
function told(map: string, plannerId: string, params: PlanOptions['params'] = {}): string[] {
  const tape = new Tape()
  plan(problemFromText(map), plannerId, { params, tape })
  const { phases } = plannerById(plannerId)
  const steps = Array.from(stepsOf(tape))
  return steps.slice(1).map((time, i) => explain(tape, steps[i], frameAt(tape, time), phases))
}

test('the agent of a potential field heads for no neighbour that it does not go to', () => {
  const sentences = told(maps.fig06, 'potential-field')
  expect(sentences.slice(-4)).toEqual([
    'The neighbour of lowest potential to choose from is (6, 3): 64.',
    'Step to (6, 3), down from potential 81 to 64.',
    'The neighbour of lowest potential to choose from is (7, 3): 79.',
    'The end at (6, 3): a local minimum.',
  ])
})

test('with memory it climbs, too', () => {
  const manhattan = { repulsionDistance: 'manhattan' }
  const sentences = told(maps.fig07, 'potential-field-memory', manhattan)
  expect(sentences).toContain('Step to (7, 4), up from potential 64 to 79.')
  expect(sentences).toContain('Step to (6, 3), at the same potential of 80.')
})

test('a hit point is named by where the rover is, not by the obstacle', () => {
  expect(told(maps.fig11, 'bug2')).toContain(
    '(4, 12) is an obstacle: hit point 1 at (4, 13), follow the boundary with the obstacle on the left.',
  )
})

test.each(['left', 'right'])('an obstacle ahead is kept on the %s only from then on', (turn) => {
  const corners = `
    ..###...
    ....#...
    ....#...
    S...#..G
    ....#...
    ....#...
    ..###...
  `
  const y = (row: number) => (turn === 'left' ? row : 6 - row)
  expect(told(corners, 'bug2', { turn })).toEqual(
    expect.arrayContaining([
      `Step to (3, ${y(4)}), keeping (4, ${y(4)}) on the ${turn}.`,
      `Step to (3, ${y(5)}), where (3, ${y(6)}) is in the way: it is kept on the ${turn} from now on.`,
      `Step to (2, ${y(5)}), keeping (2, ${y(6)}) on the ${turn}.`,
    ]),
  )
})

test.each(['left', 'right'])('the border ahead is kept on the %s only from then on', (turn) => {
  const wallToTheBorder = `
    ....#...
    S...#..G
    ....#...
  `
  const y = turn === 'left' ? 2 : 0
  const sentences = told(wallToTheBorder, 'bug2', { turn })
  const first = sentences.findIndex((sentence) => sentence.startsWith(`Step to (3, ${y})`))
  expect(sentences.slice(first, first + 4)).toEqual([
    `Step to (3, ${y}), where the border of the map is in the way: it is kept on the ${turn} from now on.`,
    `Step to (2, ${y}), keeping the border of the map on the ${turn}.`,
    `Step to (1, ${y}), keeping the border of the map on the ${turn}.`,
    `Step to (0, ${y}), keeping the border of the map on the ${turn}.`,
  ])
})

test('Bug1 says which cell it goes back to', () => {
  expect(told(maps.fig11, 'bug1')).toContain(
    'Head back for (4, 3), of this boundary the nearest to the goal: distance 3.',
  )
})

test('Bug1 has the obstacle on its other side where it goes back the way that it came', () => {
  const tape = new Tape()
  plan(problemFromText(maps.fig11), 'bug1', { tape })
  const steps = Array.from(stepsOf(tape))
  const turnAt = (sentence: string, after: number) => {
    const frames = steps.map((time) => frameAt(tape, time)).slice(after)
    const at = frames.findIndex(
      (frame, i) => explain(tape, steps[after + i - 1], frame, []) === sentence,
    )
    return frames[at].turn
  }
  const [left, right] = [0, 1]
  expect(turnAt('Step to (5, 11), along the boundary to (4, 10).', 1)).toBe(left)
  expect(
    turnAt('Head back for (4, 3), of this boundary the nearest to the goal: distance 3.', 1),
  ).toBe(left)
  expect(turnAt('Step to (2, 6), along the boundary to (4, 3).', 1)).toBe(right)
})

test.each([
  ['bug1', {}, 'of this boundary it is the nearest to the goal.'],
  ['bug2', {}, 'the m-line is met again, at its cell 6.'],
  [
    'tangent-bug',
    { variant: 'report' },
    'a step of the simplest path is free, and the goal no farther than from the obstacle at its side.',
  ],
  [
    'tangent-bug',
    { variant: 'classic' },
    'a place in reach is nearer to the goal than the obstacle that was followed.',
  ],
])('%s %o says why it leaves a boundary', (planner, params, why) => {
  const leaves = told(maps.fig11, planner, params).filter((sentence) => /^Leave/.test(sentence))
  expect(leaves.length).toBeGreaterThan(0)
  expect(leaves[0].replace(/^.*\): /, '')).toBe(why)
})

test('Bug2 says where on its m-line it is again', () => {
  const leaves = told(maps.fig12, 'bug2').filter((sentence) => sentence.startsWith('Leave'))
  expect(leaves).toEqual([
    'Leave point 1 at (6, 4): the m-line is met again, at its cell 4.',
    'Leave point 2 at (7, 0): the m-line is met again, at its cell 0.',
  ])
})

test('classic Tangent Bug says where it heads without a node, and never moves without a target', () => {
  const tape = new Tape()
  const problem = problemFromText(maps.fig06)
  plan(problem, 'tangent-bug', { params: { variant: 'classic', range: 2 }, tape })
  const steps = Array.from(stepsOf(tape))
  const sentences = steps
    .slice(1)
    .map((time, i) => explain(tape, steps[i], frameAt(tape, time), []))
  const alone = sentences.indexOf(
    'Head for (7, 3), the next cell of the simplest path to the goal: the step is free, and no node is nearer to the goal than the start, all targets reached and all obstacles followed before.',
  )
  expect(sentences[alone + 1]).toBe('Step to (7, 3): the way is free.')
  const { target, rover } = frameAt(tape, steps[alone + 2])
  expect(target).toBe(rover)
})

test('a node that is an end as well as on the free way is counted once', () => {
  const classic = { variant: 'classic', range: 1 }
  const sentences = told('SG\n##', 'tangent-bug', classic)
  expect(sentences).toContain('1 node in reach of (0, 0).')
})

test('Tangent Bug says what a node has over the others', () => {
  expect(told(maps.fig11, 'tangent-bug')).toContain(
    'Head for (4, 12), of the nodes the one with the shortest way over it to the goal: 14 steps.',
  )
  const classic = told(maps.fig12, 'tangent-bug', { variant: 'classic', range: 2 })
  expect(classic).toContain(
    'Head for (6, 2): 11 steps over it to the goal, the fewest of the nodes that are nearer to it than the start, all targets reached and all obstacles followed before.',
  )
  const left = classic.findIndex((sentence) => sentence.startsWith('Leave'))
  expect(classic[left + 1]).toMatch(
    /^Head for .*, of the places in reach the nearest to the goal\.$/,
  )
})
