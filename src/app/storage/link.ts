import { completeParams, type ParamSettings } from '../../algorithms/params'
import { plannerById } from '../../algorithms/plan'
import { InputError } from '../../grid/errors'
import type { Problem } from '../../grid/problem'
import type { Setup } from '../state/setup'
import { setupFromText, setupToText } from './storage'

const KEY = '#setup='

/** More than a link to the largest map needs. */
const MOST_CHARACTERS = 2 ** 21

/** What stands behind the playground's address in a link to a setup. */
export const linkTo = (setup: Setup): string => KEY + encodeURIComponent(setupToText(setup))

/**
 * The setup in the last part of an address; `null` if there is none. All that it says is checked,
 * because a link may come from anywhere.
 * @throws InputError that says what is wrong with the link
 */
export function setupInLink(hash: string): Setup | null {
  if (!hash.startsWith(KEY)) return null
  if (hash.length > MOST_CHARACTERS) throw new InputError('It is longer than any map needs.')
  try {
    return setupFromText(decodeURIComponent(hash.slice(KEY.length)), checkedParams)
  } catch (error) {
    if (error instanceof InputError) throw error
    throw new InputError('It is damaged or was not copied to its end.')
  }
}

function checkedParams(
  all: Readonly<Record<string, ParamSettings>>,
  problem: Problem,
): Readonly<Record<string, ParamSettings>> {
  for (const [id, params] of Object.entries(all)) completeParams(plannerById(id), params, problem)
  return all
}
