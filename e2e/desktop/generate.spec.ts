import type { Locator, Page } from '@playwright/test'
import { generators } from '../../src/grid/generators'
import { maze } from '../../src/grid/generators/maze'
import { chooseFromMapMenu, drawnRows, expectSettled, saveMap } from '../actions'
import { expect, test } from '../fixtures'

const SIZE = { width: 31, height: 21 }

const dialogOf = (page: Page) => page.getByRole('dialog', { name: 'Generate a map' })

const wallsOf = (rows: readonly string[]) =>
  [...rows.join('')].map((sign) => (sign === '#' ? 1 : 0))

/** Opens the dialog and fills in all but the parameters of this kind of map. */
async function fillIn(page: Page, title: string, seed: number): Promise<Locator> {
  await chooseFromMapMenu(page, 'Generate…')
  const dialog = dialogOf(page)
  await dialog.getByLabel('Kind').selectOption({ label: title })
  await dialog.getByLabel('Width').fill(String(SIZE.width))
  await dialog.getByLabel('Height').fill(String(SIZE.height))
  await dialog.getByLabel('Seed', { exact: true }).fill(String(seed))
  return dialog
}

async function generate(page: Page, title: string, seed: number): Promise<string> {
  const dialog = await fillIn(page, title, seed)
  await dialog.getByRole('button', { name: 'Generate' }).click()
  await expect(dialog).toBeHidden()
  await expectSettled(page)
  return (await saveMap(page)).text
}

for (const { title, params, generate: make } of generators) {
  test(`${title}: the same seed gives the same map, another another`, async ({ page }) => {
    const first = await generate(page, title, 7)
    const other = await generate(page, title, 8)
    expect(other).not.toBe(first)
    expect(await generate(page, title, 7)).toBe(first)
    const { grid } = make(SIZE, {}, 7, 'if-at-most-one-obstacle')
    expect(wallsOf(JSON.parse(first).rows)).toEqual([...grid.walls])
  })

  test(`${title}: every parameter is checked and obeyed`, async ({ page }) => {
    const dialog = await fillIn(page, title, 5)
    for (const { label, min, max } of params) {
      const field = dialog.getByLabel(label)
      await field.fill(String(max + 1))
      await dialog.getByRole('button', { name: 'Generate' }).click()
      await expect(field).toHaveAccessibleDescription(
        new RegExp(`${max + 1} is not from ${min} to ${max}\\.$`),
      )
      await expect(field).toBeFocused()
      await field.fill(String(min))
    }
    await dialog.getByRole('button', { name: 'Generate' }).click()
    await expect(dialog).toBeHidden()
    const values = Object.fromEntries(params.map(({ name, min }) => [name, min]))
    const { grid } = make(SIZE, values, 5, 'if-at-most-one-obstacle')
    expect(wallsOf(await drawnRows(page))).toEqual([...grid.walls])
  })
}

test('the dice throws another seed', async ({ page }) => {
  await chooseFromMapMenu(page, 'Generate…')
  const seed = dialogOf(page).getByLabel('Seed', { exact: true })
  const seeds = new Set([await seed.inputValue()])
  for (let i = 0; i < 4; i++) {
    await page.getByRole('button', { name: 'Another seed' }).click()
    seeds.add(await seed.inputValue())
  }
  expect(seeds.size).toBeGreaterThan(2)
})

test.describe('a large map, while its worker is at work', () => {
  /** Asks for a map that comes only once `release` is called. */
  async function generateLarge(page: Page): Promise<{ release: () => void }> {
    const held: (() => void)[] = []
    await page.route(/generate-worker/, (route) => {
      held.push(() => void route.continue())
    })
    const dialog = await fillIn(page, 'Maze', 7)
    await dialog.getByLabel('Width').fill('300')
    await dialog.getByLabel('Height').fill('301')
    await dialog.getByRole('button', { name: 'Generate' }).click()
    await expect(dialog).toBeHidden()
    await expect(page.getByRole('progressbar', { name: 'Generating…' })).toBeVisible()
    return { release: () => held.map((go) => go()) }
  }

  test('is waited for, with the page as it was, and undo leads back', async ({ map, page }) => {
    const before = await drawnRows(page)
    const { release } = await generateLarge(page)
    await expectSettled(page)
    expect(await drawnRows(page)).toEqual(before)
    release()
    await expect(map.element).toHaveAttribute('data-width', '300')
    await expect(page.getByText('Generating…')).toBeHidden()
    const { grid } = maze.generate({ width: 300, height: 301 }, {}, 7, 'if-at-most-one-obstacle')
    expect(wallsOf(await drawnRows(page))).toEqual([...grid.walls])
    await page.keyboard.press('Control+z')
    expect(await drawnRows(page)).toEqual(before)
  })

  test('can be cancelled', async ({ page }) => {
    const before = await drawnRows(page)
    await generateLarge(page)
    await page.getByRole('button', { name: 'Cancel' }).click()
    await expect(page.getByText('Cancelled.')).toBeVisible()
    await expect(page.getByText('Generating…')).toBeHidden()
    expect(await drawnRows(page)).toEqual(before)
  })

  test('does not come in the place of what is drawn meanwhile', async ({ map, page }) => {
    const before = await drawnRows(page)
    await generateLarge(page)
    await map.click([0, 0])
    await expect(page.getByText('the map on screen was changed meanwhile')).toBeVisible()
    await expect(page.getByText('Generating…')).toBeHidden()
    const after = await drawnRows(page)
    expect(after).not.toEqual(before)
    expect(after.length).toBe(before.length)
  })
})
