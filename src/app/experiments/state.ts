import type { Results } from '../../experiments/results'
import type { WithMessages } from '../state/messages'
import type { Preferences } from '../state/preferences'
import { type Draft, draftOf } from './draft'
import { type Checked, checkDraft } from './faults'
import { presets } from './presets'

export type Run =
  | { readonly kind: 'idle' }
  /** `left` in milliseconds, as far as it can be told. */
  | {
      readonly kind: 'running'
      readonly done: number
      readonly total: number
      readonly left: number | null
    }

/** Results on show, and of how many maps they should be, all or those of a shard. */
export interface Shown {
  readonly results: Results
  readonly maps: number
  /** Whether no map before the last of them is missing. */
  readonly areFirst: boolean
  readonly total: number
}

/** All that the page shows. */
export interface PageState extends WithMessages {
  readonly draft: Draft
  /** Grows when the whole form has to be made anew; not while somebody types in it. */
  readonly formMade: number
  readonly checked: Checked
  readonly run: Run
  readonly shown: Shown | null
  /** Names of the series that the charts leave out. */
  readonly hidden: ReadonlySet<string>
  readonly preferences: Preferences
  /** What happened last, for screen readers. */
  readonly said: string
}

export function initialState(preferences: Preferences): PageState {
  const draft = draftOf(presets[0].settings)
  return {
    draft,
    formMade: 0,
    checked: checkDraft(draft),
    run: { kind: 'idle' },
    shown: null,
    hidden: new Set(),
    preferences,
    messages: [],
    messagesTold: 0,
    said: '',
  }
}
