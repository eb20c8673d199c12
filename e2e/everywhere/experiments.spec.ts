import { expectAccessible } from '../accessibility'
import { ExperimentsPage, SMALL } from '../experiments'
import { expect, test } from '../fixtures'

test('the settings of experiments are accessible, with all fields open', async ({ page }) => {
  await new ExperimentsPage(page).open()
  for (const summary of await page.locator('#form summary').all()) await summary.click()
  await page.getByLabel('Samples').fill('many')
  await expectAccessible(page)
})

test('results of experiments fit the window and are accessible', async ({ page }) => {
  // Many marks, all looked at by axe.
  test.slow()
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  await page.getByText('The same as a table').first().click()
  await expectAccessible(page)
  const overhang = await page.evaluate(
    () => document.documentElement.scrollWidth - window.innerWidth,
  )
  expect(overhang).toBeLessThanOrEqual(0)

  await page.locator('#summary .number-button').first().click()
  await expect(page.getByRole('dialog', { name: 'Runs' })).toBeVisible()
  await expectAccessible(page)
})
