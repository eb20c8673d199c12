// Stepping, jumping and playing on a tape of millions of events.
import { choosePlanner, closeHint, frames, settled, solve } from './driver.mjs'
import { SIDE, walledGoalMap } from './maps.mjs'
import { withPage } from './served-page.mjs'
import { watchFrames } from './timeline.mjs'

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./figures.mjs').Report} Report */

const FRAME_OR_SO_MS = 50

/** @param {Report} report */
export async function measureStepping(report) {
  report.section('Stepping on the longest tape (open, every cell closed)')
  await withPage(async (page, url) => {
    await page.goto(url)
    await closeHint(page)
    await choosePlanner(page, 'decomposition')
    await solve(page, walledGoalMap(), SIDE)
    await page.locator('#scrubber').focus()

    await answers(report, page, 'back from the end', ['ArrowLeft'])
    await answers(report, page, 'back', times('ArrowLeft', 20))
    await answers(report, page, 'forwards', times('ArrowRight', 10))
    for (const share of [0.5, 0.1, 0.9, 0.3]) {
      const step = await page.evaluate(
        (part) =>
          Math.round(part * Number(document.querySelector('input#scrubber')?.getAttribute('max'))),
        share,
      )
      await jump(report, page, share, step)
    }
    await answers(report, page, 'to the end', ['End'])
    await answers(report, page, 'to the beginning', ['Home'])
    await play(report, page)
  })
}

/** @param {string} key @param {number} count */
const times = (key, count) => Array.from({ length: count }, () => key)

/** @param {Report} report @param {Page} page @param {string} name @param {readonly string[]} keys */
async function answers(report, page, name, keys) {
  const { busy } = await watchFrames(page, async () => {
    for (const key of keys) {
      await page.keyboard.press(key)
      await frames(page, 2)
    }
    await frames(page, 20)
  })
  report.figure(`${name}: longest frame`, Math.max(...busy), 'ms', FRAME_OR_SO_MS)
}

/** @param {Report} report @param {Page} page @param {number} share @param {number} step */
async function jump(report, page, share, step) {
  const { busy } = await watchFrames(page, async () => {
    await page.locator('#scrubber').fill(String(step))
    await frames(page, 20)
  })
  const name = `jump to ${100 * share} %: longest frame`
  report.figure(name, Math.max(...busy), 'ms', FRAME_OR_SO_MS)
}

/** @param {Report} report @param {Page} page */
async function play(report, page) {
  await page.locator('#speed').selectOption('moment')
  const { script, busy } = await watchFrames(page, async () => {
    await page.keyboard.press('k')
    await frames(page, 40)
  })
  await settled(page)
  report.figures('playing all in a moment: script a frame', script, 'ms', { p95: 1000 / 60 })
  report.figures('playing all in a moment: main thread busy a frame', busy, 'ms')
}
