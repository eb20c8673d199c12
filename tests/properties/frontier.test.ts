import { test } from 'vitest'
import { EVENT, type Frame, frameAt, Player, SEARCH, searchOf, Tape } from '../../src/index'
import { cellFacts } from '../../src/trace/cell-facts'
import { momentAfter, stepsOf } from '../../src/trace/landmarks'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { CellSearch, joined, type Reached } from '../reference/cell-search'
import { run } from '../reference/run'
import { type CostName, isShorter, lengthOf, type Way } from '../reference/shortest'
import { placesOf, type World, type XY } from '../reference/world'

/** The simplest path between two cells if nothing is in the way. */
function estimate([ax, ay]: XY, [bx, by]: XY): Way {
  const [across, down] = [Math.abs(ax - bx), Math.abs(ay - by)]
  return { steps: Math.max(across, down), diagonals: Math.min(across, down) }
}

const costOf = (way: Way, cost: CostName) => (cost === 'cells' ? way.steps : lengthOf(way))

/**
 * Of all open cells the next one comes first; with Dijkstra's buckets by whole numbers of cost.
 * Returns the least cost of a path over it.
 */
function mustComeFirst(
  name: string,
  world: World,
  { reached }: CellSearch,
  next: XY,
  cost: CostName,
  isStarred: boolean,
): number {
  const chosen = reached.get(String(next))
  must(chosen !== undefined && !chosen.isClosed, () => `${name}: closes ${next}, which is not open`)
  const whole = ({ way, cell }: Reached) => joined(way, estimate(cell, world.goal))
  const bucket = ({ way }: Reached) => Math.floor(costOf(way, cost))
  for (const other of reached.values()) {
    if (other.isClosed) continue
    const isBefore = isStarred
      ? isShorter(whole(other), whole(chosen), cost)
      : bucket(other) < bucket(chosen)
    must(!isBefore, () => `${name}: closes ${next} before ${other.cell}`)
  }
  return costOf(whole(chosen), cost)
}

/** The cells that the frame shows open and closed are those that are. */
function mustShow(name: string, world: World, frame: Frame, { reached }: CellSearch): void {
  const count = { open: 0, closed: 0 }
  frame.cells.forEach((_, cell) => {
    const known = reached.get(String(placesOf(world, [cell])[0]))
    if (known) count[known.isClosed ? 'closed' : 'open']++
    const expected = !known ? SEARCH.untouched : known.isClosed ? SEARCH.closed : SEARCH.open
    const shown = searchOf(frame, cell)
    must(shown === expected, () => `${name}: cell ${cell} is ${shown}, not ${expected}`)
  })
  must(
    frame.open === count.open && frame.closed === count.closed,
    () => `${name}: ${frame.open} open, ${frame.closed} closed, not ${JSON.stringify(count)}`,
  )
}

/** The way to each cell that is told is the one that is known. */
function mustTellWays(
  name: string,
  world: World,
  tape: Tape,
  frame: Frame,
  search: CellSearch,
  costName: CostName,
): void {
  for (const { cell, way, before } of search.reached.values()) {
    const number = ([x, y]: XY) => y * world.width + x
    const { cost, parent } = cellFacts(tape, frame, number(cell))
    const expected = costOf(way, costName)
    must(
      cost !== null && isClose(cost, expected) && parent === (before ? number(before) : -1),
      () => `${name}: ${cell} costs ${cost} by way of ${parent}, not ${expected} over ${before}`,
    )
  }
}

test('the open and the closed cells of a search are those that are, at each step', {
  timeout: LONG,
}, async () => {
  await onEveryMap((world, index) => {
    if (index % 10 !== 3 || world.width * world.height > 200) return
    for (const cost of ['cells', 'euclidean'] as const) {
      for (const search of ['dijkstra', 'a-star']) {
        const tape = new Tape()
        const { name } = run(world, 'decomposition', { cost, search }, tape)
        const reference = new CellSearch(world, cost)
        const player = new Player(tape)
        const steps = stepsOf(tape)
        let closed = 0
        for (let i = 0; i < tape.length; i++) {
          if (tape.kind(i) !== EVENT.close) continue
          const [cell] = placesOf(world, [tape.cell(i)])
          mustShow(name, world, player.moveTo(i), reference)
          const isStarred = search === 'a-star'
          const least = mustComeFirst(name, world, reference, cell, cost, isStarred)
          const end = momentAfter(steps, i)
          const [told] = frameAt(tape, end).values
          must(
            isStarred ? isClose(told, least) : told === undefined,
            () => `${name}: ${told} is told of ${cell}, not ${least}`,
          )
          if (String(cell) === String(world.goal)) {
            must(tape.other(i) === 0, () => `${name}: goes on behind the goal`)
            break
          }
          reference.close(cell)
          mustShow(name, world, player.moveTo(i + 1), reference)
          if (closed++ % 16 === 5) mustTellWays(name, world, tape, player.frame, reference, cost)
        }
        must(closed > 0 || String(world.start) === String(world.goal), () => `${name}: no step`)
      }
    }
  })
})
