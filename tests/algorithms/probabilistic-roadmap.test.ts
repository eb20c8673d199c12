import { expect, test } from 'vitest'
import { plan, problemFromText } from '../../src/index'

const WALLED_IN = problemFromText('S.#.G\n..#..')

test.each([
  [3, 'these samples do not join start and goal; more samples or another seed may'],
  [6, 'not even all free cells as samples join start and goal'],
  [100, 'not even all free cells as samples join start and goal'],
])('with %i of 6 samples it does not advise what cannot help', (samples, reason) => {
  const found = plan(WALLED_IN, 'probabilistic-roadmap', { params: { samples } })
  expect(found).toMatchObject({ status: 'not-found', reason })
})
