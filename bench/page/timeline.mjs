// What the page's main thread did, frame by frame, from the browser's own trace.

/**
 * Times are the thread's own, in microseconds of processor time: what else the machine does meanwhile
 * does not count.
 * @typedef {{ name: string, ph: string, tts?: number, tdur?: number, pid: number, tid: number }} TraceEvent
 */

const CATEGORIES = [
  'devtools.timeline',
  'disabled-by-default-devtools.timeline',
  'disabled-by-default-devtools.timeline.frame',
]

/** What a page's own code runs in. */
const SCRIPT = new Set([
  'EvaluateScript',
  'EventDispatch',
  'FireAnimationFrame',
  'FireIdleCallback',
  'FunctionCall',
  'RunMicrotasks',
  'TimerFire',
])

const TASK = new Set(['RunTask'])

/** Script of less is that of a page at rest. */
const AT_WORK_MS = 0.3

/**
 * Milliseconds of processor time of each frame in which the main thread ran script, and in which it ran anything.
 * @typedef {{ script: number[], busy: number[] }} Frames
 */

/**
 * Watches the page while something is done.
 * @param {import('@playwright/test').Page} page
 * @param {() => Promise<void>} work
 * @returns {Promise<Frames>}
 */
export async function watchFrames(page, work) {
  const browser = page.context().browser()
  if (!browser) throw new Error('The page has no browser.')
  await browser.startTracing(page, { categories: CATEGORIES })
  await work()
  const trace = JSON.parse((await browser.stopTracing()).toString())
  return framesOf(trace.traceEvents)
}

/** @param {readonly TraceEvent[]} events @returns {Frames} */
function framesOf(events) {
  const own = events.filter(onMainThread(events))
  const begins = own
    .filter(({ name }) => name === 'BeginMainThreadFrame')
    .map(({ tts = 0 }) => tts)
    .toSorted((a, b) => a - b)
  const script = perFrame(begins, ofNames(own, SCRIPT))
  const busy = perFrame(begins, ofNames(own, TASK))
  // Frames in which nothing happened would flatter the median.
  const atWork = (/** @type {number} */ _, /** @type {number} */ i) => script[i] >= AT_WORK_MS
  return { script: script.filter(atWork), busy: busy.filter(atWork) }
}

/** @param {readonly TraceEvent[]} events @param {ReadonlySet<string>} names */
const ofNames = (events, names) => events.filter(({ name }) => names.has(name))

/** The main thread of the renderer with the most frames. @param {readonly TraceEvent[]} events */
function onMainThread(events) {
  const frames = new Map()
  for (const { name, pid, tid } of events) {
    if (name !== 'BeginMainThreadFrame') continue
    const thread = `${pid} ${tid}`
    frames.set(thread, (frames.get(thread) ?? 0) + 1)
  }
  const [main] = [...frames].toSorted(([, a], [, b]) => b - a)
  return (/** @type {TraceEvent} */ { pid, tid }) => `${pid} ${tid}` === main?.[0]
}

/**
 * How much of each frame is covered by the events, in milliseconds.
 * @param {readonly number[]} begins of frames, in microseconds, rising
 * @param {readonly TraceEvent[]} events
 */
function perFrame(begins, events) {
  const spans = events
    .filter(({ ph, tdur }) => ph === 'X' && tdur !== undefined)
    .map(({ tts = 0, tdur = 0 }) => ({ from: tts, to: tts + tdur }))
    .toSorted((a, b) => a.from - b.from)
  const covered = begins.map(() => 0)
  let frame = -1
  let end = Number.NEGATIVE_INFINITY
  for (const { from, to } of spans) {
    while (frame + 1 < begins.length && begins[frame + 1] <= from) frame++
    // A task begins before the frame that it makes.
    const owner = begins[frame + 1] < to ? frame + 1 : frame
    if (owner >= 0 && to > end) covered[owner] += (to - Math.max(from, end)) / 1000
    end = Math.max(end, to)
  }
  return covered
}
