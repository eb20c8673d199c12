// Measures the first load of the built pages in Chromium: bytes, and the time until there is
// something to work with on a processor that is four times slower.
import { chromium } from '@playwright/test'
import { preview } from 'vite'
import { findBrowser } from '../../scripts/browser.mjs'
import { Report, spread } from '../page/figures.mjs'
import { fetchedBy } from './fetched.mjs'
import { opening } from './opening.mjs'
import { workerTime } from './worker-time.mjs'

/** @typedef {import('@playwright/test').Browser} Browser */

const SLOWDOWN = 4
const RUNS = 15
const MOST_KILOBYTES = 150
const MOST_MS = 1000

/** @param {Report} report @param {Browser} browser @param {string} url */
async function measureBytes(report, browser, url) {
  const page = await browser.newPage()
  const fetched = fetchedBy(page)
  await page.goto(url)
  await page.waitForLoadState('networkidle')
  const files = await fetched()
  await page.close()
  for (const { path, gzip } of files) report.figure(path, gzip / 1000, 'kB')
  const [raw, brotli, gzip] = /** @type {const} */ (['raw', 'brotli', 'gzip']).map(
    (size) => files.reduce((sum, file) => sum + file[size], 0) / 1000,
  )
  report.figure('all as they are', raw, 'kB')
  report.figure('all with brotli', brotli, 'kB')
  report.figure('all with gzip', gzip, 'kB', MOST_KILOBYTES)
}

/**
 * @param {Report} report
 * @param {Browser} browser
 * @param {string} url
 * @param {string} what is on screen in the end
 * @param {number} worker what its worker computes before, at full speed
 */
async function measureTimes(report, browser, url, what, worker) {
  /** @type {import('./opening.mjs').Opening[]} */
  const runs = []
  for (let run = 0; run < RUNS; run++) runs.push(await opening(browser, url, SLOWDOWN))
  const median = (/** @type {keyof import('./opening.mjs').Opening} */ time) =>
    spread(runs.map((run) => run[time])).median
  report.figure('longest task before, median', median('longest'), 'ms')
  const { worst } = spread(runs.map(({ ready }) => ready))
  report.figure(`${what}, worst of ${RUNS}`, worst, 'ms')
  if (worker === 0) {
    report.figure(`${what}, median`, median('ready'), 'ms', MOST_MS)
    return
  }
  report.figure(`${what}, median`, median('ready'), 'ms')
  report.figure('the worker, which Chromium does not slow down', worker, 'ms')
  const all = median('ready') + (SLOWDOWN - 1) * worker
  report.figure(`${what}, were the worker as slow`, all, 'ms', MOST_MS)
}

const executablePath = findBrowser()
const server = await preview({ logLevel: 'silent', preview: { host: '127.0.0.1', port: 0 } })
const address = server.httpServer.address()
if (address === null || typeof address === 'string') throw new Error('The server has no port.')
const playground = `http://127.0.0.1:${address.port}/`
const experiments = `${playground}experiments.html`
const browser = await chromium.launch({
  ...(executablePath && { executablePath }),
  args: ['--no-sandbox', '--disable-gpu'],
})
const report = new Report()
try {
  report.section('The playground, compressed with gzip')
  await measureBytes(report, browser, playground)
  report.section(`The playground, on a processor ${SLOWDOWN} times slower`)
  const worker = await workerTime(browser, playground)
  await measureTimes(report, browser, playground, 'the solved map is on screen', worker)
  report.section('The page of experiments, compressed with gzip')
  await measureBytes(report, browser, experiments)
  report.section(`The page of experiments, on a processor ${SLOWDOWN} times slower`)
  await measureTimes(report, browser, experiments, 'the form is on screen', 0)
} finally {
  await browser.close()
  await server.close()
}
const { missed } = report
console.log(missed === 0 ? '\nAll targets are met.' : `\nTargets missed: ${missed}.`)
process.exit(missed === 0 ? 0 : 1)
