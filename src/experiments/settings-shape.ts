import * as v from 'valibot'
import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import { MAX_SIDE, MIN_SIDE } from '../grid/grid'
import { SIDE_IN_WORDS } from '../grid/problem'
import { MAX_SEED } from '../grid/random'
import { DIAGONAL_RULES } from '../grid/steps'
import { type ExperimentSettings, MAX_RUNS, SETTINGS_FORMAT, SETTINGS_VERSION } from './settings'

/** What each field must be, by its name: for values that are wrong and for fields that are missing. */
const WHAT = {
  format: `"${SETTINGS_FORMAT}"`,
  version: `${SETTINGS_VERSION}, the version that this program reads`,
  seed: `a whole number from 0 to ${MAX_SEED}`,
  diagonal: DIAGONAL_RULES.map((rule) => `"${rule}"`).join(' or '),
  families: 'a list of at least one family of maps',
  family: 'the name of a family of maps, in quotes',
  params: 'an object with a list of values for each parameter',
  maps: 'a list of at least one map, each with a name and rows',
  name: 'a name in quotes',
  rows: 'a list of texts, one a row of the map',
  sizes: 'a list of sizes, each as [width, height]',
  mapsPerCombination: `a whole number from 1 to ${MAX_RUNS}`,
  leastDistance: `a whole number from 1 to ${MAX_SIDE - 1}`,
  planners: 'a list of at least one planner',
  planner: 'the name of a planner, in quotes',
} as const

const whole = (least: number, most: number, what: string) =>
  v.pipe(v.number(what), v.integer(what), v.minValue(least, what), v.maxValue(most, what))

const atLeastOne = <T>(item: v.GenericSchema<unknown, T>, what: string) =>
  v.pipe(v.array(item, what), v.minLength(1, what))

const valueLists = <T>(value: v.GenericSchema<unknown, T>) =>
  v.optional(
    v.record(v.string(), atLeastOne(value, 'a list of at least one value'), WHAT.params),
    {},
  )

const side = whole(MIN_SIDE, MAX_SIDE, SIDE_IN_WORDS)
const givenMap = v.strictObject(
  { name: v.string(WHAT.name), rows: v.array(v.string('a text'), WHAT.rows) },
  'an object with a name and rows',
)

const shape = v.strictObject(
  {
    format: v.literal(SETTINGS_FORMAT, WHAT.format),
    version: v.literal(SETTINGS_VERSION, WHAT.version),
    seed: whole(0, MAX_SEED, WHAT.seed),
    diagonal: v.picklist(DIAGONAL_RULES, WHAT.diagonal),
    families: atLeastOne(
      v.strictObject(
        {
          family: v.string(WHAT.family),
          params: valueLists(v.number('a number')),
          maps: v.exactOptional(atLeastOne(givenMap, WHAT.maps)),
        },
        'an object with the name of a family',
      ),
      WHAT.families,
    ),
    sizes: v.array(v.strictTuple([side, side], '[width, height]'), WHAT.sizes),
    mapsPerCombination: whole(1, MAX_RUNS, WHAT.mapsPerCombination),
    leastDistance: whole(1, MAX_SIDE - 1, WHAT.leastDistance),
    planners: atLeastOne(
      v.strictObject(
        {
          planner: v.string(WHAT.planner),
          params: valueLists(
            v.union([v.number(), v.string(), v.boolean()], 'a number, a text, true or false'),
          ),
        },
        'an object with the name of a planner',
      ),
      WHAT.planners,
    ),
  },
  'an object',
)

/**
 * The settings in a JSON value, if they have the right shape; what the values mean is not checked.
 * @throws InputError that names the first field that is missing, unknown or wrong.
 */
export function readSettingsShape(value: unknown): ExperimentSettings {
  if (Array.isArray(value)) throw notAnObject(value)
  const result = v.safeParse(shape, value, { abortEarly: true })
  if (result.success) return result.output
  const [issue] = result.issues
  const path = issue.path ?? []
  const place = path.map(({ key }) => (typeof key === 'number' ? `[${key}]` : `.${key}`)).join('')
  if (place === '') throw notAnObject(value)
  const field = place.replace(/^\./, '')
  const key = String(path[path.length - 1].key)
  if (issue.type === 'strict_object' && issue.expected === 'never') {
    throw new InputError(`${field}: there is no such field.`)
  }
  if (issue.input === undefined) {
    const what = key in WHAT ? WHAT[key as keyof typeof WHAT] : issue.message
    throw new InputError(`${field}: is missing; it must be ${what}.`)
  }
  throw new InputError(`${field}: must be ${issue.message}, but is ${describe(issue.input)}.`)
}

const notAnObject = (value: unknown) =>
  new InputError(`The settings must be an object, but are ${describe(value)}.`)
