import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import type { MapRange } from '../../experiments/shards'

/** What the page tells a worker: first the settings, then one range of maps after the other. */
export type Order =
  | { readonly kind: 'settings'; readonly settings: ExperimentSettings }
  | { readonly kind: 'maps'; readonly range: MapRange }

/** What a worker answers to a range. */
export type Report =
  | {
      readonly kind: 'done'
      readonly range: MapRange
      /** For each map of the range. */
      readonly rows: readonly (readonly Row[])[]
      readonly milliseconds: number
    }
  | { readonly kind: 'failed'; readonly message: string }
