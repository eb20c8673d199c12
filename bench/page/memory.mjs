// Memory of the page, with a tape of every cell and without one.
import { readFile } from 'node:fs/promises'
import { choosePlanner, closeHint, settled, solve } from './driver.mjs'
import { randomMap, SIDE, walledGoalMap } from './maps.mjs'
import { withPage } from './served-page.mjs'

const MB = 2 ** 20

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./figures.mjs').Report} Report */

/** @param {Report} report */
export async function measureMemory(report) {
  report.section('Memory with a map of 2048 × 2048 cells')
  const cases = [
    { name: 'no tape worth the name (random 20 %)', map: randomMap(), planner: 'bug2', most: 150 },
    { name: 'Dijkstra (random 20 %)', map: randomMap(), planner: 'decomposition', most: 400 },
    { name: 'Dijkstra, every cell', map: walledGoalMap(), planner: 'decomposition', most: 400 },
  ]
  for (const { name, map, planner, most } of cases) {
    await withPage(async (page, url) => {
      await page.goto(url)
      await closeHint(page)
      await choosePlanner(page, planner)
      await solve(page, map, SIDE)
      await settled(page)
      report.figure(`${name}: what the page holds`, await held(page), 'MB', most)
      report.figure(`${name}: private memory of its process`, await ofProcess(page), 'MB')
      await page.keyboard.press('ArrowLeft')
      await page.keyboard.press('ArrowLeft')
      report.figure(`${name}, stepped back: what the page holds`, await held(page), 'MB', most)
    })
  }
}

/** Script, typed arrays, canvases' images and the DOM, of the page and its workers. @param {Page} page */
async function held(page) {
  const bytes = await page.evaluate(async () => {
    if (!('measureUserAgentSpecificMemory' in performance)) return Number.NaN
    const measure = Object(performance).measureUserAgentSpecificMemory
    return (await measure.call(performance)).bytes
  })
  return bytes / MB
}

/**
 * Of the largest renderer, from /proc: the browser's own code and caches are in it as well.
 * @param {Page} page
 */
async function ofProcess(page) {
  const client = await page.context().browser()?.newBrowserCDPSession()
  const { processInfo = [] } = (await client?.send('SystemInfo.getProcessInfo')) ?? {}
  const sizes = await Promise.all(
    processInfo
      .filter(({ type }) => type === 'renderer')
      .map(({ id }) => readFile(`/proc/${id}/smaps_rollup`, 'utf8').catch(() => '')),
  )
  const privateKb = (/** @type {string} */ text) =>
    [...text.matchAll(/^Private_\w+:\s+(\d+) kB/gm)].reduce((sum, [, kb]) => sum + Number(kb), 0)
  return Math.max(...sizes.map(privateKb)) / 1024
}
