import type { Page } from '@playwright/test'
import { expect, test } from '../fixtures'

// What can be told of other browsers by looking at what they get.

const PAGES = ['index.html', 'experiments.html']

/** All styles of the page that is open. */
async function stylesOf(page: Page): Promise<string> {
  const addresses = await page
    .locator('link[rel=stylesheet]')
    .evaluateAll((links) => links.map((link) => (link as HTMLLinkElement).href))
  const sheets = addresses.map(async (address) => (await page.request.get(address)).text())
  return (await Promise.all(sheets)).join('\n')
}

test('the styles bring Firefox no rings in place of those that show the focus', async ({
  page,
}) => {
  for (const path of PAGES) {
    await page.goto(path)
    const styles = await stylesOf(page)
    expect(styles).toContain(':focus-visible')
    expect(styles).not.toContain(':-moz-focusring')
  }
})

test('the height of the window is what the bars of a phone’s browser leave of it', async ({
  page,
}) => {
  for (const path of PAGES) {
    await page.goto(path)
    const styles = await stylesOf(page)
    expect(styles).toMatch(/\ddvh\b/)
    expect(styles).not.toMatch(/\dvh\b/)
  }
})

test('Safari zooms the page for no button that is tapped twice', async ({ page }) => {
  for (const path of PAGES) {
    await page.goto(path)
    const touch = await page
      .locator('button')
      .evaluateAll((buttons) => buttons.map((button) => getComputedStyle(button).touchAction))
    expect(touch.filter((action) => action !== 'none' && action !== 'manipulation')).toEqual([])
    expect(touch).toContain('manipulation')
  }
})
