import type { Page } from '@playwright/test'
import { expect, test } from '../fixtures'
import { hiddenParts } from '../hidden-parts'
import { drawn, expectStep, openScenario, press, scrubber, stepsInAll } from '../steps'

const SCENARIOS = [
  'Fig. 5: Around two obstacles',
  'Fig. 12: The spiral, Bug2',
  'Fig. 14: A slanting wall, Tangent Bug',
  'Path Planner in letters',
]
const FOLDS = ['planner card', 'result card', 'card of steps']

const fold = (page: Page, card: string) => page.getByRole('button', { name: `Fold the ${card}` })

test('the map lies clear of all that explains it, at every landmark', async ({ map, page }) => {
  await expect.poll(() => hiddenParts(page, map)).toEqual([])
  for (const scenario of SCENARIOS) {
    await openScenario(page, scenario)
    await expect.poll(() => hiddenParts(page, map), scenario).toEqual([])
    const steps = await stepsInAll(page)
    await press(page, 'Home')
    for (let landmark = 1; landmark < 8; landmark++) {
      await press(page, 'Shift+ArrowRight')
      await drawn(page)
      const step = await scrubber(page).inputValue()
      expect(await hiddenParts(page, map), `${scenario}: step ${step}`).toEqual([])
      if (Number(step) === steps) break
    }
    await expectStep(page, steps, steps)
  }
})

test('whatever card is open, the map moves out of its way', async ({ map, page }) => {
  await openScenario(page, 'Fig. 12: The spiral, Bug2')
  for (const card of FOLDS) {
    const before = await fold(page, card).getAttribute('aria-expanded')
    await fold(page, card).click()
    await expect(fold(page, card)).toHaveAttribute('aria-expanded', String(before === 'false'))
    await expect.poll(() => hiddenParts(page, map), card).toEqual([])
    const { scale } = await map.view()
    expect(scale, 'cells that can still be told apart').toBeGreaterThan(8)
  }
  await fold(page, FOLDS[0]).click()
  await expect.poll(() => hiddenParts(page, map)).toEqual([])
})

test('the map is as large when its plan comes late', async ({ map, page }) => {
  const { scale } = await map.view()
  await page.route(/worker/, async (route) => {
    // So late that the page shows progress before.
    await expect(page.getByRole('button', { name: 'Cancel' })).toBeVisible()
    await route.continue()
  })
  await page.reload()
  await expect(page.locator('#map')).toHaveAttribute('data-status', 'reached')
  await expect.poll(async () => (await map.view()).scale).toBe(scale)
})
