import { type Cell, cellName, isInside, pointOf } from '../grid/grid'
import { plural } from '../grid/plural'
import { inThousands } from '../grid/thousands'
import { KNOWN } from './cell-state'
import { costAt } from './cost-at'
import { costLeft } from './cost-left'
import { EVENT, LEAVES, type Leave, STATUSES, type Status } from './events'
import { type Frame, knownOf } from './frame'
import { openedBy } from './opened'
import type { Tape } from './tape'

const SIDES = ['left', 'right'] as const

const ENDS: Record<Status, string> = {
  reached: 'the goal is reached',
  unreachable: 'it is proven that no path exists',
  'not-found': 'this planner gives up; a path may exist',
  'local-minimum': 'a local minimum',
  'dead-end': 'a dead end',
  loop: 'the rover goes round for ever',
}

const WHY_LEFT: Record<Leave, string> = {
  'm-line': 'the m-line is met again',
  nearest: 'of this boundary it is the nearest to the goal',
  'free-step':
    'a step of the simplest path is free, and the goal no farther than from the obstacle at its side',
  'place-in-reach': 'a place in reach is nearer to the goal than the obstacle that was followed',
}

/**
 * One plain sentence about a step of the planner.
 * @param first the event with which the step begins
 * @param frame the picture after the step
 * @param phases names of the planner's phases
 */
export function explain(
  tape: Tape,
  first: number,
  frame: Frame,
  phases: readonly string[],
): string {
  const cell = tape.cell(first)
  const other = tape.other(first)
  const value = tape.value(first)
  const name = (place: Cell) => (place < 0 ? 'the border of the map' : cellName(tape.width, place))
  const row = Math.floor(cell / tape.width)
  switch (tape.kind(first)) {
    case EVENT.phase:
      return `${phases[other] ?? `Phase ${other + 1}`}.`
    case EVENT.end: {
      const place = cell < 0 ? '' : ` at ${name(cell)}`
      return `The end${place}: ${ENDS[STATUSES[other]]}.`
    }
    case EVENT.row:
      return `Row ${row}: ${count(other, 'free cell')} of the graph.`
    case EVENT.test:
      return value === 1
        ? `${name(cell)}, diagonal to obstacle ${name(other)}: it is free and so are both cells between them, so it is a vertex.`
        : `${name(cell)}, diagonal to obstacle ${name(other)}: not all three cells are free, so it is no corner of this obstacle.`
    case EVENT.vertex:
      return `${name(cell)} is a vertex of the roadmap.`
    case EVENT.edge:
      return `The simplest path from ${name(cell)} to ${name(other)} is free: an edge of cost ${number(value)}.`
    case EVENT.cut:
      return `There are more than ${count(value, 'edge')}: those from ${name(cell)} on are used, but not shown.`
    case EVENT.refuse:
      return `The simplest paths between ${name(cell)} and ${name(other)} are refused, the one from ${name(cell)} at ${name(value)}: no edge.`
    case EVENT.open:
      return other < 0
        ? `Start at ${name(cell)} with cost ${number(value)}.`
        : `${name(cell)} gets a shorter way, over ${name(other)}: cost ${number(value)}.`
    case EVENT.close:
      return `Of all open ones ${name(cell)} comes first, with cost ${number(costAt(tape, frame, first))}${whatIsLeft(tape, cell, frame)}: the way to it is final.${whatItGives(openedBy(tape, first).map(({ cell }) => name(cell)))}`
    case EVENT.path:
      return `The parents lead back from the goal: a path of ${count(frame.path.length, 'cell')}.`
    case EVENT.attraction:
      return `Row ${row}: the attraction is the square of the distance to the goal.`
    case EVENT.repulsion:
      return `Row ${row}: the closest obstacle repels where it is within influence.`
    case EVENT.potential:
      return `Row ${row}: attraction and repulsion added up.`
    case EVENT.step:
      return explainStep(name, tape, first, frame)
    case EVENT.sense:
      return `The rover senses what is around ${name(frame.rover)}.`
    case EVENT.scan:
      return frame.nodes.length === 0
        ? `No end of an obstacle is in reach of ${name(cell)}.`
        : `${count(frame.nodes.length, 'node')} in reach of ${name(cell)}.`
    case EVENT.target:
      return explainTarget(cell < 0 ? 'a place of the border' : name(cell), tape, first, frame)
    case EVENT.mLine:
      return `The m-line: the simplest path from start to goal, ${count(frame.mLine.length, 'cell')}.`
    case EVENT.hit: {
      const what = other < 0 ? 'The border of the map' : `${name(other)} is an obstacle`
      // Which way round is not on a thinned tape.
      const side = tape.thinning === 'whole' ? ` with the obstacle on the ${SIDES[frame.turn]}` : ''
      return `${what}: hit point ${value} at ${name(cell)}, follow the boundary${side}.`
    }
    case EVENT.around:
      return `Round the obstacle once, in ${count(value, 'step')}, and back at ${name(cell)}.`
    case EVENT.leave: {
      const met = frame.mLine.indexOf(cell)
      const where = met < 0 ? '' : `, at its cell ${met}`
      return `Leave point ${value} at ${name(cell)}: ${WHY_LEFT[LEAVES[other]]}${where}.`
    }
    case EVENT.loop:
      return `Loop: the same place and the same state as after ${count(value, 'step')}, so the rover goes round for ever.`
    default:
      return ''
  }
}

