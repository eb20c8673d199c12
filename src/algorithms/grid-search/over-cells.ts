import { type Memory, memoryFor } from './memory'
import type { CellSearch, SearchTask } from './search'
import { wayBack } from './way-back'

/**
 * The search whose loop this is. By itself, the loop is compiled better.
 * @param closeUpToGoal closes cells, the goal last; returns how many
 */
export const overCells =
  (closeUpToGoal: (task: SearchTask, memory: Memory) => number): CellSearch =>
  (task) => {
    const memory = memoryFor(task.legal.length)
    const expanded = closeUpToGoal(task, memory)
    return { path: wayBack(task.problem, memory), expanded }
  }
