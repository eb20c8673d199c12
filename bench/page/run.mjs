// Measures the built page with the largest map in a real browser.
// Names on the command line run a part: opening, moving, strokes, stepping, memory.
import { spawnSync } from 'node:child_process'
import { Report } from './figures.mjs'
import { measureMemory } from './memory.mjs'
import { measureMoving } from './moving.mjs'
import { measureOpening } from './opening.mjs'
import { measureStepping } from './stepping.mjs'
import { measureStrokes } from './strokes.mjs'

const parts = {
  opening: measureOpening,
  moving: measureMoving,
  strokes: measureStrokes,
  stepping: measureStepping,
  memory: measureMemory,
}

/** The targets are for two processor cores. Where they cannot be had so, all are used. */
function onTwoCores() {
  if (process.platform !== 'linux' || process.env.BENCH_CORES === 'all') return false
  const { status, error } = spawnSync('taskset', ['-c', '0,1', 'true'])
  if (error || status !== 0) return false
  const cores = process.env.BENCH_CORES ?? '0,1'
  const { status: code } = spawnSync(
    'taskset',
    ['-c', cores, process.execPath, ...process.argv.slice(1)],
    {
      stdio: 'inherit',
      env: { ...process.env, BENCH_CORES: 'all' },
    },
  )
  process.exitCode = code ?? 1
  return true
}

const asked = process.argv.slice(2)
const unknown = asked.find((name) => !Object.hasOwn(parts, name))
if (unknown !== undefined) {
  console.error(`There is no part "${unknown}" (there are: ${Object.keys(parts).join(', ')}).`)
  process.exitCode = 1
} else if (!onTwoCores()) {
  const report = new Report()
  for (const [name, measure] of Object.entries(parts)) {
    if (asked.length === 0 || asked.includes(name)) await measure(report)
  }
  console.log(
    report.missed === 0 ? '\nAll targets are met.' : `\n${report.missed} targets are missed.`,
  )
  process.exitCode = report.missed === 0 ? 0 : 1
}
