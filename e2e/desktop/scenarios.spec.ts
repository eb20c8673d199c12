import { scenarios } from '../../src/app/scenarios/scenarios'
import { chooseFromMapMenu, expectResult, plannerSelect } from '../actions'
import { expect, test } from '../fixtures'

/** What the report's figures show, in the words of the result card. */
const RESULTS: Readonly<Record<string, string | RegExp>> = {
  fig05: 'Reached in 21 cells',
  fig06: 'Stuck in a local minimum at (6, 3)',
  fig07: 'Reached in 21 cells',
  fig09: 'Reached in 7 cells',
  'fig11-bug1': 'Reached in 55 cells',
  'fig11-bug2': 'Reached in 25 cells',
  'fig12-bug1': 'Reached in 262 cells',
  'fig12-bug2': /^Loop: hit point \(6, 2\) again, in the same state as after \d+ steps$/,
  fig13: /^Reached in (1\d|2[0-4]) cells$/,
  'fig14-bug2': 'Reached in 25 cells',
  'fig14-tangent-bug': /^Reached in (2[6-9]|3\d) cells$/,
  banner: 'Reached in 42 cells',
  'banner-a-star': 'Reached in 42 cells',
}

test('each figure of the report, opened from the menu, shows what it shows', async ({
  map,
  page,
}) => {
  for (const { id, title, figure, see, planner, problem } of scenarios) {
    await chooseFromMapMenu(page, 'Scenarios…')
    const dialog = page.getByRole('dialog', { name: 'Scenarios' })
    await expect(dialog.getByText(see)).toBeVisible()
    await dialog.getByRole('button', { name: figure ? `${figure}: ${title}` : title }).click()
    await expect(dialog).toBeHidden()
    await expectResult(page, RESULTS[id])
    await expect(plannerSelect(page)).toHaveValue(planner)
    await expect(map.element).toHaveAttribute('data-width', String(problem.grid.width))
    await expect(map.element).toHaveAttribute('data-height', String(problem.grid.height))
  }
})

test('a scenario is one step to undo', async ({ map, page }) => {
  const before = await map.element.getAttribute('aria-label')
  await chooseFromMapMenu(page, 'Scenarios…')
  await page.getByRole('button', { name: 'Caught in a hollow' }).click()
  await expectResult(page, RESULTS.fig06)
  await page.keyboard.press('Control+z')
  await expect(map.element).toHaveAttribute('aria-label', String(before))
  await expect(plannerSelect(page)).toHaveValue('tangent-bug')
})
