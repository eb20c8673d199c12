import { expect, test } from 'vitest'
import { faultOf } from '../../src/algorithms/params'
import { planners } from '../../src/algorithms/planners'

const paramOf = (name: string) => {
  const found = planners.flatMap(({ params }) => params).find((param) => param.name === name)
  if (!found) throw new Error(`no parameter ${name}`)
  return found
}

test.each([
  ['repulsiveValue', 0.5, ''],
  ['repulsiveValue', Number.NaN, 'NaN is no number'],
  ['repulsiveValue', Number.POSITIVE_INFINITY, 'Infinity is no number'],
  ['repulsiveValue', '30', '"30" is no number'],
  ['repulsiveValue', -1, '-1 is not from 0 to 1000000'],
  ['samples', 1.5, '1.5 is not a whole number'],
  ['samples', undefined, 'undefined is no number'],
  ['leave', 'closer', ''],
  ['leave', ['closer'], '["closer"] is not one of report, closer'],
  ['lineOfSight', null, 'null is not true or false'],
  ['lineOfSight', {}, 'an object is not true or false'],
])('%s %j: %s', (name, value, fault) => {
  expect(faultOf(paramOf(name), value)).toBe(fault)
})
