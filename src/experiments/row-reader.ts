import { InputError } from '../grid/errors'
import type { Origin } from './results'
import type { Row } from './row'
import { readRow } from './row-shape'
import { countWork, plannerSettings } from './settings'

/**
 * Reads the rows of one file in their order: by map, and for each map by setting. Some may be missing.
 * @returns what gives the row in the next JSON value, with the name of its place for messages
 *   ("Line 7"). It throws an InputError for what is no row, or none of these settings, or there twice.
 */
export function rowReader({ settings }: Origin): (value: unknown, name: string) => Row {
  const { maps } = countWork(settings)
  const planners = plannerSettings(settings).map(({ planner }) => planner)
  let before = -1
  return (value, name) => {
    const row = readRow(value, name)
    const { map, setting, planner } = row
    if (map >= maps || planner !== planners[setting]) {
      throw new InputError(
        `${name} is of map ${map} and of ${planner} as planner setting ${setting}, which the settings of this file do not have.`,
      )
    }
    const place = map * planners.length + setting
    if (place <= before) {
      throw new InputError(`${name} is out of place: rows go by map, and for each map by setting.`)
    }
    before = place
    return row
  }
}
