import { faultOf, type Param } from '../algorithms/params'
import { planners } from '../algorithms/planners'
import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import { fileText } from '../grid/file-text'
import { parseJson } from '../grid/formats/json'
import { generators } from '../grid/generators'
import { gridFromRows } from '../grid/text-map'
import {
  countWork,
  type ExperimentSettings,
  type Family,
  GIVEN_MAPS,
  type GivenMap,
  MAX_RUNS,
  type PlannerFamily,
  plannerSettings,
  settingName,
  type ValueLists,
} from './settings'
import { readSettingsShape } from './settings-shape'

/**
 * The settings in the text of a file.
 * @throws InputError that names the line and column of what is not JSON, or the field that is wrong.
 */
export function readSettings(text: string): ExperimentSettings {
  return checkSettings(parseJson(fileText(text)))
}

/**
 * The settings in a JSON value. All of it is checked before anything is run, also against what the
 * generators and planners declare.
 * @throws InputError that names the field that is wrong: "planners[2].params.samples[0]: …".
 */
export function checkSettings(value: unknown): ExperimentSettings {
  const settings = readSettingsShape(value)
  settings.families.forEach((family, i) => {
    checkFamily(family, `families[${i}]`, settings)
  })
  settings.planners.forEach((planner, i) => {
    checkPlanner(planner, `planners[${i}]`)
  })
  checkAmount(settings)
  checkDistance(settings)
  checkRepeats(settings)
  return settings
}

/** The settings as the text of a file; `readSettings` reads it. */
export function saveSettings(settings: ExperimentSettings): string {
  return `${JSON.stringify(settings, null, 2)}\n`
}

function fail(field: string, fault: string): never {
  throw new InputError(`${field}: ${fault}.`)
}

function checkFamily(family: Family, field: string, settings: ExperimentSettings): void {
  if (family.family === GIVEN_MAPS) {
    if (settings.families.find((one) => one.family === GIVEN_MAPS) !== family) {
      fail(field, `a second family "${GIVEN_MAPS}"; put all maps into one`)
    }
    if (!family.maps) fail(`${field}.maps`, 'is missing; this family needs the maps themselves')
    family.maps.forEach((map, i) => {
      checkGivenMap(map, `${field}.maps[${i}]`)
    })
    if (Object.keys(family.params).length > 0) {
      fail(`${field}.params`, 'given maps have no parameters')
    }
    return
  }
  const generator = generators.find(({ id }) => id === family.family)
  if (!generator) {
    const known = [...generators.map(({ id }) => id), GIVEN_MAPS].join(', ')
    fail(`${field}.family`, `there is no family ${describe(family.family)} (there are: ${known})`)
  }
  if (family.maps) fail(`${field}.maps`, `only the family "${GIVEN_MAPS}" has maps`)
  if (settings.sizes.length === 0) fail('sizes', 'must have at least one size for generated maps')
  checkLists(family.params, generator.params, `${field}.params`)
}

function checkGivenMap({ rows }: GivenMap, field: string): void {
  let walls: Uint8Array
  try {
    walls = gridFromRows(rows).walls
  } catch (error) {
    if (error instanceof InputError) throw new InputError(`${field}.rows: ${error.message}`)
    throw error
  }
  if (walls.indexOf(0) === walls.lastIndexOf(0)) {
    fail(`${field}.rows`, 'must have a free cell for the start and one for the goal')
  }
}

function checkPlanner({ planner: id, params }: PlannerFamily, field: string): void {
  const planner = planners.find((candidate) => candidate.id === id)
  if (!planner) {
    const known = planners.map((candidate) => candidate.id).join(', ')
    fail(`${field}.planner`, `there is no planner ${describe(id)} (there are: ${known})`)
  }
  checkLists(params, planner.params, `${field}.params`)
}

function checkLists(lists: ValueLists<unknown>, declared: readonly Param[], field: string): void {
  for (const [name, values] of Object.entries(lists)) {
    const param = declared.find((candidate) => candidate.name === name)
    if (!param) {
      const known = declared.map((candidate) => candidate.name).join(', ') || 'none'
      fail(`${field}.${name}`, `there is no such parameter (there are: ${known})`)
    }
    values.forEach((value, i) => {
      const fault = faultOf(param, value)
      if (fault) fail(`${field}.${name}[${i}]`, fault)
      if (values.indexOf(value) < i) fail(`${field}.${name}[${i}]`, `${value} is there twice`)
    })
  }
}

function checkAmount(settings: ExperimentSettings): void {
  const { maps, settings: each, runs } = countWork(settings)
  if (runs <= MAX_RUNS) return
  const [m, s, r, most] = [maps, each, runs, MAX_RUNS].map((n) => n.toLocaleString('en'))
  fail(
    'mapsPerCombination',
    `these settings ask for ${r} runs (${m} maps, ${s} planner settings on each); at most ${most} are allowed`,
  )
}

function checkDistance({ leastDistance, families, sizes }: ExperimentSettings): void {
  const given = families.flatMap(({ maps }) => maps ?? [])
  const givenSizes = given.map(({ rows }) => [rows[0].length, rows.length] as const)
  const isGenerated = families.some(({ family }) => family !== GIVEN_MAPS)
  for (const [width, height] of [...(isGenerated ? sizes : []), ...givenSizes]) {
    const most = Math.max(width, height) - 1
    if (leastDistance <= most) continue
    const size = `${width} × ${height}`
    fail(
      'leastDistance',
      `is ${leastDistance}, but on a ${size} map no two cells are more than ${most} apart`,
    )
  }
}

function checkRepeats(settings: ExperimentSettings): void {
  const seen = new Set<string>()
  for (const setting of plannerSettings(settings)) {
    const key = JSON.stringify([setting.planner, Object.entries(setting.params).sort()])
    if (seen.has(key)) fail('planners', `${settingName(setting)} is there twice`)
    seen.add(key)
  }
}
