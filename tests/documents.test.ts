import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { build } from 'vite'
import { expect, test } from 'vitest'
import type { OfflinePlanner } from '../src/algorithms/planner'
import { countWork, firstIllegalStep, frameAt, planners, readSettings, Tape } from '../src/index'
import { mapNumber } from './reference/maps'
import { isReachable, problemOf, RULES } from './reference/world'

const readme = readFileSync('README.md', 'utf8')
const contributing = readFileSync('CONTRIBUTING.md', 'utf8')

/** The first block of code in a language. */
function block(document: string, language: string): string {
  const found = document.match(new RegExp(`\`\`\`${language}\n(.*?)\`\`\``, 's'))
  if (!found) throw new Error(`There is no ${language} block.`)
  return found[1]
}

test('the program in README.md runs in Node and prints what is said', async () => {
  // Elsewhere, with the built library among its packages.
  const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
  try {
    const library = join(folder, 'node_modules', 'path-planner')
    const outDir = join(library, 'dist-lib')
    await build({ configFile: 'vite.lib.config.ts', logLevel: 'error', build: { outDir } })
    cpSync('package.json', join(library, 'package.json'))
    const program = join(folder, 'example.mjs')
    writeFileSync(program, block(readme, 'js'))
    const printed = execFileSync(process.execPath, [program], { encoding: 'utf8' })
    expect(printed).toBe(block(readme, 'text'))
  } finally {
    rmSync(folder, { recursive: true })
  }
})

test('README.md names the versions of Node that the tools run with', () => {
  const nodeFor = (folder: string): string =>
    JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).engines.node
  const ours = nodeFor('.')
  // The builder takes no 22 before 22.12, the tests run with no odd version.
  expect(nodeFor('node_modules/vite')).toBe('^20.19.0 || >=22.12.0')
  expect(nodeFor('node_modules/vitest')).toBe('^20.0.0 || ^22.0.0 || >=24.0.0')
  expect(ours).toBe('^20.19 || ^22.12 || >=24')
  expect(readme).toContain(`${ours.match(/[\d.]+/g)?.join(', ')} or newer`)
})

test('the settings in README.md can be run, and the fault in it is the one that is told', () => {
  const settings = readSettings(block(readme, 'json'))
  // Three densities and a maze in two sizes, and a map; each 100 times.
  expect(countWork(settings)).toEqual({ maps: 900, settings: 6, runs: 5400 })
  const broken = block(readme, 'json').replace('[20, 80, 320]', '[-1]')
  const [, told] = readme.match(/`(planners\[1\][^`]*)`/) ?? []
  expect(() => readSettings(broken)).toThrow(told)
})

test.each(planners)('$id and its parameters are listed in README.md', ({ id, title, params }) => {
  const row = readme.split('\n').find((line) => line.includes(`| \`${id}\` |`)) ?? ''
  expect(row).toContain(title)
  for (const { name } of params) expect(row).toContain(`\`${name}\``)
})

test('the planner in CONTRIBUTING.md is what it says: complete', async () => {
  const source = block(contributing, 'ts')
    .replaceAll("from '../", "from '../src/")
    .replaceAll("from './", "from '../src/algorithms/")
  mkdirSync('reports', { recursive: true })
  const file = resolve('reports', 'example-planner.ts')
  writeFileSync(file, source)
  const { greedyBestFirst }: { greedyBestFirst: OfflinePlanner } = await import(file)
  for (let i = 0; i < 200; i++) {
    const world = mapNumber(1, i, RULES[i % 2])
    const problem = problemOf(world)
    const context = { params: {}, random: () => 0, tape: new Tape(), progress() {} }
    context.tape.begin(world.width, world.height)
    const { status, path } = greedyBestFirst.plan(problem, context)
    expect(status).toBe(isReachable(world) ? 'reached' : 'unreachable')
    expect(firstIllegalStep(problem, path)).toBe(-1)
    if (status === 'reached') {
      expect([path[0], path.at(-1)]).toEqual([problem.start, problem.goal])
      // The page tells the cost that the tape has.
      expect(frameAt(context.tape, context.tape.length).cost).toBe(path.length - 1)
    }
  }
})
