import { checkSettings, type ExperimentSettings, type Row } from '../../src/index'

/** Settings of a small experiment, with some fields replaced. */
export function settingsWith(fields: object = {}): ExperimentSettings {
  return checkSettings({ ...SMALL, ...fields })
}

export const SMALL = {
  format: 'path-planner-experiment',
  version: 1,
  seed: 7,
  diagonal: 'if-at-most-one-obstacle',
  families: [
    { family: 'random', params: { density: [10, 30] } },
    { family: 'blocks' },
    { family: 'maze', params: { loops: [0] } },
    {
      family: 'maps',
      maps: [
        { name: 'a wall', rows: ['.......', '...#...', '...#...', '.......'] },
        { name: 'two rooms – one door', rows: ['...#...', '...#...', '...#...'] },
      ],
    },
  ],
  sizes: [
    [12, 9],
    [20, 20],
  ],
  mapsPerCombination: 3,
  leastDistance: 4,
  planners: [
    { planner: 'decomposition', params: { cost: ['cells', 'euclidean'] } },
    { planner: 'probabilistic-roadmap', params: { samples: [5, 40] } },
    { planner: 'potential-field', params: { influence: [0, 1], repulsiveValue: [10, 30] } },
    { planner: 'bug1' },
    { planner: 'bug2', params: { leave: ['report', 'closer'] } },
    { planner: 'tangent-bug', params: { variant: ['classic'], range: [3] } },
  ],
} as const

/** The rows without what another run may change. */
export const timeless = (rows: readonly Row[]) =>
  rows.map(({ milliseconds: _, ...others }) => others)
