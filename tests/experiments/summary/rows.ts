import { type ExperimentSettings, type Row, runMap } from '../../../src/index'
import { settingsWith } from '../settings'

export const settings: ExperimentSettings = settingsWith({
  mapsPerCombination: 12,
  planners: [
    {
      planner: 'probabilistic-roadmap',
      params: {
        samples: [40, 5],
        search: ['dijkstra', 'a-star'],
        cost: ['cells', 'euclidean'],
      },
    },
    {
      planner: 'potential-field',
      params: {
        influence: [2, 0],
        repulsiveValue: [10, 30],
        repulsionDistance: ['manhattan', 'euclidean'],
      },
    },
    { planner: 'potential-field-memory' },
    { planner: 'tangent-bug' },
  ],
})

export const rows: Row[] = Array.from({ length: 120 }, (_, map) =>
  runMap(settings, map, () => performance.now()),
).flat()
