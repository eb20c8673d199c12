import type { ParamSettings } from '../../algorithms/params'
import type { Problem } from '../../grid/problem'
import { problemFromText } from '../../grid/text-map'
import { type Setup, withSettings } from '../state/setup'
import { maps } from './scenario-maps'

/** A map of the report with the planner and the settings that it shows. */
export interface Scenario {
  readonly id: string
  readonly title: string
  /** Where the report shows it; empty for a map that is not in it. */
  readonly figure: string
  /** One sentence on what to look at. */
  readonly see: string
  readonly problem: Problem
  readonly planner: string
  readonly params: ParamSettings
}

/** The map of a scenario, with its planner and settings; the other planners keep theirs. */
export function withScenario(setup: Setup, { problem, planner, params }: Scenario): Setup {
  return withSettings({ ...setup, problem, plannerId: planner }, planner, params)
}

/** What newcomers see. It stands apart, so that the page begins without the others. */
export const slantingWall: Scenario = {
  id: 'fig14-tangent-bug',
  title: 'A slanting wall, Tangent Bug',
  figure: 'Fig. 14',
  see: 'Sensing ahead does not always pay: here Tangent Bug comes to the goal by a longer path than Bug2.',
  problem: problemFromText(maps.fig14),
  planner: 'tangent-bug',
  params: { variant: 'report', range: 2 },
}
