import { test as base, expect, type Page } from '@playwright/test'
import { MapOnScreen } from './map-on-screen'

export { expect }

interface Fixtures {
  /** Opened, at rest, and watched to the end of the test. */
  page: Page
  map: MapOnScreen
}

/**
 * Writes down all that a page must never do: say something in the console, throw, ask for anything
 * outside `home`, or ask in vain.
 */
function watch(page: Page, home: string): string[] {
  const faults: string[] = []
  const isOwn = (url: string) => url.startsWith(home) || /^(data|blob):/.test(url)
  page.on('console', (message) => faults.push(`console.${message.type()}: ${message.text()}`))
  page.on('pageerror', (error) => faults.push(`error: ${error.stack ?? error.message}`))
  page.on('request', (request) => {
    if (!isOwn(request.url())) faults.push(`request outside the page: ${request.url()}`)
  })
  page.on('requestfailed', (request) => {
    const why = request.failure()?.errorText
    // A reload and a download break off what is under way.
    if (why !== 'net::ERR_ABORTED') faults.push(`${why}: ${request.url()}`)
  })
  page.on('response', (response) => {
    if (response.status() >= 400) faults.push(`${response.status()}: ${response.url()}`)
  })
  return faults
}

export const test = base.extend<Fixtures>({
  page: async ({ page, baseURL }, use) => {
    const faults = watch(page, String(baseURL))
    await page.goto('')
    // Nobody does anything before there is a solved map to be seen.
    await expect(page.locator('#map')).toHaveAttribute('data-status', 'reached')
    await use(page)
    expect(faults, 'messages, errors and requests that should not be').toEqual([])
  },

  map: async ({ page }, use) => {
    await use(new MapOnScreen(page))
  },
})
