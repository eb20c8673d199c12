import type { Page } from '@playwright/test'
import { chooseFromMapMenu, choosePlanner, drawnRows, expectResult, openMap } from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ...#......
  .S.#....G.
  ..........
`

const dialogOf = (page: Page) => page.getByRole('dialog', { name: 'New map' })

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROWS)
  await chooseFromMapMenu(page, 'New…')
  // It is loaded only now.
  await expect(dialogOf(page)).toBeVisible()
})

test('an empty map of any size', async ({ map, page }) => {
  const dialog = dialogOf(page)
  await expect(dialog.getByLabel('Width')).toHaveValue('10')
  await expect(dialog.getByLabel('Height')).toHaveValue('3')
  await dialog.getByLabel('Width').fill('60')
  await dialog.getByLabel('Height').fill('40')
  await dialog.getByRole('button', { name: 'Create' }).click()
  await expect(dialog).toBeHidden()
  await expect(map.element).toHaveAccessibleName(/^Map of 60 × 40 cells/)
  expect(await drawnRows(page)).toEqual(Array.from({ length: 40 }, () => '.'.repeat(60)))
  await expectResult(page, /^Reached/)
})

test('opened again it holds the size on screen, whatever was typed before', async ({ page }) => {
  const dialog = dialogOf(page)
  const sizes = [dialog.getByLabel('Width'), dialog.getByLabel('Height')]
  for (const typed of ['', '12', '5000']) {
    if (typed) await sizes[0].fill(typed)
    await dialog.getByRole('button', { name: 'Cancel' }).click()
    await chooseFromMapMenu(page, 'New…')
    await expect(sizes[0]).toHaveValue('10')
    await expect(sizes[1]).toHaveValue('3')
    await expect(sizes[0]).not.toHaveAttribute('aria-invalid')
  }
})

test('the drawing is kept, cut and extended', async ({ page }) => {
  await page.getByText('Keep the drawing').click()
  await dialogOf(page).getByLabel('Width').fill('5')
  await dialogOf(page).getByLabel('Height').fill('4')
  await page.keyboard.press('Enter')
  expect(await drawnRows(page)).toEqual(['...#.', '...#.', '.....', '.....'])
  await expectResult(page, 'Reached in 4 cells')
  await page.keyboard.press('Control+z')
  expect(await drawnRows(page)).toEqual(['...#......', '...#......', '..........'])
})

test('smallest and largest', async ({ map, page }) => {
  const size = async (width: string, height: string) => {
    await dialogOf(page).getByLabel('Width').fill(width)
    await dialogOf(page).getByLabel('Height').fill(height)
    await page.getByRole('button', { name: 'Create' }).click()
    await expect(map.element).toHaveAttribute('data-width', width)
  }
  await size('2', '2')
  await expectResult(page, 'Reached in 2 cells')
  await chooseFromMapMenu(page, 'New…')
  await size('2048', '2048')
  await expectResult(page, /^Reached in 1,\d\d\d cells$/)
})

test('a size out of bounds is refused at its field', async ({ map, page }) => {
  const dialog = dialogOf(page)
  for (const [label, text, why] of [
    ['Width', '1', '1 is not from 2 to 2048.'],
    ['Width', '2049', '2049 is not from 2 to 2048.'],
    ['Width', '', 'Enter a whole number from 2 to 2048.'],
    ['Height', '3.5', '3.5 is not a whole number.'],
    ['Height', '-4', '-4 is not from 2 to 2048.'],
    ['Height', '1e9', '1000000000 is not from 2 to 2048.'],
  ] as const) {
    const field = dialog.getByLabel(label)
    const usual = await field.inputValue()
    await field.fill(text)
    await dialog.getByRole('button', { name: 'Create' }).click()
    await expect(dialog.getByText(why)).toBeVisible()
    await expect(field).toBeFocused()
    await expect(field).toHaveAccessibleDescription(why)
    await expect(field).toHaveAttribute('aria-invalid', 'true')
    await field.fill(usual)
  }
  await page.keyboard.press('Escape')
  await expect(dialog).toBeHidden()
  await expect(map.element).toHaveAccessibleName(/^Map of 10 × 3 cells, start at \(1, 1\)/)
})

test('a drawing without a free cell in what is kept cannot be cut so', async ({ page }) => {
  await page.keyboard.press('Escape')
  await openMap(page, '##.\n##S\n..G')
  await chooseFromMapMenu(page, 'New…')
  await page.getByText('Keep the drawing').click()
  await dialogOf(page).getByLabel('Width').fill('2')
  await dialogOf(page).getByLabel('Height').fill('2')
  await page.getByRole('button', { name: 'Create' }).click()
  await expect(page.getByRole('alert')).toHaveText('On 2 × 2 cells of this map no cell is free.')
  expect(await drawnRows(page)).toEqual(['##.', '##.', '...'])
})