function explainStep(
  name: (cell: Cell) => string,
  tape: Tape,
  first: number,
  frame: Frame,
): string {
  const cell = tape.cell(first)
  const from = tape.other(first)
  if (from < 0) return `Start at ${name(cell)}.`
  const { potential } = frame.fields
  if (potential) return `Step to ${name(cell)}, ${fromTo(potential[from], potential[cell])}.`
  if (!frame.following) return `Step to ${name(cell)}: the way is free.`
  // Neither what it heads for nor what it keeps at its side is on a thinned tape.
  if (tape.thinning !== 'whole') return `Step to ${name(cell)}, along the boundary.`
  // Only Bug1 heads for a place while it is at the boundary: back to the nearest one.
  if (frame.target >= 0)
    return `Step to ${name(cell)}, along the boundary to ${name(frame.target)}.`
  const side = SIDES[frame.turn]
  return isInTheWay(tape, from, cell, frame)
    ? `Step to ${name(cell)}, where ${name(frame.atSide)} is in the way: it is kept on the ${side} from now on.`
    : `Step to ${name(cell)}, keeping ${name(frame.atSide)} on the ${side}.`
}

/** Whether the obstacle cell that the rover keeps at its side did not lie there when it came, but ahead. */
function isInTheWay(tape: Tape, from: Cell, to: Cell, { atSide, turn }: Frame): boolean {
  const [was, is] = [from, to].map((place) => pointOf(tape.width, place))
  // The way that the rover came, turned to the side at which it keeps obstacles.
  const hand = turn === 0 ? 1 : -1
  const dx = hand * (is.y - was.y)
  const dy = hand * (was.x - is.x)
  // Which part of the border it is does not stand on the tape; there is some at the side, or none.
  if (atSide < 0) return isInside(tape, is.x + dx, is.y + dy)
  const kept = pointOf(tape.width, atSide)
  return dx * (kept.x - is.x) + dy * (kept.y - is.y) <= 0
}

function explainTarget(place: string, tape: Tape, first: number, frame: Frame): string {
  const cell = tape.cell(first)
  const value = tape.value(first)
  // Whether the agent goes there is for the next step to say.
  if (frame.fields.potential)
    return `The neighbour of lowest potential to choose from is ${place}: ${number(value)}.`
  // Only Bug1 heads for a place while it is at the boundary.
  if (frame.following)
    return `Head back for ${place}, of this boundary the nearest to the goal: distance ${number(value)}.`
  // Classic Tangent Bug, which has just left a boundary for it, or finds no node to head for.
  if (first > 0 && tape.kind(first - 1) === EVENT.leave)
    return `Head for ${place}, of the places in reach the nearest to the goal.`
  if (!frame.nodes.includes(cell))
    return `Head for ${place}, the next cell of the simplest path to the goal: the step is free, and no node is nearer to the goal than the start, all targets reached and all obstacles followed before.`
  // Nodes of classic Tangent Bug are free, those of the report's are not, and any of them may be chosen.
  if (cell >= 0 && knownOf(frame, cell) === KNOWN.free)
    return `Head for ${place}: ${count(value, 'step')} over it to the goal, the fewest of the nodes that are nearer to it than the start, all targets reached and all obstacles followed before.`
  return `Head for ${place}, of the nodes the one with the shortest way over it to the goal: ${count(value, 'step')}.`
}

/** From one potential to another: "down from 81 to 64". */
function fromTo(before: number, after: number): string {
  if (before === after) return `at the same potential of ${number(after)}`
  return `${after < before ? 'down' : 'up'} from potential ${number(before)} to ${number(after)}`
}

/** What is left from a cell that is closed, if the search reckons with that: " and at least 3 left". */
const whatIsLeft = (tape: Tape, cell: Cell, { estimate }: Frame): string =>
  estimate ? ` and at least ${number(costLeft(tape, cell, estimate.goal))} left` : ''

/** What a cell that is closed gives to those named so: " It gives (1, 2) and (1, 3) a shorter way." */
function whatItGives(names: readonly string[]): string {
  if (names.length === 0) return ''
  const others = names.slice(0, -1).join(', ')
  return ` It gives ${others && `${others} and `}${names.at(-1)} a shorter way.`
}

const count = (n: number, what: string): string => `${number(n)} ${plural(n, what)}`

/** At most three decimals, none for whole numbers. */
function number(value: number): string {
  return Number.isFinite(value) ? inThousands(String(Math.round(value * 1000) / 1000)) : 'infinite'
}
