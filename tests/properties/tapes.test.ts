import { test } from 'vitest'
import { EVENT, frameAt, knownOf, type Outcome, plan, planners, Tape } from '../../src/index'
import { ARE_MANY, LONG, must, onEveryMap } from '../reference/cases'
import { Dice } from '../reference/random'
import { run } from '../reference/run'
import { anySettings } from '../reference/settings'
import { problemOf, type World } from '../reference/world'
import { directionsInside, written } from '../trace/written'

const SECOND_IS_A_CELL: ReadonlySet<number> = new Set([
  EVENT.test,
  EVENT.edge,
  EVENT.refuse,
  EVENT.open,
  EVENT.step,
  EVENT.hit,
])
/**
 * A phase is nowhere, and so is the end of a search without a path. Obstacles may lie outside the
 * map, where a cell has no number; Tangent Bug heads for some.
 */
const MAY_BE_NOWHERE: ReadonlySet<number> = new Set([
  EVENT.phase,
  EVENT.end,
  EVENT.feel,
  EVENT.target,
  EVENT.node,
])

function mustBeWritten(name: string, world: World, tape: Tape, lines: number): void {
  const cells = world.width * world.height
  const kinds = new Set<number>(Object.values(EVENT))
  const isCell = (cell: number, least: number) => cell >= least && cell < cells
  for (let i = 0; i < tape.length; i++) {
    const kind = tape.kind(i)
    must(kinds.has(kind), () => `${name}: event ${i} is of no kind (${kind})`)
    must(tape.line(i) < lines, () => `${name}: event ${i} names line ${tape.line(i)} of ${lines}`)
    const least = MAY_BE_NOWHERE.has(kind) ? -1 : 0
    must(isCell(tape.cell(i), least), () => `${name}: event ${i} (${kind}) at ${tape.cell(i)}`)
    const second = tape.other(i)
    must(
      !SECOND_IS_A_CELL.has(kind) || isCell(second, -1),
      () => `${name}: event ${i} (${kind}) names cell ${second}`,
    )
    const outside = ~directionsInside(tape.cell(i), world.width, world.height)
    must(
      kind !== EVENT.close || second === -1 || (second & outside) === 0,
      () => `${name}: event ${i} opens neighbours in directions ${second}`,
    )
    must(!Number.isNaN(tape.value(i)), () => `${name}: event ${i} (${kind}) has no value`)
  }
}

function mustBeEqual(name: string, one: Tape, other: Tape): void {
  must(one.length === other.length, () => `${name}: ${one.length} events, then ${other.length}`)
  for (let i = 0; i < one.length; i++) {
    must(
      one.kind(i) === other.kind(i) &&
        one.line(i) === other.line(i) &&
        one.cell(i) === other.cell(i) &&
        one.other(i) === other.other(i) &&
        one.value(i) === other.value(i),
      () => `${name}: event ${i} is not the same the second time`,
    )
  }
}

test('tapes: true, complete and the same each time', { timeout: LONG }, async () => {
  // One tape for all second runs: what an earlier run wrote on it must not show.
  const again = new Tape()
  await onEveryMap((world, index) => {
    const dice = new Dice(7, index)
    const runs = planners.map((planner) => {
      const params = anySettings(planner.params, dice)
      const tape = new Tape()
      return { planner, params, tape, ...run(world, planner.id, params, tape) }
    })
    // The other planners ran in between, and come in the other order now.
    for (const { planner, params, tape, name, outcome } of runs.reverse()) {
      mustBeWritten(name, world, tape, planner.pseudocode.length)
      const second = run(world, planner.id, params, again)
      mustBeEqual(name, tape, again)
      mustAgree(name, outcome, second.outcome)
      mustAgree(name, outcome, run(world, planner.id, params).outcome)

      const frame = frameAt(tape, tape.length)
      const drawn = frame.trail.length > 0 ? frame.trail : frame.path
      must(
        String(drawn) === String([...outcome.path]),
        () => `${name}: the tape ends with ${drawn}, but the path is ${outcome.path}`,
      )
      if (planner.family === 'online') {
        const sensed = frame.cells.filter((_, cell) => knownOf(frame, cell) > 0).length
        must(sensed === outcome.sensed, () => `${name}: ${sensed} cells sensed on the tape`)
      }
    }
  })
})

function mustAgree(name: string, one: Outcome, other: Outcome): void {
  const words = ({ path, ...rest }: Outcome) => JSON.stringify({ ...rest, path: [...path] })
  must(words(one) === words(other), () => `${name}: ${words(one)}, then ${words(other)}`)
}

test('the seed, and nothing else, decides what is random', { timeout: LONG }, async () => {
  let different = 0
  await onEveryMap((world, index) => {
    if (index % 10 !== 0) return
    for (const planner of planners) {
      const tapes = [1, 1, 2].map((seed) => {
        const tape = new Tape()
        plan(problemOf(world), planner.id, { seed, tape })
        return tape
      })
      mustBeEqual(planner.id, tapes[0], tapes[1])
      if (planner.usesSeed) {
        const [one, other] = [tapes[0], tapes[2]].map((tape) =>
          String(written(tape).map(({ cell }) => cell)),
        )
        if (one !== other) different++
      } else mustBeEqual(planner.id, tapes[0], tapes[2])
    }
  })
  must(different > 0 || !ARE_MANY, () => 'another seed never changed a thing')
})
