// Panning and zooming: what each frame costs.
import { choosePlanner, closeHint, frames, MIDDLE, settled, solve, zoomTo } from './driver.mjs'
import { randomMap, SIDE, walledGoalMap } from './maps.mjs'
import { withPage } from './served-page.mjs'
import { watchFrames } from './timeline.mjs'

const SCRIPT_MS = 8
const SHORT_SCALE = 12

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./figures.mjs').Report} Report */

/** @param {Report} report */
export async function measureMoving(report) {
  await withPage(async (page, url) => {
    await page.goto(url)
    await closeHint(page)
    await choosePlanner(page, 'decomposition')
    for (const [name, map] of [
      ['random 20 %', randomMap()],
      ['open, every cell closed', walledGoalMap()],
    ]) {
      await solve(page, map, SIDE)
      report.section(`Moving the map (${name}), with its plan`)
      await measure(report, page, 'pan, whole map on screen', pan)
      await measure(report, page, 'zoom in and out', zoom)
      await zoomTo(page, SHORT_SCALE)
      await measure(report, page, 'pan, cells of 12 pixels', pan)
      await page.keyboard.press('0')
      await settled(page)
    }
  })
}

/**
 * @param {Report} report
 * @param {Page} page
 * @param {string} name
 * @param {(page: Page) => Promise<void>} move
 */
async function measure(report, page, name, move) {
  const { script, busy } = await watchFrames(page, () => move(page))
  report.figures(`${name}: script a frame`, script, 'ms', { p95: SCRIPT_MS })
  report.figures(`${name}: main thread busy a frame`, busy, 'ms')
}

/** @param {Page} page */
async function pan(page) {
  const { mouse } = page
  await mouse.move(MIDDLE.x, MIDDLE.y)
  await mouse.down({ button: 'middle' })
  for (let i = 0; i < 60; i++) {
    const turn = (i / 60) * 2 * Math.PI
    await mouse.move(MIDDLE.x + 150 * Math.sin(turn), MIDDLE.y + 90 * Math.sin(2 * turn))
    await frames(page, 1)
  }
  await mouse.up({ button: 'middle' })
}

/** @param {Page} page */
async function zoom(page) {
  await page.mouse.move(MIDDLE.x, MIDDLE.y)
  for (let i = 0; i < 60; i++) {
    await page.mouse.wheel(0, i < 30 ? -80 : 80)
    await frames(page, 1)
  }
}
