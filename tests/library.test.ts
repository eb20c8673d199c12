import { execFileSync, spawnSync } from 'node:child_process'
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { afterAll, beforeAll, expect, test } from 'vitest'

// A program elsewhere, with the library among its packages.
const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
const library = join(folder, 'node_modules', 'path-planner')
const tsc = resolve('node_modules/typescript/bin/tsc')

beforeAll(() => {
  const types = join(library, 'dist-lib', 'types')
  execFileSync(process.execPath, [tsc, '-p', 'tsconfig.lib.json', '--outDir', types])
  execFileSync(process.execPath, ['scripts/declarations.mjs', types])
  for (const name of ['package.json', '.gitignore']) cpSync(name, join(library, name))
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }')
})
afterAll(() => rmSync(folder, { recursive: true }))

const PROGRAM = `
import { frameAt, plan, planners, problemFromText, readSettings, runMap, Tape } from 'path-planner'
import type { Outcome, PlanOptions, Row } from 'path-planner'

const options: PlanOptions = { params: { cost: 'euclidean' }, seed: 3, tape: new Tape() }
const outcome: Outcome = plan(problemFromText('S.\\n.G'), planners[0].id, options)
export const rover: number = frameAt(new Tape(), 0).rover
export const rows: readonly Row[] = runMap(readSettings(''), 0)
// @ts-expect-error: it is a word. Where the types are not found, everything is anything.
export const status: number = outcome.status
// @ts-expect-error: there is no such option.
plan(problemFromText('S.\\n.G'), 'bug1', { param: {} })
`

/** Its own declarations have to name the types of what the library gives it. */
const HANDED_ON = `
import { bug1Bound, frameAt, openResults, plannerById, plannerSettings, readSettings, Tape, testMap } from 'path-planner'
import type { AnyPlanner, Param } from 'path-planner'

const settings = readSettings('')
export const { families, planners } = settings
export const maps = families[0].maps
export const [chosen] = plannerSettings(settings)
export const { kind } = testMap(settings, 0)
export const { size } = kind
export const { shard, ...origin } = openResults('')
export const { field, test, refusal, estimate, hits } = frameAt(new Tape(), 0)
export const { thinning } = new Tape()
export const turn = (...[, turn]: Parameters<typeof bug1Bound>) => turn

const paramOf = <Kind extends string>(kind: Kind) =>
  plannerById('bug1').params.find((param): param is Extract<Param, { kind: Kind }> => param.kind === kind)
export const params = [paramOf('integer'), paramOf('number'), paramOf('choice'), paramOf('boolean')]

const of = <Family extends string>(family: Family) =>
  plannerById('bug1') as Extract<AnyPlanner, { family: Family }>
export const offline = of('offline')
export const online = of('online')
export const { plan } = offline
export const { drive, sensor } = online
type Drive = Parameters<typeof drive>
export const driven = (...[rover, { notes }]: Drive) => [rover, notes, rover.known(0, 0), rover.legalSteps()]
`

test.each([
  ['nodenext', 'nodenext'],
  ['esnext', 'bundler'],
])('its types are found by a strict program (modules %s, resolution %s)', (module, resolution) => {
  writeFileSync(join(folder, 'program.ts'), PROGRAM)
  writeFileSync(join(folder, 'handed-on.ts'), HANDED_ON)
  const options = { strict: true, declaration: true, target: 'es2022', types: [], module }
  const compilerOptions = { ...options, moduleResolution: resolution, outDir: 'made' }
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions }))
  const { stdout, status } = spawnSync(process.execPath, [tsc, '-p', folder], { encoding: 'utf8' })
  expect(stdout).toBe('')
  expect(status).toBe(0)
})

test('it is in the package, though git knows nothing of it', () => {
  const packed = execFileSync('npm pack --dry-run --json', {
    cwd: library,
    encoding: 'utf8',
    shell: true,
  })
  const [{ files }]: [{ files: { path: string }[] }] = JSON.parse(packed)
  expect(files.map(({ path }) => path)).toContain('dist-lib/types/index.d.ts')
})
