import type { Locator, Page } from '@playwright/test'
import { drawnRows, expectResult, expectSaid, openMap, plannerSelect } from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ..........
  .S......G.
  ..........
`

/** Presses a key so often. */
async function times(page: Page, count: number, key: string) {
  for (let i = 0; i < count; i++) await page.keyboard.press(key)
}

/** Presses Tab until the focus is on what is looked for. */
async function tabTo(
  page: Page,
  role: 'button' | 'combobox' | 'switch' | 'spinbutton',
  name: string,
) {
  const target = page.getByRole(role, { name, exact: true })
  const isFocused = () => target.evaluate((element) => element === document.activeElement)
  for (let i = 0; i < 40; i++) {
    if (await isFocused()) return target
    await page.keyboard.press('Tab')
  }
  throw new Error(`Tab does not lead to the ${role} "${name}".`)
}

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
  await times(page, 3, 'ArrowRight')
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
  await times(page, 4, 'ArrowRight')
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
  await times(page, 3, 'ArrowRight')
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
  await times(page, 2, '-')
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(fitted.scale / 1.25)
  await page.keyboard.press('0')
  await expect.poll(() => map.view()).toEqual(fitted)
  await expect(map.element).not.toHaveAttribute('data-cursor', '')
  await page.keyboard.press('Escape')
  await expect(map.element).toHaveAttribute('data-cursor', '')
})

test('the cursor stays in sight on a map that is larger than the screen', async ({ map, page }) => {
  await map.element.focus()
  for (let i = 0; i < 8; i++) await page.keyboard.press('+')
  await times(page, 16, 'ArrowDown')
  await times(page, 10, 'ArrowRight')
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

/** Tabs through a dialog, closes it, and the focus must be where it was. */
async function leaveByEscape(page: Page, name: string, opener: Locator) {
  const dialog = page.getByRole('dialog', { name })
  await expect(dialog).toBeVisible()
  // Beyond its last control the focus goes to the browser, never to what lies behind.
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press('Tab')
    const focus = await dialog.evaluate((element) => {
      const { activeElement, body } = document
      return element.contains(activeElement) || activeElement === body
        ? ''
        : activeElement?.outerHTML
    })
    expect(focus, 'what lies behind and has the focus').toBe('')
  }
  await page.keyboard.press('Escape')
  await expect(dialog).toBeHidden()
  await expect(opener).toBeFocused()
}

test('Escape closes each dialog and gives the focus back', async ({ page }) => {
  const menuButton = await tabTo(page, 'button', 'Map')
  for (const [entry, name] of [
    ['New…', 'New map'],
    ['Scenarios…', 'Scenarios'],
    ['Generate…', 'Generate a map'],
  ] as const) {
    await page.keyboard.press('Space')
    await expect(menuButton).toHaveAttribute('aria-expanded', 'true')
    const item = page.getByRole('menuitem', { name: entry })
    const isFocused = () => item.evaluate((element) => element === document.activeElement)
    while (!(await isFocused())) await page.keyboard.press('ArrowDown')
    await page.keyboard.press('Enter')
    await leaveByEscape(page, name, menuButton)
  }
  for (const [opener, name] of [
    ['Help and keys', 'Help and keys'],
    ['What it is and promises', 'Tangent Bug'],
  ] as const) {
    const button = await tabTo(page, 'button', opener)
    await page.keyboard.press('Enter')
    await leaveByEscape(page, name, button)
  }
})

test('the menu closes with Escape, and the focus is at its button', async ({ page }) => {
  const button = await tabTo(page, 'button', 'Map')
  await page.keyboard.press('Enter')
  await page.keyboard.press('End')
  await page.keyboard.press('Escape')
  await expect(page.getByRole('menu')).toBeHidden()
  await expect(button).toBeFocused()
  await expect(button).toHaveAttribute('aria-expanded', 'false')
})

test('a question mark shows all keys', async ({ map, page }) => {
  await map.element.focus()
  await page.keyboard.press('?')
  await expect(page.getByRole('dialog', { name: 'Help and keys' })).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(map.element).toBeFocused()
})

test('keys on the map do nothing to it while a dialog is open', async ({ page }) => {
  await openMap(page, ROWS)
  await page.getByRole('button', { name: 'Help and keys' }).click()
  await expect(page.getByRole('dialog', { name: 'Help and keys' })).toBeVisible()
  await page.keyboard.press('Control+z')
  await page.keyboard.press('Escape')
  expect(await drawnRows(page)).toHaveLength(3)
  await expectResult(page, 'Reached in 8 cells')
})
