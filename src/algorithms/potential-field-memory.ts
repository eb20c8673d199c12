import { descend } from './descent'
import { offlinePlanner } from './planner'
import { potentialOf, potentialParams } from './potential'
import { pseudocode } from './pseudocode'

const { text, line } = pseudocode({
  field: 'potential ← attraction by the goal + repulsion by the closest obstacle, for every cell',
  choose: 'while not at the goal: look for the lowest legal neighbour not yet visited',
  step: 'step to it, even if it is higher than here, and remember it',
  stuck: 'if there is none, stop: a dead end',
})

export const potentialFieldMemory = offlinePlanner({
  id: 'potential-field-memory',
  title: 'Potential field with memory',
  summary:
    'As the potential field, but the agent remembers where it was and never goes there again, so it climbs out of many local minima.',
  promise: 'Neither complete nor optimal: it stops where all neighbours were visited.',
  complete: () => false,
  optimal: () => false,
  params: potentialParams,
  pseudocode: text,
  source: 'Report, IV.D',

  plan(problem, { params, tape }) {
    const potential = potentialOf(problem, params)
    return descend({ problem, potential, memory: true, lines: line, tape })
  },
})
