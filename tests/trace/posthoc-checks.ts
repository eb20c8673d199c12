import { type Outcome, type Planner, type Problem, plan, type Tape } from '../../src/index'
import { must } from '../reference/cases'
import { mustBeDrawn } from './posthoc-drawn'
import { infoOf, type PosthocEvent, type Trace, traceText, wayTo } from './posthoc-trace'

/** The trace of a run, with all checked that must hold of every trace. */
export function checkedTrace(
  problem: Problem,
  planner: Planner,
  tape: Tape,
  options: Parameters<typeof plan>[2] = {},
): Trace {
  const outcome = plan(problem, planner.id, { ...options, tape })
  const text = traceText(tape, infoOf(planner, problem))
  const trace: Trace = JSON.parse(text)
  must(trace.version === '1.4.0', () => `version ${trace.version}`)
  mustBeCleanLines(text, trace)
  mustHaveParentsBefore(trace)
  mustBeTree(trace)
  mustStayInPlace(trace)
  mustBeInside(problem, trace)
  mustBeDrawn(problem, trace)
  mustExpand(trace, outcome)
  mustLeadBack(problem, trace, outcome)
  return trace
}

/** One line an event, with no key twice and no number that another program would write otherwise. */
function mustBeCleanLines(text: string, { events }: Trace): void {
  const lines = text.slice(text.indexOf('"events":[\n') + '"events":[\n'.length).split('\n')
  events.forEach((event, i) => {
    const expected = JSON.stringify(event) + (i < events.length - 1 ? ',' : '')
    must(lines[i] === expected, () => `line ${lines[i]} says ${expected}`)
  })
}

function mustHaveParentsBefore({ events }: Trace): void {
  const ids = new Set<string>()
  for (const { type, id, pId } of events) {
    // Posthoc takes a parent that counts as false for none.
    must(typeof id === 'string' && id !== '', () => `${type} has no id`)
    must(pId === undefined || ids.has(pId), () => `${type} ${id} comes before its parent ${pId}`)
    must(pId !== id, () => `${type} ${id} is its own parent`)
    ids.add(id)
  }
}

/** Posthoc's tree: of each `id` the first parent counts. */
function mustBeTree({ events }: Trace): void {
  const parents = new Map<string, string>()
  for (const { id, pId } of events) {
    if (pId !== undefined && !parents.has(id)) parents.set(id, pId)
  }
  const rooted = new Set<string>()
  for (const first of parents.keys()) {
    const way = new Set<string>()
    for (let id: string | undefined = first; id !== undefined && !rooted.has(id); ) {
      must(!way.has(id), () => `${id} is its own ancestor`)
      way.add(id)
      id = parents.get(id)
    }
    for (const id of way) rooted.add(id)
  }
}

/** Posthoc draws the way to an event over the latest event of each `id`: all must be in one place. */
function mustStayInPlace({ events }: Trace): void {
  const places = new Map<string, string>()
  for (const { type, id, x, y } of events) {
    const place = `${x},${y}`
    const before = places.get(id) ?? place
    must(place === before, () => `${type} ${id} is at ${place}, before at ${before}`)
    places.set(id, place)
  }
}

const PLACES = [
  ['x', 'y'],
  ['toX', 'toY'],
  ['atX', 'atY'],
  ['obstacleX', 'obstacleY'],
] as const

function mustBeInside({ grid }: Problem, { events }: Trace): void {
  const isIn = (value: unknown, side: number) =>
    Number.isInteger(value) && Number(value) >= 0 && Number(value) < side
  for (const event of events) {
    must(event.type !== 'step' || event.x !== undefined, () => `${event.id} is nowhere`)
    for (const [x, y] of PLACES) {
      if (event[x] === undefined && event[y] === undefined) continue
      must(isIn(event[x], grid.width) && isIn(event[y], grid.height), () => JSON.stringify(event))
    }
  }
}

/** A cell is expanded, then its neighbours are generated, then it is closed. */
function mustExpand({ events }: Trace, { expanded }: Outcome): void {
  const own = ['generating', 'updating']
  let open: PosthocEvent | undefined
  let count = 0
  for (const event of events) {
    if (open) {
      if (event.type === 'closing') {
        const { id, pId, g } = event
        must(id === open.id && pId === open.pId && g === open.g, () => `closing ${id} too early`)
        open = undefined
      } else {
        must(own.includes(event.type), () => `${event.type} while ${open?.id} is expanded`)
        must(event.pId === open.id, () => `${event.type} ${event.id} from ${event.pId}`)
      }
    } else {
      must(event.type !== 'closing', () => `${event.id} is closed twice`)
      if (event.type !== 'expanding') continue
      open = event
      count++
    }
  }
  must(open === undefined, () => `${open?.id} stays open`)
  must(count === expanded, () => `${count} expanded of ${expanded}`)
}

/** The way that Posthoc draws for the last step or the last cell of the path. */
function mustLeadBack({ grid }: Problem, trace: Trace, { path, status }: Outcome): void {
  const cellOf = ({ x, y }: PosthocEvent) => Number(y) * grid.width + Number(x)
  const { events } = trace
  const walked = events.filter(({ type }) => type === 'step')
  const found = events.filter(({ type }) => type === 'path')
  const way = walked.length > 0 ? walked : found
  must(String(way.map(cellOf)) === String([...path]), () => `${way.map(cellOf)} is not ${path}`)
  const last = way.at(-1)
  if (last) {
    const back = wayTo(trace, events.indexOf(last)).map(cellOf)
    must(String(back.reverse()) === String([...path]), () => `${back} is not ${path}`)
  }
  const end = events.at(-1)
  must(end?.type === 'end' && end.status === status, () => `ends with ${JSON.stringify(end)}`)
  if (status !== 'reached') return
  const ends = wayTo(trace, events.length - 1).map(cellOf)
  must(ends[0] === path.at(-1), () => `the end is not at the goal but at ${ends[0]}`)
  must(ends.at(-1) === path[0], () => `the end leads back to ${ends.at(-1)}`)
  must(
    ends.every((cell) => path.includes(cell)),
    () => `the end leads back over ${ends}`,
  )
}
