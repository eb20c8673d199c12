// How long it takes until a page is on screen, on a processor that is slowed down.

/**
 * @typedef {object} Opening times in milliseconds, from the beginning of the navigation
 * @property {number} ready the solved map, or the form of the experiments, is on screen
 * @property {number} longest task of the main thread until then
 */

/** The name under which the page tells the bench that it is ready. */
const TELL = 'tellBench'

/**
 * Runs in the page before its own scripts. What is ready is told by itself: to ask for it would take
 * the page's own time.
 * @param {string} tell
 */
function watch(tell) {
  let longest = 0
  new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) longest = Math.max(longest, duration)
  }).observe({ type: 'longtask', buffered: true })

  const isReady = () => {
    const map = document.getElementById('map')
    if (map) return map.dataset.status === 'reached' && map.dataset.painted !== 'false'
    return document.documentElement.hasAttribute('theme')
  }
  const observer = new MutationObserver(() => {
    if (!isReady()) return
    observer.disconnect()
    // After the frame that shows it.
    requestAnimationFrame(() =>
      setTimeout(() => {
        const ready = performance.now()
        Reflect.get(window, tell)(JSON.stringify({ ready, longest }))
      }),
    )
  })
  observer.observe(document, { attributes: true, subtree: true })
}

/**
 * Opens a page as on a first visit.
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {number} slowdown of the main thread; Chromium slows down no other
 * @returns {Promise<Opening>}
 */
export async function opening(browser, url, slowdown) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    reducedMotion: 'reduce',
  })
  try {
    const page = await context.newPage()
    await page.addInitScript(watch, TELL)
    const client = await context.newCDPSession(page)
    await client.send('Runtime.enable')
    await client.send('Runtime.addBinding', { name: TELL })
    await client.send('Emulation.setCPUThrottlingRate', { rate: slowdown })
    /** @type {Promise<string>} */
    const told = new Promise((resolve) => {
      client.on('Runtime.bindingCalled', ({ payload }) => resolve(payload))
    })
    await page.goto(url, { waitUntil: 'commit' })
    return JSON.parse(await told)
  } finally {
    await context.close()
  }
}
