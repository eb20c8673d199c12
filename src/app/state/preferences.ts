import * as v from 'valibot'
import type { Sight } from '../../render/scene'
import { SPEEDS, type Speed } from '../playback/speeds'

const THEME_CHOICES = ['system', 'dark', 'light'] as const
export type ThemeChoice = (typeof THEME_CHOICES)[number]

export const SIGHTS = ['both', 'world', 'known'] as const satisfies readonly Sight[]

/** How the user likes the page; undo leaves it as it is. */
export interface Preferences {
  readonly theme: ThemeChoice
  readonly showPotential: boolean
  /** Whether the line that greets newcomers is still shown. */
  readonly hint: boolean
  readonly speed: Speed
  /** What is shown of a planner with a rover. */
  readonly sight: Sight
}

export const defaultPreferences: Preferences = {
  theme: 'system',
  showPotential: true,
  hint: true,
  speed: 5,
  sight: 'both',
}

/** What an earlier version of the page did not keep has its default. */
export const preferencesSchema = v.object({
  theme: v.picklist(THEME_CHOICES),
  showPotential: v.boolean(),
  hint: v.boolean(),
  speed: v.optional(v.picklist(SPEEDS), defaultPreferences.speed),
  sight: v.optional(v.picklist(SIGHTS), defaultPreferences.sight),
})
