import type { Problem } from '../grid/problem'
import { costLeft } from './cost-left'
import { EVENT, STATUSES } from './events'
import type { Estimate } from './frame'
import { isAttached } from './landmarks'
import { openedBy } from './opened'
import { PosthocDrive } from './posthoc-drive'
import { leastLength } from './posthoc-length'
import { PosthocLines } from './posthoc-lines'
import { PosthocSearch } from './posthoc-search'
import { posthocPivot, posthocViews } from './posthoc-views'
import type { Tape } from './tape'

/** What a trace says of the run that made it. */
export interface PosthocInfo {
  readonly plannerId: string
  readonly title: string
  /** How the planner calls its phases and its variables, which the tape numbers. */
  readonly phases: readonly string[]
  readonly variables: readonly string[]
  readonly problem: Problem
  /** Name of the map's file that goes with the trace. */
  readonly mapFile: string
}

/** Posthoc holds the whole trace as one text, which in a browser cannot be much longer. */
const MOST_CHARACTERS = 2e8

interface TraceOptions {
  /** Characters that the events may have. */
  readonly most?: number
  /** Is told now and then what share of the tape is written, from 0 to 1. */
  readonly progress?: (done: number) => void
}

/**
 * A tape as a search trace of format 1.4.0 for Posthoc (posthoc.pathfinding.ai): the text of a
 * `.trace.json` file that opens on top of the MovingAI map of the same problem. One line an event. The
 * text comes in parts, some of them empty, each of them made in a fraction of a frame.
 * @throws InputError if the tape is too long for that.
 */
export function* posthocTrace(
  tape: Tape,
  info: PosthocInfo,
  { most = MOST_CHARACTERS, progress = () => {} }: TraceOptions = {},
): Generator<string, void, void> {
  const lines = new PosthocLines(tape, most)
  // To find that out by writing would take seconds.
  lines.mustFit(yield* leastLength(tape))
  yield '{\n"version":"1.4.0",\n"events":[\n'
  writeEnds(lines, info)
  const highest = yield* writtenEvents(lines, tape, info, progress)
  const views = JSON.stringify(posthocViews(lines.types, tape.width, highest))
  yield `\n],\n"views":${views},\n"pivot":${JSON.stringify(posthocPivot)}\n}\n`
}

function writeEnds(lines: PosthocLines, { problem, plannerId, title, mapFile }: PosthocInfo): void {
  lines
    .cell('source', problem.start)
    .tell('planner', JSON.stringify(plannerId))
    .tell('title', JSON.stringify(title))
    .tell('map', JSON.stringify(mapFile))
    .tell('diagonal', JSON.stringify(problem.diagonal))
  lines.cell('destination', problem.goal)
}

/** Returns the highest finite potential; at least 1, so that it can be divided by. */
function* writtenEvents(
  lines: PosthocLines,
  tape: Tape,
  info: PosthocInfo,
  progress: (done: number) => void,
): Generator<string, number, void> {
  const search = new PosthocSearch(lines, tape.width * tape.height)
  const drive = new PosthocDrive(lines)
  let estimate: Estimate | null = null
  let highest = 1
  for (let i = 0; i < tape.length; i++) {
    const kind = tape.kind(i)
    const cell = tape.cell(i)
    const other = tape.other(i)
    const value = tape.value(i)
    if (kind === EVENT.potential && Number.isFinite(value)) highest = Math.max(highest, value)
    if (kind === EVENT.estimate) estimate = { goal: cell, variable: other }
    // What these tell becomes part of other events.
    if (kind === EVENT.estimate || kind === EVENT.value || kind === EVENT.turn) continue
    // Lines of the pseudocode, counted from 1 as they are shown.
    const line = tape.line(i) + 1
    search.before(kind)
    if (kind === EVENT.phase) {
      lines.begin('phase', `phase ${other + 1}`, null, -1)
      lines.tell('name', JSON.stringify(info.phases[other] ?? ''))
    } else if (kind === EVENT.end) {
      if (drive.hasBegun) drive.end()
      else search.end(cell)
      lines.tell('status', JSON.stringify(STATUSES[other]))
    } else {
      search.write(kind, cell, other, value)
      drive.write(kind, cell, other, value)
    }
    lines.tellNumber('line', line)
    if (!isAttached[kind]) tellAttached(lines, tape, i, info.variables, estimate, search)
    for (const opened of openedBy(tape, i)) {
      search.open(opened.cell, cell, search.costOf(cell) + opened.step)
      lines.tellNumber('line', line)
    }
    if (!lines.isFull) continue
    progress(i / tape.length)
    yield lines.take()
  }
  yield lines.take()
  return highest
}

/**
 * Adds to the trace's event for event `i` what the tape tells right after it: on which side the
 * obstacle is, and the planner's variables. Of a closed cell the variable of the search's estimate is
 * told, too, which is not on the tape.
 */
function tellAttached(
  lines: PosthocLines,
  tape: Tape,
  i: number,
  variables: readonly string[],
  estimate: Estimate | null,
  search: PosthocSearch,
): void {
  let side = -1
  const numbers: number[] = []
  if (estimate && tape.kind(i) === EVENT.close) {
    const cell = tape.cell(i)
    numbers[estimate.variable] = search.costOf(cell) + costLeft(tape, cell, estimate.goal)
  }
  for (let j = i + 1; j < tape.length && isAttached[tape.kind(j)]; j++) {
    if (tape.kind(j) === EVENT.turn) side = tape.other(j)
    if (tape.kind(j) === EVENT.value) numbers[tape.other(j)] = tape.value(j)
  }
  if (side >= 0) lines.tell('obstacleOn', side === 0 ? '"left"' : '"right"')
  numbers.forEach((number, variable) => {
    lines.tellNumber(variables[variable] ?? `variable ${variable + 1}`, number)
  })
}
