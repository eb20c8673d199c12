import type { Row } from '../../experiments/row'
import type { ExperimentSettings } from '../../experiments/settings'
import { testMap } from '../../experiments/test-map'
import { linkTo } from '../storage/link'

/** The address at which the playground shows how a run went: its map, made once more, and its planner. */
export function addressOf(settings: ExperimentSettings, row: Row): string {
  const { problem } = testMap(settings, row.map)
  const { planner: plannerId, params, seed } = row
  return `./index.html${linkTo({ problem, plannerId, params: { [plannerId]: params }, seed })}`
}
