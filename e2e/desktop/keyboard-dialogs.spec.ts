import type { Locator, Page } from '@playwright/test'
import { drawnRows, expectResult, openMap, tabTo } from '../actions'
import { expect, test } from '../fixtures'

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
  await openMap(page, '....\n.S.G\n....')
  await page.getByRole('button', { name: 'Help and keys' }).click()
  await expect(page.getByRole('dialog', { name: 'Help and keys' })).toBeVisible()
  await page.keyboard.press('Control+z')
  await page.keyboard.press('Escape')
  expect(await drawnRows(page)).toHaveLength(3)
  await expectResult(page, 'Reached in 3 cells')
})
