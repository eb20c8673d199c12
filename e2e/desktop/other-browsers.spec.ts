import { expect, test } from '../fixtures'

// What can be told of other browsers by looking at what they get.

test('the styles bring Firefox no rings in place of those that show the focus', async ({
  page,
}) => {
  for (const path of ['index.html', 'experiments.html']) {
    await page.goto(path)
    const addresses = await page
      .locator('link[rel=stylesheet]')
      .evaluateAll((links) => links.map((link) => (link as HTMLLinkElement).href))
    const sheets = addresses.map(async (address) => (await page.request.get(address)).text())
    const styles = (await Promise.all(sheets)).join('\n')
    expect(styles).toContain(':focus-visible')
    expect(styles).not.toContain(':-moz-focusring')
  }
})
