import type { ParamSettings } from '../algorithms/params'
import type { Problem } from '../grid/problem'
import { problemFromText } from '../grid/text-map'
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

export const scenarios: readonly Scenario[] = [
  {
    id: 'fig05',
    title: 'Around two obstacles',
    figure: 'Fig. 5',
    see: 'The obstacles have eight corners to turn at; the roadmap joins those that see each other, and the path goes from corner to corner.',
    problem: problemFromText(maps.fig05),
    planner: 'visibility-graph',
    params: {},
  },
  {
    id: 'fig06',
    title: 'Caught in a hollow',
    figure: 'Fig. 6',
    see: 'Inside the hollow every cell around the last one has a higher potential, so there is no way down and the agent stays where it is.',
    problem: problemFromText(maps.fig06),
    planner: 'potential-field',
    params: { influence: 1, repulsiveValue: 30 },
  },
  {
    id: 'fig07',
    title: 'Out of the hollow by memory',
    figure: 'Fig. 7',
    see: 'The same hollow: because it may not step on its own path again, the agent must climb, and finds its way out and around.',
    problem: problemFromText(maps.fig07),
    planner: 'potential-field-memory',
    params: { influence: 1, repulsiveValue: 30, repulsionDistance: 'manhattan' },
  },
  {
    id: 'fig09',
    title: 'Along a bent obstacle',
    figure: 'Fig. 9',
    see: 'The obstacle cell that is felt changes as the rover goes round the bend: where the next step is blocked, the cell in the way takes its place.',
    problem: problemFromText(maps.fig09),
    planner: 'bug1',
    params: {},
  },
  {
    id: 'fig11-bug1',
    title: 'Two obstacles, Bug1',
    figure: 'Fig. 11',
    see: 'Bug1 walks once around each obstacle in full, then back to the cell nearest to the goal, before it goes on.',
    problem: problemFromText(maps.fig11),
    planner: 'bug1',
    params: {},
  },
  {
    id: 'fig11-bug2',
    title: 'Two obstacles, Bug2',
    figure: 'Fig. 11',
    see: 'On the map where Bug1 walks around everything, Bug2 leaves each obstacle as soon as it meets its first straight path again: less than half the way.',
    problem: problemFromText(maps.fig11),
    planner: 'bug2',
    params: { leave: 'report' },
  },
  {
    id: 'fig12-bug1',
    title: 'The spiral, Bug1',
    figure: 'Fig. 12',
    see: 'Bug1 goes all the way around the spiral to find the cell nearest to the goal, and so it gets inside.',
    problem: problemFromText(maps.fig12),
    planner: 'bug1',
    params: {},
  },
  {
    id: 'fig12-bug2',
    title: 'The spiral, Bug2',
    figure: 'Fig. 12',
    see: 'Bug2 takes up its straight path wherever it meets it, also further back, so it comes to the same place again and goes round for ever.',
    problem: problemFromText(maps.fig12),
    planner: 'bug2',
    params: { leave: 'report' },
  },
  {
    id: 'fig13',
    title: 'Two obstacles, Tangent Bug',
    figure: 'Fig. 13',
    see: 'The map of Fig. 11: Tangent Bug senses the obstacle before it touches it and makes straight for its end, so its path is shorter than that of Bug2.',
    problem: problemFromText(maps.fig11),
    planner: 'tangent-bug',
    params: { variant: 'report', range: 2 },
  },
  {
    id: 'fig14-bug2',
    title: 'A slanting wall, Bug2',
    figure: 'Fig. 14',
    see: 'Bug2 follows the wall until it meets its straight path, which lies just right here: compare the length with that of Tangent Bug.',
    problem: problemFromText(maps.fig14),
    planner: 'bug2',
    params: { leave: 'report' },
  },
  {
    id: 'fig14-tangent-bug',
    title: 'A slanting wall, Tangent Bug',
    figure: 'Fig. 14',
    see: 'Sensing ahead does not always pay: here Tangent Bug comes to the goal by a longer path than Bug2.',
    problem: problemFromText(maps.fig14),
    planner: 'tangent-bug',
    params: { variant: 'report', range: 2 },
  },
  {
    id: 'banner',
    title: 'Path Planner in letters',
    figure: '',
    see: 'The letters have many corners; watch how few of the lines between them the path needs.',
    problem: problemFromText(maps.banner),
    planner: 'visibility-graph',
    params: {},
  },
]
