import { outcomeInWords } from '../../src/app/words/outcome-in-words'
import {
  type AnyPlanner,
  type Param,
  type ParamSettings,
  type ParamValue,
  plan,
  plannerById,
  planners,
  problemFromText,
} from '../../src/index'
import {
  choosePlanner,
  expectResult,
  expectSaid,
  openMap,
  paramControl,
  plannerSelect,
  resultNumber,
  setParam,
} from '../actions'
import { expect, test } from '../fixtures'
import type { MapOnScreen } from '../map-on-screen'

/** Two hollows and a slanting wall: enough for every setting to make a difference somewhere. */
const ROWS = `
  ................
  .....###........
  .......#...##...
  S......#..##..G.
  .......#.##.....
  .....###........
  ..##............
`

/** What the page must show, reckoned here. */
async function expectPlan(
  map: MapOnScreen,
  planner: AnyPlanner,
  params: ParamSettings = {},
  seed = 1,
) {
  const problem = problemFromText(ROWS)
  const outcome = plan(problem, planner.id, { params, seed })
  await expect(map.element).toHaveAttribute('data-planner', planner.id)
  await expect(map.element).toHaveAttribute('data-cells', String(outcome.path.length))
  await expectResult(map.element.page(), outcomeInWords(outcome, problem.grid.width))
}

/** Some values that a parameter may have, its ends among them; the last is not its default. */
function valuesOf(param: Param): readonly ParamValue[] {
  switch (param.kind) {
    case 'boolean':
      return [param.default, !param.default]
    case 'choice':
      return [param.default, ...param.choices.filter((choice) => choice !== param.default)]
    default:
      return [param.min, param.max, Math.min(param.min + 24, param.max)]
  }
}

test.beforeEach(async ({ page }) => {
  await openMap(page, ROWS)
})

for (const planner of planners) {
  test(`${planner.title}: every parameter is obeyed`, async ({ map, page }) => {
    await choosePlanner(page, planner.title)
    await expectPlan(map, planner)
    let params: ParamSettings = {}
    for (const param of planner.params) {
      for (const value of valuesOf(param)) {
        await setParam(page, param.label, value)
        params = { ...params, [param.name]: value }
        await expectPlan(map, planner, params)
      }
    }
    if (planner.usesSeed) {
      for (const seed of [0, 2, 2 ** 31 - 1]) {
        await paramControl(page, 'Seed').fill(String(seed))
        await expectPlan(map, planner, params, seed)
      }
    }
    if (planner.params.length === 0 && !planner.usesSeed) return
    await page.getByRole('button', { name: 'Reset to defaults' }).click()
    await expectPlan(map, planner)
  })
}

test('what each planner is, what it needs and what it promises', async ({ page }) => {
  const card = page.getByRole('region', { name: 'Planner', exact: true })
  for (const planner of planners) {
    await choosePlanner(page, planner.title)
    await expect(card.getByText(planner.summary)).toBeVisible()
    for (const { label, help } of planner.params) {
      await expect(paramControl(page, label)).toHaveAccessibleDescription(help)
    }
    await card.getByRole('button', { name: 'What it is and promises' }).click()
    const about = page.getByRole('dialog', { name: planner.title, exact: true })
    await expect(about.getByText(planner.promise)).toBeVisible()
    await expect(about.getByText(planner.source)).toBeVisible()
    const lines = await about.getByRole('listitem').allInnerTexts()
    expect(lines, 'the pseudocode with its indents').toEqual(planner.pseudocode)
    await about.getByRole('button', { name: 'Close' }).click()
    await expect(about).toBeHidden()
  }
})

test('planners are grouped by what they see, in the order of the list', async ({ page }) => {
  const titles = (family: AnyPlanner['family']) =>
    planners.filter((planner) => planner.family === family).map(({ title }) => title)
  // A list that is closed shows no options that could be found by their role.
  const group = (name: string) => plannerSelect(page).locator(`optgroup[label="${name}"] option`)
  await expect(group('Sees the whole map')).toHaveText(titles('offline'))
  await expect(group('Senses as it goes')).toHaveText(titles('online'))
})

test('each planner keeps its own parameters', async ({ page }) => {
  await choosePlanner(page, 'Bug1')
  await setParam(page, 'Turn', 'right')
  await choosePlanner(page, 'Bug2')
  await expect(paramControl(page, 'Turn')).toHaveValue('left')
  await choosePlanner(page, 'Bug1')
  await expect(paramControl(page, 'Turn')).toHaveValue('right')
})

