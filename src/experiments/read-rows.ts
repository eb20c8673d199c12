import { InputError } from '../grid/errors'
import type { Origin } from './results'
import { ROWS_AT_ONCE, type Row } from './row'
import { readRow } from './row-shape'
import { countWork, plannerSettings } from './settings'

/**
 * The rows of one file in their order, by map, and for each map by setting, in whatever order they
 * stand there. Some may be missing. Now and then it yields what share of them is read, from 0 to 1.
 * @param jsonOf gives the JSON value of a row out of what stands at its place in the file
 * @param nameOf names the place for messages ("Line 7")
 * @throws InputError for what is no row, or none of these settings, or there twice
 */
export function* readRows<Source>(
  { settings }: Origin,
  sources: readonly Source[],
  jsonOf: (source: Source, i: number) => unknown,
  nameOf: (i: number) => string,
): Generator<number, Row[], void> {
  const { maps } = countWork(settings)
  const planners = plannerSettings(settings).map(({ planner }) => planner)
  const rows: Row[] = []
  for (let i = 0; i < sources.length; i++) {
    if (i % ROWS_AT_ONCE === 0) yield i / sources.length
    const row = readRow(jsonOf(sources[i], i), nameOf(i))
    const { map, setting, planner } = row
    if (map >= maps || planner !== planners[setting]) {
      throw new InputError(
        `${nameOf(i)} is of map ${map} and of ${planner} as planner setting ${setting}, which the settings of this file do not have.`,
      )
    }
    rows.push(row)
  }
  rows.sort((a, b) => a.map - b.map || a.setting - b.setting)
  const twice = rows.find(
    ({ map, setting }, i) => map === rows[i - 1]?.map && setting === rows[i - 1].setting,
  )
  if (!twice) return rows
  throw new InputError(`Map ${twice.map} has two rows of planner setting ${twice.setting}.`)
}
