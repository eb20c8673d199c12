import { descend, descentPhases, descentPseudocode, descentVariables } from './descent'
import { offlinePlanner } from './planner'
import { fieldsOf, potentialParams } from './potential'

const { text, line } = descentPseudocode({
  choose: 'the lowest legal neighbour not yet visited',
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
  phases: descentPhases,
  variables: descentVariables,
  pseudocode: text,
  source: 'Report, IV.D',

  plan(problem, { params, tape }) {
    const fields = fieldsOf(problem, params)
    return descend({ problem, fields, memory: true, lines: line, tape })
  },
})
