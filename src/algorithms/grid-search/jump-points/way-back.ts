import { stepOffsets } from '../../../grid/directions'
import type { Problem } from '../../../grid/problem'
import { Bucket } from '../bucket'
import { successorsUnder } from '../successors'
import type { GoalInSight } from './goal-in-sight'
import type { JumpGraph } from './graph'

// Used again and again; what they hold is copied out.
const choices = new Bucket()
const path = new Bucket()

/**
 * The cells from the start to the goal. Where there was a choice, the next vertex tells how its way
 * began; from there on one way leads on at each corner.
 */
export function wayBackOverJumps(
  graph: JumpGraph,
  { grid, start, goal, diagonal }: Problem,
  legal: Uint8Array,
  goalInSight: GoalInSight,
): Int32Array {
  const { vertices } = graph
  const successors = successorsUnder(diagonal)
  const offsets = stepOffsets(grid.width)
  choices.count = 0
  for (let vertex = graph.vertexAt(goal); vertices.cell(vertex) !== start; ) {
    choices.push(vertex)
    vertex = vertices.parent(vertex)
  }
  path.count = 0
  path.push(start)
  let cell = start
  for (let i = choices.count - 1; i >= 0; i--) {
    const choice = choices.cells[i]
    const end = vertices.cell(choice)
    let d = vertices.departure(choice)
    while (cell !== end) {
      const offset = offsets[d]
      const onward = 1 << d
      let ways = onward
      do {
        cell += offset
        path.push(cell)
        ways = successors[(d << 8) | legal[cell]]
        // Cells of a diagonal have ways to the sides that lead nowhere.
      } while ((ways & onward) !== 0 && cell !== end && graph.vertexAt(cell) < 0)
      const passed = cell === end ? -1 : graph.vertexAt(cell)
      if (passed >= 0) ways = graph.leading(passed, ways, goalInSight)
      d = 31 - Math.clz32(ways)
    }
  }
  return path.cells.slice(0, path.count)
}
