// Measures the first load of the built pages in Chromium: bytes, and the time until there is
// something to work with on a processor that is four times slower.
import { chromium } from '@playwright/test'
import { preview } from 'vite'
import { findBrowser } from '../../scripts/browser.mjs'
import { fetchedBy } from './fetched.mjs'
import { opening } from './opening.mjs'
import { workerTime } from './worker-time.mjs'

const SLOWDOWN = 4
const RUNS = 15
const MOST_BYTES = 150_000
const MOST_MS = 1000

let missed = 0

/** @param {string} name @param {string} value @param {string} [target] @param {boolean} [isMet] */
function line(name, value, target = '', isMet = true) {
  if (!isMet) missed++
  console.log(`  ${name.padEnd(58)}${value.padStart(12)}  ${target}${isMet ? '' : '  MISSED'}`)
}

const kilobytes = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1)} kB`
const milliseconds = (/** @type {number} */ time) => `${time.toFixed(0)} ms`

/** @param {readonly number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1]

/** @param {import('@playwright/test').Browser} browser @param {string} url */
async function showBytes(browser, url) {
  const page = await browser.newPage()
  const fetched = fetchedBy(page)
  await page.goto(url)
  await page.waitForLoadState('networkidle')
  const files = await fetched()
  await page.close()
  for (const { path, gzip } of files) line(path, kilobytes(gzip))
  const [raw, gzip, brotli] = /** @type {const} */ (['raw', 'gzip', 'brotli']).map((size) =>
    files.reduce((sum, file) => sum + file[size], 0),
  )
  line('together as they are', kilobytes(raw))
  line('with brotli', kilobytes(brotli))
  line('with gzip', kilobytes(gzip), `at most ${kilobytes(MOST_BYTES)}`, gzip <= MOST_BYTES)
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {string} url
 * @param {string} what is on screen in the end
 * @param {number} worker what its worker computes before
 */
async function showTimes(browser, url, what, worker) {
  /** @type {import("./opening.mjs").Opening[]} */
  const runs = []
  for (let run = 0; run < RUNS; run++) runs.push(await opening(browser, url, SLOWDOWN))
  const times = (/** @type {'firstPaint' | 'longest' | 'ready'} */ of) => runs.map((run) => run[of])
  line('first paint, median', milliseconds(median(times('firstPaint'))))
  line('longest task, median', milliseconds(median(times('longest'))))
  const ready = times('ready')
  const [least, most] = [Math.min(...ready), Math.max(...ready)].map(milliseconds)
  line(`${what}, ${RUNS} runs`, `${least} to ${most}`)
  const slow = median(ready) + (SLOWDOWN - 1) * worker
  if (worker > 0) line('the worker, which Chromium does not slow down', milliseconds(worker))
  line(
    `${what}, median${worker > 0 ? ', with a worker as slow' : ''}`,
    milliseconds(slow),
    `at most ${milliseconds(MOST_MS)}`,
    slow <= MOST_MS,
  )
}

const executablePath = findBrowser()
const server = await preview({
  logLevel: 'silent',
  preview: { host: '127.0.0.1', port: 0 },
})
const address = server.httpServer.address()
if (address === null || typeof address === 'string') throw new Error('The server has no port.')
const home = `http://127.0.0.1:${address.port}/`
const browser = await chromium.launch({
  ...(executablePath && { executablePath }),
  args: ['--no-sandbox', '--disable-gpu'],
})
try {
  console.log('The playground, compressed with gzip')
  await showBytes(browser, home)
  console.log(`The playground, on a processor ${SLOWDOWN} times slower`)
  await showTimes(browser, home, 'the solved map on screen', await workerTime(browser, home))
  console.log('The page of experiments, compressed with gzip')
  await showBytes(browser, `${home}experiments.html`)
  console.log(`The page of experiments, on a processor ${SLOWDOWN} times slower`)
  await showTimes(browser, `${home}experiments.html`, 'the form on screen', 0)
  console.log(missed === 0 ? 'All targets are met.' : `Targets missed: ${missed}.`)
} finally {
  await browser.close()
  await server.close()
}
process.exit(missed === 0 ? 0 : 1)
