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

test('what is said of a file is seen, wherever the page is scrolled to', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  const toldOf = async (name: string) => {
    await experiments.openFile(name, '{}')
    const message = page.locator('.toast', { hasText: `${name} was not opened.` })
    await expect(message).toBeInViewport({ ratio: 1 })
    const box = await message.boundingBox()
    expect(box?.width).toBeGreaterThan(300)
  }
  await toldOf('first.json')
  await page.getByLabel('Add a planner').scrollIntoViewIfNeeded()
  await toldOf('second.json')
})
