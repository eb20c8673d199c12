// How much a page's worker computes for its first answer. Chromium cannot slow down a worker.

/** @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, tdur?: number, dur?: number, args: { name?: string } }} TraceEvent */

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @returns {Promise<number>} milliseconds of processor time, at full speed
 */
export async function workerTime(browser, url) {
  const page = await browser.newPage({ reducedMotion: 'reduce' })
  try {
    await browser.startTracing(page, { categories: ['devtools.timeline', 'v8', 'v8.execute'] })
    await page.goto(url)
    await page.locator('#map[data-status=reached]').waitFor()
    const trace = await browser.stopTracing()
    /** @type {{ traceEvents: TraceEvent[] }} */
    const { traceEvents } = JSON.parse(trace.toString())
    return threadTime(traceEvents)
  } finally {
    await page.close()
  }
}

/** Of the outermost events of the worker's thread. @param {readonly TraceEvent[]} events */
function threadTime(events) {
  const worker = events.find(
    ({ name, args }) => name === 'thread_name' && args.name?.startsWith('DedicatedWorker'),
  )
  if (!worker) throw new Error('The trace shows no worker.')
  let end = 0
  let time = 0
  const own = events
    .filter(({ ph, pid, tid }) => ph === 'X' && pid === worker.pid && tid === worker.tid)
    .toSorted((a, b) => a.ts - b.ts)
  for (const { ts, dur = 0, tdur = 0 } of own) {
    if (ts < end) continue
    end = ts + dur
    time += tdur / 1000
  }
  return time
}
