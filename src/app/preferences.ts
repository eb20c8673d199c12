import * as v from 'valibot'

export const THEME_CHOICES = ['system', 'dark', 'light'] as const
export type ThemeChoice = (typeof THEME_CHOICES)[number]

/** What the user likes and undo leaves alone. */
export interface Preferences {
  readonly theme: ThemeChoice
  readonly showPotential: boolean
  /** Whether the line that greets newcomers is still shown. */
  readonly hint: boolean
}

export const defaultPreferences: Preferences = { theme: 'system', showPotential: true, hint: true }

export const preferencesSchema = v.object({
  theme: v.picklist(THEME_CHOICES),
  showPotential: v.boolean(),
  hint: v.boolean(),
})
