import { completeParams } from '../../src/algorithms/params'
import { type ParamSettings, planners, problemFromText } from '../../src/index'
import { choosePlanner, expectResult, openMap, setParam } from '../actions'
import { expect, test } from '../fixtures'

/** One cell is missing in the wall around the goal. */
const ALMOST_WALLED_IN = `
  .................
  ..........#####..
  ..........#......
  .S........#..G#..
  ..........#####..
  .................
`
const GAP = [14, 2] as const

/** How those end that can prove it, and how those that cannot. */
const PROOF = /^Proven unreachable: [a-z]/
const GIVEN_UP =
  /^(No path found: [a-z].*|Stuck in a local minimum at \(\d+, \d+\)|Dead end at \(\d+, \d+\)|Loop: [a-z].*)$/

const WORDS: Readonly<Record<string, RegExp | string>> = {
  decomposition: 'Proven unreachable: every cell that can be reached from the start was tried',
  'visibility-graph': 'Proven unreachable: the visibility graph does not join start and goal',
  'probabilistic-roadmap': /^No path found: these samples do not join start and goal/,
  'potential-field': /^Stuck in a local minimum at /,
  'potential-field-memory': /^Dead end at /,
  bug1: /^Proven unreachable: went round the obstacle once/,
  bug2: /^Loop: /,
  'tangent-bug': /^Loop: /,
}

for (const { id, title, params, complete } of planners) {
  test(`a goal walled in, and ${title}`, async ({ map, page }) => {
    const problem = problemFromText(ALMOST_WALLED_IN)
    const isComplete = (settings: ParamSettings) =>
      complete(completeParams({ id, params }, settings, problem))
    await choosePlanner(page, title)
    await openMap(page, ALMOST_WALLED_IN)
    await map.click(GAP)
    await expectResult(page, isComplete({}) ? PROOF : GIVEN_UP)
    if (id in WORDS) await expectResult(page, WORDS[id])

    for (const param of params) {
      if (param.kind !== 'choice') continue
      for (const choice of param.choices) {
        await setParam(page, param.label, choice)
        await expectResult(page, isComplete({ [param.name]: choice }) ? PROOF : GIVEN_UP)
      }
      await setParam(page, param.label, param.default)
    }
    await expect(map.element).toHaveAttribute('data-goal', '13,3')
  })
}

test('some settings prove what others cannot', async ({ map, page }) => {
  await openMap(page, ALMOST_WALLED_IN)
  await map.click(GAP)
  await choosePlanner(page, 'Bug2')
  await setParam(page, 'Leave the boundary', 'closer')
  await expectResult(page, PROOF)
  await choosePlanner(page, 'Tangent Bug')
  await setParam(page, 'Variant', 'classic')
  await expectResult(page, PROOF)
})

test('start and goal alone in their cells', async ({ page }) => {
  await openMap(page, 'S##\n###\n##G')
  for (const { title } of planners) {
    await choosePlanner(page, title)
    await expectResult(page, /^(Proven unreachable|No path found|Stuck|Dead end|Loop)/)
  }
})
