import { drawnRows, expectSaid, openMap, plannerSelect, tabTo } from '../actions'
import { expect, test } from '../fixtures'
import { press } from '../steps'

const ROWS = `
  ..........
  .S......G.
  ..........
`

test('a whole session without a mouse', async ({ map, page }) => {
  // A new map of 10 × 3 cells, by the menu and its dialog.
  const menuButton = await tabTo(page, 'button', 'Map')
  await page.keyboard.press('Enter')
  await expect(page.getByRole('menuitem', { name: 'New…' })).toBeFocused()
  await page.keyboard.press('ArrowUp')
  await expect(page.getByRole('menuitem', { name: /^Experiments/ })).toBeFocused()
  await page.keyboard.press('Home')
  await page.keyboard.press('Enter')
  const dialog = page.getByRole('dialog', { name: 'New map' })
  await expect(dialog).toBeVisible()
  await expect(dialog.getByLabel('Width')).toBeFocused()
  await page.keyboard.press('Control+a')
  await page.keyboard.type('10')
  await page.keyboard.press('Tab')
  await page.keyboard.press('Control+a')
  await page.keyboard.type('3')
  await page.keyboard.press('Enter')
  await expect(dialog).toBeHidden()
  await expect(menuButton).toBeFocused()
  await expect(map.element).toHaveAccessibleName(/^Map of 10 × 3 cells, start at \(1, 1\), goal/)

  // Another planner and a parameter of it.
  await tabTo(page, 'combobox', 'Planner')
  await page.keyboard.type('Grid')
  await expect(map.element).toHaveAttribute('data-planner', 'decomposition')
  await expectSaid(page, 'Planner: Grid decomposition. Reached in 8 cells.')
  await tabTo(page, 'combobox', 'Cost')
  await page.keyboard.press('ArrowDown')
  await expectSaid(page, 'Cost: euclidean. Reached in 8 cells.')

  // A wall, cell by cell.
  await map.element.focus()
  await expect(map.element).toHaveAttribute('data-cursor', '1,1')
  await press(page, 'ArrowRight', 3)
  await page.keyboard.press('ArrowUp')
  await expectSaid(page, /^\(4, 0\), free/)
  await page.keyboard.press('Space')
  await expectSaid(page, '(4, 0) is now an obstacle. Reached in 8 cells.')
  await page.keyboard.press('ArrowUp')
  await expectSaid(page, 'Edge of the map. (4, 0), obstacle.')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Space')
  await expectSaid(page, /^\(4, 2\) is now an obstacle\. Proven unreachable/)
  expect(await drawnRows(page)).toEqual(['....#.....', '....#.....', '....#.....'])
})

test('S and G set start and goal at the cursor', async ({ map, page }) => {
  await openMap(page, ROWS)
  await map.element.focus()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('s')
  await expectSaid(page, /^The start is now at \(1, 2\)\. Reached in 8 cells\.$/)
  await press(page, 'ArrowRight', 4)
  await page.keyboard.press('g')
  await expectSaid(page, /^The goal is now at \(5, 2\)\. Reached in 5 cells\.$/)
  await page.keyboard.press('Space')
  await expect(page.getByText('(5, 2) is the goal: no obstacle can be there.')).toBeVisible()
  await page.keyboard.press('ArrowUp')
  await page.keyboard.press('Space')
  await page.keyboard.press('Shift+S')
  await expect(page.getByText('(5, 1) is an obstacle: the start cannot be there.')).toBeVisible()
  await expect(map.element).toHaveAccessibleName(
    'Map of 10 × 3 cells, start at (1, 2), goal at (5, 2)',
  )
})

test('undo and redo, on the map and elsewhere', async ({ map, page }) => {
  await openMap(page, ROWS)
  await map.element.focus()
  await press(page, 'ArrowRight', 3)
  await page.keyboard.press('Enter')
  await expectSaid(page, /^\(4, 1\) is now an obstacle/)
  await page.keyboard.press('Control+z')
  await expectSaid(page, 'Undone. Reached in 8 cells.')
  expect((await drawnRows(page))[1]).toBe('..........')
  await page.keyboard.press('Control+Shift+Z')
  await expectSaid(page, /^Redone\. Reached/)
  await plannerSelect(page).focus()
  await page.keyboard.press('Control+z')
  await expectSaid(page, /^Undone\./)
  await page.keyboard.press('Control+y')
  await expectSaid(page, /^Redone\./)
  expect((await drawnRows(page))[1]).toBe('....#.....')
})

test('plus and minus zoom, 0 shows the whole map, Escape hides the cursor', async ({
  map,
  page,
}) => {
  await map.element.focus()
  const fitted = await map.view()
  await page.keyboard.press('+')
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(fitted.scale * 1.25)
  await press(page, '-', 2)
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(fitted.scale / 1.25)
  await page.keyboard.press('0')
  await expect.poll(() => map.view()).toEqual(fitted)
  await expect(map.element).not.toHaveAttribute('data-cursor', '')
  await page.keyboard.press('Escape')
  await expect(map.element).toHaveAttribute('data-cursor', '')
})

test('the cursor stays in sight on a map that is larger than the screen', async ({ map, page }) => {
  await map.element.focus()
  await press(page, '+', 8)
  await press(page, 'ArrowDown', 16)
  await press(page, 'ArrowRight', 10)
  const [x, y] = String(await map.element.getAttribute('data-cursor'))
    .split(',')
    .map(Number)
  expect([x, y]).toEqual([10, 17])
  const place = await map.cell(x, y)
  expect(place.x).toBeGreaterThan(0)
  expect(place.x).toBeLessThan(1280)
  expect(place.y).toBeGreaterThan(0)
  expect(place.y).toBeLessThan(800)
})

test('the frame that says where the keyboard is comes with the keyboard alone', async ({
  map,
  page,
}) => {
  const isFramed = () => map.element.evaluate((element) => element.matches(':focus-visible'))
  await map.click([0, 0])
  await expect(map.element).toBeFocused()
  expect(await isFramed()).toBe(false)
  await page.keyboard.press('Tab')
  await page.keyboard.press('Shift+Tab')
  await expect(map.element).toBeFocused()
  expect(await isFramed()).toBe(true)
})
