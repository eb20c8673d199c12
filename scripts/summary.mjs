// One line that says how many tests passed and failed, out of what the test runners reported.
import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'

/** @param {string} name */
function report(name) {
  const path = fileURLToPath(new URL(`../reports/${name}.json`, import.meta.url))
  return existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : undefined
}

const unit = report('unit')
const e2e = report('e2e')
// A test file that does not load has no tests that could fail, and a browser run can fail as a whole.
const unloaded = unit?.testResults.filter(
  (/** @type {{ status: string, assertionResults: unknown[] }} */ file) =>
    file.status === 'failed' && file.assertionResults.length === 0,
).length
const twice = e2e?.stats.flaky ?? 0
const passed = (unit?.numPassedTests ?? 0) + (e2e?.stats.expected ?? 0) + twice
const failed =
  (unit?.numFailedTests ?? 0) +
  (unloaded ?? 0) +
  (e2e?.stats.unexpected ?? 0) +
  (e2e?.errors.length ?? 0)
console.log(`${passed} passed, ${failed} failed`)
if (twice > 0) console.log(`${twice} of them passed only when tried again.`)
