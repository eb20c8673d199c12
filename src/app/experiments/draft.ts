import type { Param, ParamValue } from '../../algorithms/params'
import { planners } from '../../algorithms/planners'
import {
  type ExperimentSettings,
  GIVEN_MAPS,
  type GivenMap,
  SETTINGS_FORMAT,
  SETTINGS_VERSION,
} from '../../experiments/settings'
import { type GeneratorParam, generators } from '../../grid/generators'

/** The values of a parameter: a text with commas for numbers, else what is ticked. */
export type List = string | readonly ParamValue[]

/** A family of maps or a planner in the form. */
export interface Entry {
  /** Tells entries apart while they come and go. */
  readonly key: number
  /** Of the generator or the planner; or `maps`. */
  readonly id: string
  readonly lists: Readonly<Record<string, List>>
  /** Of the family `maps` only. */
  readonly maps: readonly GivenMap[]
}

/** Settings as they stand in the form: what is typed may be wrong or half finished. A value. */
export interface Draft {
  readonly seed: string
  readonly diagonal: string
  readonly families: readonly Entry[]
  readonly sizes: string
  readonly mapsPerCombination: string
  readonly leastDistance: string
  readonly planners: readonly Entry[]
}

let keys = 0

export function newEntry(id: string, lists: Entry['lists'] = {}, maps: Entry['maps'] = []): Entry {
  keys++
  return { key: keys, id, lists, maps }
}

/** What a family or a planner declares; nothing for maps that were opened. */
export const paramsOf = (id: string): readonly (Param | GeneratorParam)[] =>
  [...planners, ...generators].find((one) => one.id === id)?.params ?? []

export const titleOf = (id: string): string =>
  id === GIVEN_MAPS
    ? 'Opened maps'
    : ([...planners, ...generators].find((one) => one.id === id)?.title ?? id)

/** The form for settings, as they are opened from a file. */
export function draftOf(settings: ExperimentSettings): Draft {
  return {
    seed: String(settings.seed),
    diagonal: settings.diagonal,
    families: settings.families.map(({ family, params, maps }) =>
      newEntry(family, listsOf(family, params), maps ?? []),
    ),
    sizes: settings.sizes.map(([width, height]) => `${width}×${height}`).join(', '),
    mapsPerCombination: String(settings.mapsPerCombination),
    leastDistance: String(settings.leastDistance),
    planners: settings.planners.map(({ planner, params }) =>
      newEntry(planner, listsOf(planner, params)),
    ),
  }
}

function listsOf(
  id: string,
  params: Readonly<Record<string, readonly ParamValue[]>>,
): Entry['lists'] {
  const isTicked = (name: string) => {
    const kind = paramsOf(id).find((param) => param.name === name)?.kind
    return kind === 'choice' || kind === 'boolean'
  }
  return Object.fromEntries(
    Object.entries(params).map(([name, values]) => [
      name,
      isTicked(name) ? values : values.join(', '),
    ]),
  )
}

/**
 * The settings that the form holds, as a JSON value to be checked. What is no number stays a text,
 * so that the check can say where it stands and what it should be.
 */
export function valueIn(draft: Draft): unknown {
  return {
    format: SETTINGS_FORMAT,
    version: SETTINGS_VERSION,
    seed: numberIn(draft.seed),
    diagonal: draft.diagonal,
    families: draft.families.map(({ id, lists, maps }) => ({
      family: id,
      params: paramsIn(lists),
      ...(id === GIVEN_MAPS && { maps }),
    })),
    sizes: itemsOf(draft.sizes).map(sizeIn),
    mapsPerCombination: numberIn(draft.mapsPerCombination),
    leastDistance: numberIn(draft.leastDistance),
    planners: draft.planners.map(({ id, lists }) => ({ planner: id, params: paramsIn(lists) })),
  }
}

/** A list that is empty stands for the default. */
function paramsIn(lists: Entry['lists']): Record<string, unknown[]> {
  const params: Record<string, unknown[]> = {}
  for (const [name, list] of Object.entries(lists)) {
    const values = typeof list === 'string' ? itemsOf(list).map(numberIn) : [...list]
    if (values.length > 0) params[name] = values
  }
  return params
}

const itemsOf = (text: string): string[] =>
  text.trim() === '' ? [] : text.split(/[,;]/).map((item) => item.trim())

/** The number in a text; the text if there is none. */
function numberIn(text: string): number | string {
  const number = Number(text)
  return text.trim() === '' || Number.isNaN(number) ? text : number
}

/** "40×30" and "40x30"; "40" is a square. */
function sizeIn(text: string): unknown {
  const [, width, height] = /^(\d+)(?:\s*[×x*]\s*(\d+))?$/i.exec(text) ?? []
  return width === undefined ? text : [Number(width), Number(height ?? width)]
}
