// Drawing: after how many frames a stroke is on screen, and what its frames cost.
import { choosePlanner, closeHint, frames, MIDDLE, settled, solve, zoomTo } from './driver.mjs'
import { randomMap, SIDE, walledGoalMap } from './maps.mjs'
import { withPage } from './served-page.mjs'
import { watchFrames } from './timeline.mjs'

const SCALE = 12
const MOVES = 60
const FRAME_MS = 1000 / 60
/** By the clock, on which the planner's worker and whatever else there is have their share. */
const ABOUT_A_FRAME_MS = 50

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./figures.mjs').Report} Report */

/** @param {Report} report */
export async function measureStrokes(report) {
  for (const [name, map] of [
    ['random 20 %', randomMap()],
    ['open, every cell closed', walledGoalMap()],
  ]) {
    await withPage(async (page, url) => {
      await page.goto(url)
      await closeHint(page)
      report.section(`Drawing a stroke (${name})`)
      await choosePlanner(page, 'bug2')
      await solve(page, map, SIDE)
      await zoomTo(page, SCALE)
      await measure(report, page, 'planner soon done', 0)
      await page.keyboard.press('0')
      await choosePlanner(page, 'decomposition')
      await settled(page)
      await zoomTo(page, SCALE)
      await measure(report, page, 'over a plan, planner busy', 5)
      await settled(page)
      await page.keyboard.press('0')
      await measure(report, page, 'whole map on screen, planner busy', -8)
    })
  }
}

/**
 * @param {Report} report
 * @param {Page} page
 * @param {string} name
 * @param {number} row where to draw, in cells of the middle of the screen
 */
async function measure(report, page, name, row) {
  const y = MIDDLE.y + row * SCALE
  /** @type {{ frames: number, time: number }[]} */
  let answers = []
  const watched = await watchFrames(page, async () => {
    await page.mouse.move(MIDDLE.x - 200, y)
    await page.mouse.down()
    const measured = await page.evaluateHandle(watchMoves)
    for (let i = 1; i <= MOVES; i++) {
      await page.mouse.move(MIDDLE.x - 200 + i * 6, y + 20 * Math.sin(i / 5))
      await frames(page, 1)
    }
    await page.mouse.up()
    await frames(page, 5)
    answers = await measured.evaluate((list) => list)
  })
  report.figures(
    `${name}: frames until it is seen`,
    answers.map(({ frames }) => frames),
    'frames',
    { worst: 1 },
  )
  report.figures(
    `${name}: from the move until it is drawn`,
    answers.map(({ time }) => time),
    'ms',
    { median: ABOUT_A_FRAME_MS },
  )
  report.figures(`${name}: script a frame`, watched.script, 'ms', { p95: FRAME_MS })
}

/**
 * Runs in the page. For each move of the pointer: how many animation frames and milliseconds later
 * the pixel under it was another than before the stroke. Moves over what looks the same do not count.
 */
function watchMoves() {
  const ground = document.querySelector('canvas[data-layer=ground]')
  if (!(ground instanceof HTMLCanvasElement)) throw new Error('There is no ground.')
  const context = ground.getContext('2d')
  if (!context) throw new Error('There is no context.')
  const pixelAt = (/** @type {number} */ x, /** @type {number} */ y) =>
    new Uint32Array(context.getImageData(x, y, 1, 1).data.buffer)[0]
  const before = new Uint32Array(
    context.getImageData(0, 0, ground.width, ground.height).data.buffer.slice(0),
  )
  /** @type {{ frames: number, time: number }[]} */
  const answers = []
  window.addEventListener(
    'pointermove',
    ({ clientX, clientY, timeStamp }) => {
      const [x, y] = [Math.floor(clientX), Math.floor(clientY)]
      let frames = 0
      const look = () => {
        frames++
        // After what this frame draws.
        setTimeout(() => {
          const isSeen = pixelAt(x, y) !== before[y * ground.width + x]
          if (isSeen) answers.push({ frames, time: performance.now() - timeStamp })
          else if (frames < 20) requestAnimationFrame(look)
        })
      }
      requestAnimationFrame(look)
    },
    { capture: true },
  )
  return answers
}
