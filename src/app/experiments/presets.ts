import sectionV from '../../../settings/section-v.json'
import { planners } from '../../algorithms/planners'
import {
  type ExperimentSettings,
  type PlannerFamily,
  SETTINGS_FORMAT,
  SETTINGS_VERSION,
} from '../../experiments/settings'
import { checkSettings } from '../../experiments/settings-check'

export interface Preset {
  readonly id: string
  readonly title: string
  readonly settings: ExperimentSettings
}

/** Lists worth comparing within a minute; the other planners have their defaults. */
const QUICK_LISTS: Readonly<Record<string, PlannerFamily['params']>> = {
  'probabilistic-roadmap': { samples: [20, 40, 80, 160] },
  bug2: { leave: ['report', 'closer'] },
  'tangent-bug': { variant: ['report', 'classic'] },
}

export const presets: readonly Preset[] = [
  {
    id: 'quick',
    title: 'Quick',
    settings: {
      format: SETTINGS_FORMAT,
      version: SETTINGS_VERSION,
      seed: 1,
      diagonal: 'if-at-most-one-obstacle',
      families: [
        { family: 'random', params: { density: [5, 10, 15, 20, 25, 30, 35, 40, 45, 50] } },
      ],
      sizes: [[40, 40]],
      mapsPerCombination: 20,
      leastDistance: 20,
      planners: planners.map(({ id }) => ({ planner: id, params: QUICK_LISTS[id] ?? {} })),
    },
  },
  { id: 'section-v', title: 'Section V of the report', settings: checkSettings(sectionV) },
]