test('undo of the planner from within its parameters leaves the focus in the card', async ({
  page,
}) => {
  await choosePlanner(page, 'Bug2')
  await paramControl(page, 'Leave the boundary').focus()
  await page.keyboard.press('Control+z')
  await expect(plannerSelect(page)).toHaveValue('tangent-bug')
  await expect(plannerSelect(page)).toBeFocused()
})

test('a value out of bounds is refused at its field, and the plan stays', async ({ map, page }) => {
  await choosePlanner(page, 'Tangent Bug')
  await setParam(page, 'Sensor range', 3)
  await expectPlan(map, plannerById('tangent-bug'), { range: 3 })
  const cells = String(await map.element.getAttribute('data-cells'))
  const range = paramControl(page, 'Sensor range')
  for (const [text, why] of [
    ['0', /^0 is not from 1 to \d+\.$/],
    ['2.5', '2.5 is not a whole number.'],
    ['', /^Enter a whole number from 1 to \d+\.$/],
  ] as const) {
    await range.fill(text)
    await expect(range).toHaveAttribute('aria-invalid', 'true')
    await expect(page.getByText(why)).toBeVisible()
    await expect(map.element).toHaveAttribute('data-cells', cells)
  }
  await range.fill('2')
  await expect(range).not.toHaveAttribute('aria-invalid')
})

test('an empty number of samples stands for the number of columns', async ({ map, page }) => {
  await choosePlanner(page, 'Probabilistic roadmap')
  const samples = paramControl(page, 'Samples')
  await expect(samples).toHaveAttribute('placeholder', '16 (automatic)')
  await samples.fill('0')
  await expectResult(page, /^No path found: these samples do not join start and goal/)
  await samples.fill('')
  const outcome = plan(problemFromText(ROWS), 'probabilistic-roadmap')
  await expect(map.element).toHaveAttribute('data-status', outcome.status)
  await expect(map.element).toHaveAttribute('data-cells', String(outcome.path.length))
})

test('a number that was entered is said with its thousands set apart', async ({ page }) => {
  await choosePlanner(page, 'Probabilistic roadmap')
  await paramControl(page, 'Samples').fill('12345')
  await page.keyboard.press('Enter')
  await expectSaid(page, /^Samples: 12,345\. /)
  await choosePlanner(page, 'Potential field')
  await paramControl(page, 'Repulsive value').fill('1234.56789')
  await page.keyboard.press('Enter')
  await expectSaid(page, /^Repulsive value: 1,234\.56789\. /)
})

test('the diagonal rule holds for every planner', async ({ map, page }) => {
  const rule = page.getByLabel('Diagonal steps')
  await rule.selectOption('Only when no obstacles')
  const problem = problemFromText(ROWS, 'only-when-no-obstacles')
  for (const planner of planners) {
    await choosePlanner(page, planner.title)
    const outcome = plan(problem, planner.id)
    await expect(map.element).toHaveAttribute('data-cells', String(outcome.path.length))
    await expectResult(page, outcomeInWords(outcome, problem.grid.width))
    await expect(rule).toHaveValue('only-when-no-obstacles')
  }
})

test('the result card has the numbers of the plan', async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await expectResult(page, /^Reached/)
  const { path, measure, expanded } = plan(problemFromText(ROWS), 'decomposition')
  await expect(resultNumber(page, 'Time to plan')).toHaveText(
    /^(too short to measure|\d+(\.\d)? ms)$/,
  )
  await expect(resultNumber(page, 'Path')).toHaveText(`${path.length} cells`)
  await expect(resultNumber(page, 'Euclidean length')).toHaveText(measure.length.toFixed(2))
  await expect(resultNumber(page, 'Turns')).toHaveText(String(measure.turns))
  await expect(resultNumber(page, 'Expanded')).toHaveText(String(expanded))

  await choosePlanner(page, 'Bug1')
  const { sensed } = plan(problemFromText(ROWS), 'bug1')
  await expect(resultNumber(page, 'Sensed')).toHaveText(`${sensed} cells`)
  await expect(resultNumber(page, 'Expanded')).toBeHidden()
})

test('another seed draws another roadmap, the same seed the same', async ({ map, page }) => {
  const problem = problemFromText(ROWS)
  const planner = plannerById('probabilistic-roadmap')
  await choosePlanner(page, planner.title)
  await setParam(page, 'Samples', 8)
  const params = { samples: 8 }
  const answers = new Set<number>()
  for (const seed of [1, 5, 6, 1]) {
    await paramControl(page, 'Seed').fill(String(seed))
    await expectPlan(map, planner, params, seed)
    answers.add(plan(problem, planner.id, { params, seed }).path.length)
  }
  expect(answers.size).toBe(3)
})
