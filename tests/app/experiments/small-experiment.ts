import { openingText } from '../../../src/app/experiments/open-files'
import { presets } from '../../../src/app/experiments/presets'
import { initialState, type PageState } from '../../../src/app/experiments/state'
import { defaultPreferences } from '../../../src/app/state/preferences'
import { runMap } from '../../../src/experiments/run-map'
import { countWork, type ExperimentSettings } from '../../../src/experiments/settings'
import { WHOLE } from '../../../src/experiments/shards'

export const settings: ExperimentSettings = {
  ...presets[0].settings,
  families: [
    { family: 'random', params: { density: [10, 40] } },
    {
      family: 'maps',
      params: {},
      maps: [{ name: 'corner.map', rows: ['......', '.####.', '....#.', '......'] }],
    },
  ],
  sizes: [[12, 9]],
  leastDistance: 4,
  mapsPerCombination: 4,
}
export const rows = Array.from({ length: countWork(settings).maps }, (_, map) =>
  runMap(settings, map),
).flat()
export const results = { settings, shard: WHOLE, rows }
export const state = initialState(defaultPreferences)

/** What comes of a state when the text of a file is opened. */
export function openText(before: PageState, text: string): PageState {
  const opening = openingText(text)
  for (;;) {
    const step = opening.next()
    if (step.done) return step.value(before)
  }
}
