import { type Outcome, type ParamSettings, plan, type Tape } from '../../src/index'
import { must } from './cases'
import { isLegal, isReachable, isSame, placesOf, problemOf, type World, type XY } from './world'

export interface Run {
  /** The run in words, for messages. */
  readonly name: string
  readonly outcome: Outcome
  readonly path: readonly XY[]
}

/**
 * Runs a planner and checks what must hold for every one: the path begins at the start, each of its
 * steps is legal, and it ends at the goal exactly if the planner says so.
 */
export function run(world: World, id: string, params: ParamSettings = {}, tape?: Tape): Run {
  const name = `${id} ${JSON.stringify(params)}`
  const outcome = runNamed(name, world, id, params, tape)
  const path = placesOf(world, outcome.path)
  for (let i = 1; i < path.length; i++) {
    must(
      isLegal(world, path[i - 1], path[i]),
      () => `${name}: step ${i} of ${show(path)} is illegal`,
    )
  }
  must(path.length === 0 || isSame(path[0], world.start), () => `${name}: begins elsewhere`)
  const arrives = path.length > 0 && isSame(path[path.length - 1], world.goal)
  must(arrives === (outcome.status === 'reached'), () => `${name}: ${outcome.status} ${show(path)}`)
  return { name, outcome, path }
}

function runNamed(
  name: string,
  world: World,
  id: string,
  params: ParamSettings,
  tape: Tape | undefined,
): Outcome {
  try {
    return plan(problemOf(world), id, tape ? { params, tape } : { params })
  } catch (fault) {
    throw new Error(`${name} threw ${fault instanceof Error ? fault.message : fault}`, {
      cause: fault,
    })
  }
}

/** The answer of a complete planner: it arrives exactly when straight steps lead to the goal. */
export function mustBeComplete(world: World, { name, outcome }: Run): void {
  const expected = isReachable(world) ? 'reached' : 'unreachable'
  must(outcome.status === expected, () => `${name}: ${outcome.status}, but it is ${expected}`)
}

/** A planner that is not complete proves nothing, and cannot arrive where no way leads. */
export function mustBeModest(world: World, { name, outcome }: Run): void {
  const { status } = outcome
  must(status !== 'unreachable', () => `${name}: says unreachable`)
  must(status !== 'reached' || isReachable(world), () => `${name}: arrived where no way leads`)
}

/** No planner may walk farther than this many steps. */
export function mustNotExceed(bound: number, { name, path }: Run): void {
  const steps = Math.max(0, path.length - 1)
  must(steps <= bound, () => `${name}: ${steps} steps, more than ${bound}`)
}

export function show(path: readonly XY[]): string {
  return path.map(([x, y]) => `(${x},${y})`).join(' ')
}

/** Says where two walks part. */
export function mustWalkAlike(name: string, walked: readonly XY[], expected: readonly XY[]): void {
  must(
    walked.length === expected.length && walked.every((cell, i) => isSame(cell, expected[i])),
    () => `${name}: walked\n${show(walked)}\nbut should walk\n${show(expected)}`,
  )
}
