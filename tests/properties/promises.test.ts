import { expect, test } from 'vitest'
import { planners } from '../../src/index'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { Dice } from '../reference/random'
import { mustBeComplete, mustBeModest, run } from '../reference/run'
import { anySettings } from '../reference/settings'
import { type CostName, lengthOf, shortestWay } from '../reference/shortest'
import { RULES } from '../reference/world'

/** Which planners, with which settings, may say `unreachable`. */
const COMPLETE: Readonly<Record<string, (params: Record<string, unknown>) => boolean>> = {
  decomposition: () => true,
  'visibility-graph': () => true,
  'probabilistic-roadmap': () => false,
  'potential-field': () => false,
  'potential-field-memory': () => false,
  bug1: () => true,
  bug2: ({ leave }) => leave === 'closer',
  'tangent-bug': ({ variant }) => variant === 'classic',
}

test('planners promise completeness as they should', () => {
  const dice = new Dice(5, 0)
  for (const planner of planners) {
    for (let i = 0; i < 20; i++) {
      const params = anySettings(planner.params, dice)
      const expected = COMPLETE[planner.id]
      if (expected) expect(planner.complete(params)).toBe(expected(params))
    }
  }
})

test('only these promise to be optimal', () => {
  const known = planners.filter(({ id }) => id in COMPLETE)
  const promised = known.flatMap((planner) =>
    RULES.flatMap((rule) =>
      ['cells', 'euclidean'].flatMap((cost) =>
        planner.optimal({ cost }, rule) ? [`${planner.id} ${rule} ${cost}`] : [],
      ),
    ),
  )
  expect(promised).toEqual(
    expect.arrayContaining([
      'decomposition if-at-most-one-obstacle cells',
      'decomposition if-at-most-one-obstacle euclidean',
      'decomposition only-when-no-obstacles cells',
      'decomposition only-when-no-obstacles euclidean',
      'visibility-graph only-when-no-obstacles cells',
    ]),
  )
  expect(promised).toHaveLength(5)
})

test('with any settings, each planner keeps what it promises', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const dice = new Dice(6, index)
    for (const planner of planners) {
      const params = anySettings(planner.params, dice)
      const found = run(world, planner.id, params)
      if (planner.complete(params)) mustBeComplete(world, found)
      else mustBeModest(world, found)
      if (!planner.optimal(params, world.rule)) continue
      const cost: CostName = params.cost === 'euclidean' ? 'euclidean' : 'cells'
      const best = shortestWay(world, cost)
      if (!best) continue
      const least = cost === 'cells' ? best.steps : lengthOf(best)
      must(
        isClose(found.outcome.cost, least),
        () => `${found.name}: promises to be optimal and costs ${found.outcome.cost} of ${least}`,
      )
    }
  })
})
