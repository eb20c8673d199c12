import * as v from 'valibot'
import { faultOf, type ParamSettings } from '../../algorithms/params'
import { planners } from '../../algorithms/planners'
import { fromBase64, toBase64 } from '../../grid/formats/base64'
import { packWalls, unpackWalls } from '../../grid/formats/packed'
import { readShape } from '../../grid/formats/shape'
import { MAX_SIDE, MIN_SIDE } from '../../grid/grid'
import { checkProblem, type Problem, SIDE_IN_WORDS } from '../../grid/problem'
import { DIAGONAL_RULES } from '../../grid/steps'
import { defaultPreferences, type Preferences, preferencesSchema } from '../state/preferences'
import type { Setup } from '../state/setup'

/** The part of `localStorage` that is used. It may throw on any call. */
export type Shelf = Pick<Storage, 'getItem' | 'setItem'>

/** The browser's own, if it may be used at all. */
export function browserShelf(): Shelf | null {
  try {
    return window.localStorage
  } catch {
    return null
  }
}

const SETUP_KEY = 'path-planner.setup'
const PREFERENCES_KEY = 'path-planner.preferences'

const side = v.pipe(v.number(), v.integer(), v.minValue(MIN_SIDE), v.maxValue(MAX_SIDE))

const setupSchema = v.object({
  version: v.literal(1),
  width: side,
  height: side,
  walls: v.string(),
  start: v.number(),
  goal: v.number(),
  diagonal: v.picklist(DIAGONAL_RULES),
  plannerId: v.picklist(planners.map((planner) => planner.id)),
  params: v.record(
    v.string(),
    v.record(v.string(), v.union([v.number(), v.string(), v.boolean()])),
  ),
  seed: v.pipe(v.number(), v.safeInteger()),
})

const words = {
  version: '1',
  width: SIDE_IN_WORDS,
  height: SIDE_IN_WORDS,
  walls: 'a text',
  start: 'the number of a cell',
  goal: 'the number of a cell',
  diagonal: DIAGONAL_RULES.join(' or '),
  plannerId: `one of ${planners.map((planner) => planner.id).join(', ')}`,
  params: 'values of parameters, by planner',
  seed: 'a whole number',
}

export function setupToText(setup: Setup): string {
  const { grid, ...ends } = setup.problem
  const { plannerId, params, seed } = setup
  const { width, height } = grid
  const walls = toBase64(packWalls(grid.walls))
  return JSON.stringify({ version: 1, width, height, walls, ...ends, plannerId, params, seed })
}

/**
 * @param readParams what to make of parameters that no planner declares, or whose values do not fit
 * @throws Error if the text holds no map to plan on; an InputError says what is wrong with it.
 */
export function setupFromText(text: string, readParams: ReadParams = knownParams): Setup {
  const read = readShape(setupSchema, words, Object(JSON.parse(text)))
  const { width, height, start, goal, diagonal, plannerId, params, seed } = read
  const walls = unpackWalls(fromBase64(read.walls), width * height)
  const problem = { grid: { width, height, walls }, start, goal, diagonal }
  checkProblem(problem)
  return { problem, plannerId, params: readParams(params, problem), seed }
}

type AllParams = Readonly<Record<string, ParamSettings>>
type ReadParams = (params: AllParams, problem: Problem) => AllParams

/** Without what no planner declares any more, as after an update of the page. */
function knownParams(params: AllParams): AllParams {
  const known: Record<string, ParamSettings> = {}
  for (const planner of planners) {
    const settings = params[planner.id]
    if (!settings) continue
    known[planner.id] = Object.fromEntries(
      planner.params
        .filter((param) => param.name in settings && !faultOf(param, settings[param.name]))
        .map((param) => [param.name, settings[param.name]]),
    )
  }
  return known
}

export type Loaded =
  | { readonly kind: 'nothing' }
  | { readonly kind: 'setup'; readonly setup: Setup }
  | { readonly kind: 'broken' }

/** What was drawn when the page was last open. */
export function loadSetup(shelf: Shelf | null): Loaded {
  const text = read(shelf, SETUP_KEY)
  if (text === null) return { kind: 'nothing' }
  try {
    return { kind: 'setup', setup: setupFromText(text) }
  } catch {
    return { kind: 'broken' }
  }
}

/** @param otherwise what holds if none were kept, or none that can be read */
export function loadPreferences(
  shelf: Shelf | null,
  otherwise: Preferences = defaultPreferences,
): Preferences {
  try {
    const text = read(shelf, PREFERENCES_KEY)
    return text === null ? otherwise : v.parse(preferencesSchema, JSON.parse(text))
  } catch {
    return otherwise
  }
}

/** Whether it could be kept: the shelf may be forbidden or full. */
export const saveSetup = (shelf: Shelf | null, setup: Setup): boolean =>
  write(shelf, SETUP_KEY, setupToText(setup))

export const savePreferences = (shelf: Shelf | null, preferences: Preferences): boolean =>
  write(shelf, PREFERENCES_KEY, JSON.stringify(preferences))

function read(shelf: Shelf | null, key: string): string | null {
  try {
    return shelf?.getItem(key) ?? null
  } catch {
    return null
  }
}

function write(shelf: Shelf | null, key: string, text: string): boolean {
  try {
    shelf?.setItem(key, text)
    return shelf !== null
  } catch {
    return false
  }
}
