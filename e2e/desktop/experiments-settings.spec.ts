import { readSettings } from '../../src/experiments/settings-check'
import { dropBoth } from '../actions'
import { ExperimentsPage, SMALL } from '../experiments'
import { expect, test } from '../fixtures'

test('a wrong field is named where it stands, and nothing is run', async ({ page }) => {
  await new ExperimentsPage(page).open()
  await page.locator('summary', { hasText: 'Probabilistic roadmap' }).click()
  const samples = page.getByLabel('Samples')
  await samples.fill('20, many')
  await expect(samples).toHaveAttribute('aria-invalid', 'true')
  await expect(page.getByText(/"many" is no number/)).toBeVisible()
  await page.getByRole('button', { name: 'Run', exact: true }).click()
  await expect(samples).toBeFocused()
  await expect(page.getByRole('progressbar')).toBeHidden()
  await samples.fill('20, 40')
  await expect(samples).not.toHaveAttribute('aria-invalid', 'true')
  await expect(page.getByText('200 maps × 11 planner settings = 2,200 runs')).toBeVisible()
})

test('who adds and removes planners with the keyboard keeps the focus', async ({ page }) => {
  await new ExperimentsPage(page).open()
  const add = page.getByLabel('Add a planner')
  await add.focus()
  await page.keyboard.press('B')
  await expect(page.getByText('Bug1 is there twice.')).toBeVisible()
  await expect(add).toBeFocused()
  await page.getByRole('button', { name: 'Remove Bug1' }).last().focus()
  await page.keyboard.press('Enter')
  await expect(page.getByText('200 maps × 13 planner settings')).toBeVisible()
  await expect(add).toBeFocused()
})

test('settings are saved and opened again; a file that is broken changes nothing', async ({
  page,
}) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.openFile('mine.json', JSON.stringify(SMALL))
  await expect(page.getByText('42 maps × 9 planner settings = 378 runs')).toBeVisible()
  await experiments.openFile('broken.json', JSON.stringify({ ...SMALL, seed: 'x' }))
  await expect(page.getByText(/broken\.json was not opened\. seed: must be/)).toBeVisible()
  expect(readSettings(await experiments.downloaded('Save'))).toEqual(SMALL)
})

test('of two files that are read at once, the one that was asked for last is opened', async ({
  page,
}) => {
  await new ExperimentsPage(page).open()
  const readFirst = await dropBoth(
    page,
    JSON.stringify({ ...SMALL, seed: 8 }),
    JSON.stringify(SMALL),
  )
  await expect(page.getByText('Opened last.txt.')).toBeVisible()
  await readFirst()
  await expect(page.getByLabel('Seed')).toHaveValue(String(SMALL.seed))
  await expect(page.getByText('first.txt')).toHaveCount(0)
})

test('maps from files are a family of their own', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  const reader = page.waitForEvent('worker', (worker) => /open-worker/.test(worker.url()))
  await experiments.openFile('own.txt', 'S..\n.#.\n..G\n', '#map-files')
  await reader
  await expect(page.getByText('own.txt, 3 × 3')).toBeVisible()
  await experiments.openFile('bad.txt', 'S?\n.G\n', '#map-files')
  await expect(page.getByText(/bad\.txt was not opened/)).toBeVisible()
  await page.getByLabel('Least distance').fill('2')
  await expect(page.getByText('220 maps × 13 planner settings')).toBeVisible()
})

test('a link that is broken is refused, and what was drawn stays', async ({ page, map }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  const before = await map.view()
  await page.goto('index.html#setup=nonsense')
  await expect(page.getByRole('alert')).toContainText('The link was not opened. It is damaged')
  expect(await map.view()).toEqual(before)
  expect(new URL(page.url()).hash).toBe('')
})

test('the two pages lead to each other', async ({ page }) => {
  await page.getByRole('button', { name: 'Map', exact: true }).click()
  await page.getByRole('menuitem', { name: 'Experiments' }).click()
  await expect(page.getByRole('heading', { name: 'Experiments' })).toBeVisible()
  await page.getByRole('link', { name: 'Playground' }).click()
  await expect(page.locator('#map')).toBeVisible()
})
