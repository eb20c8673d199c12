// How long it takes until a map is on screen.
import { choosePlanner, closeHint, openFile, settled } from './driver.mjs'
import { randomMap, SIDE } from './maps.mjs'
import { withPage } from './served-page.mjs'

const ABOUT_A_SECOND = 1000
/** A planner that is soon done, so that what is measured is the page. */
const QUICK = 'bug2'
const KEPT = 'path-planner.setup'

/** @typedef {import('@playwright/test').Page} Page */

/** @param {import('./figures.mjs').Report} report */
export async function measureOpening(report) {
  report.section('Opening a map of 2048 × 2048 cells, until all of it is painted')
  await withPage(async (page, url) => {
    await page.addInitScript(notePainting)
    await page.goto(url)
    await closeHint(page)
    await choosePlanner(page, QUICK)
    await settled(page)

    const file = await timeFrom(page, 'change')
    await openFile(page, randomMap())
    report.figure('a file (text, random 20 %)', await file(), 'ms', ABOUT_A_SECOND)
    await settled(page)

    const generated = await timeFrom(page, 'submit')
    await generateMaze(page)
    report.figure('the generator (maze)', await generated(), 'ms', ABOUT_A_SECOND)
    await settled(page)

    await page.waitForFunction((key) => (localStorage[key]?.length ?? 0) > 1e5, KEPT)
    const kept = await page.evaluate((key) => localStorage[key], KEPT)
    await page.reload()
    report.figure('what was drawn before (reload)', await timeSinceLoad(page), 'ms', ABOUT_A_SECOND)

    await page.evaluate(() => localStorage.clear())
    await page.goto('about:blank')
    await page.goto(`${url}#setup=${encodeURIComponent(kept)}`)
    const whole = await timeSinceLoad(page)
    // With nothing but such an address, on any page, the browser is busy for most of this time.
    report.figure('a link, from its first byte', whole, 'ms')
    report.figure('a link, after the browser', whole - (await parsedAt(page)), 'ms', ABOUT_A_SECOND)
  })
}

/** @param {Page} page */
async function generateMaze(page) {
  await page.getByRole('button', { name: 'Map', exact: true }).click()
  await page.getByRole('menuitem', { name: 'Generate…' }).click()
  const dialog = page.getByRole('dialog', { name: 'Generate' })
  await dialog.getByRole('combobox').selectOption('maze')
  await dialog.getByLabel('Width').fill(String(SIDE))
  await dialog.getByLabel('Height').fill(String(SIDE))
  await dialog.getByRole('button', { name: 'Generate' }).click()
}

/**
 * Begins to wait for an event; what is returned waits until the page shows another map, all of it
 * painted, and says how many milliseconds after the event that was.
 * @param {Page} page
 * @param {string} type of the event
 */
async function timeFrom(page, type) {
  const measured = await page.evaluateHandle((eventType) => {
    const map = document.getElementById('map')
    const before = map?.getAttribute('aria-label')
    const time = new Promise((resolve) => {
      const begin = () => {
        const began = performance.now()
        const look = () => {
          const isThere = map?.getAttribute('aria-label') !== before
          if (!isThere || map?.dataset.painted === 'false') return requestAnimationFrame(look)
          // After what this frame draws.
          setTimeout(() => resolve(performance.now() - began))
        }
        requestAnimationFrame(look)
      }
      window.addEventListener(eventType, begin, { capture: true, once: true })
    })
    return { time }
  }, type)
  return async () => Number(await measured.evaluate(({ time }) => time))
}

/** Runs in each page that is loaded: keeps when a map of this size was all painted. */
function notePainting() {
  const look = () => {
    const { width, painted } = document.getElementById('map')?.dataset ?? {}
    if (width !== '2048' || painted === 'false') return requestAnimationFrame(look)
    setTimeout(() => performance.mark('painted'))
  }
  requestAnimationFrame(look)
}

/** Milliseconds from the beginning of the navigation. @param {Page} page */
async function timeSinceLoad(page) {
  await page.waitForFunction(() => performance.getEntriesByName('painted').length > 0)
  return page.evaluate(() => performance.getEntriesByName('painted')[0].startTime)
}

/** When the browser had read the address and the page, and ran the page's script. @param {Page} page */
async function parsedAt(page) {
  return page.evaluate(() => {
    const [navigation] = performance.getEntriesByType('navigation')
    return navigation instanceof PerformanceNavigationTiming
      ? navigation.domInteractive
      : Number.NaN
  })
}
