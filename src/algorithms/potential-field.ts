import { descend, descentPhases, descentPseudocode, descentVariables } from './descent'
import { offlinePlanner } from './planner'
import { fieldsOf, potentialParams } from './potential'

const { text, line } = descentPseudocode({
  choose: 'the legal neighbour with the lowest potential',
  step: 'if it is lower than here: step to it',
  stuck: 'else stop: a local minimum',
})

export const potentialField = offlinePlanner({
  id: 'potential-field',
  title: 'Potential field',
  summary:
    'The goal attracts, obstacles repel; the agent steps to the neighbour with the lowest potential as long as it is lower.',
  promise: 'Neither complete nor optimal: it stops in the first local minimum.',
  complete: () => false,
  optimal: () => false,
  params: potentialParams,
  phases: descentPhases,
  variables: descentVariables,
  pseudocode: text,
  source:
    'Report, IV.D; C. W. Warren, "Global path planning using artificial potential fields", 1989',

  plan(problem, { params, tape }) {
    const fields = fieldsOf(problem, params)
    return descend({ problem, fields, memory: false, lines: line, tape })
  },
})
