// What a person does with the page, and waiting for what comes of it.

/** @typedef {import('@playwright/test').Page} Page */

/** Waits until the map of this width is painted to its last cell. @param {Page} page @param {number} width */
async function painted(page, width) {
  await page.waitForFunction(
    (wanted) => {
      const { width, painted } = document.getElementById('map')?.dataset ?? {}
      return width === String(wanted) && painted !== 'false'
    },
    width,
    { polling: 'raf' },
  )
}

/** Waits until the plan of the setup on screen is there. @param {Page} page */
export async function settled(page) {
  await page.waitForFunction(
    () => {
      const { status = 'planning', painted } = document.getElementById('map')?.dataset ?? {}
      return status !== 'planning' && painted !== 'false'
    },
    undefined,
    { polling: 'raf' },
  )
  await frames(page, 3)
}

/** Lets so many animation frames pass. @param {Page} page @param {number} count */
export async function frames(page, count) {
  await page.evaluate(async (frames) => {
    for (let i = 0; i < frames; i++) await new Promise(requestAnimationFrame)
  }, count)
}

/** @param {Page} page @param {string} id */
export async function choosePlanner(page, id) {
  await page.getByRole('combobox', { name: 'Planner', exact: true }).selectOption(id)
}

/** @param {Page} page @param {string} text */
export async function openFile(page, text) {
  await page
    .locator('#file')
    .setInputFiles({ name: 'map.txt', mimeType: 'text/plain', buffer: Buffer.from(text) })
}

/** Opens a map and waits for its plan. @param {Page} page @param {string} text @param {number} width */
export async function solve(page, text, width) {
  await openFile(page, text)
  await painted(page, width)
  await settled(page)
  // A moment later the map is kept for the next visit.
  await frames(page, 60)
}

/** Hides what the greeting of newcomers covers. @param {Page} page */
export async function closeHint(page) {
  await page.locator('#hint-close').click()
}

/** The middle of the part of the map that no card covers. */
export const MIDDLE = { x: 640, y: 380 }

/** Zooms with the wheel until cells have this size. @param {Page} page @param {number} scale */
export async function zoomTo(page, scale) {
  const now = await page.evaluate(() => Number(document.getElementById('map')?.dataset.scale))
  await page.mouse.move(MIDDLE.x, MIDDLE.y)
  await page.mouse.wheel(0, -Math.log(scale / now) / 0.0015)
  await frames(page, 3)
}
