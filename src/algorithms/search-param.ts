import type { ChoiceParam } from './params'

export type Search = 'dijkstra' | 'a-star'

/** The parameter of the planners that search a graph. */
export const searchParam = {
  name: 'search',
  label: 'Search',
  kind: 'choice',
  choices: ['dijkstra', 'a-star'],
  default: 'dijkstra',
  help: 'dijkstra: the report’s, by the cost so far; a-star: by that plus the least cost of what is left, for the same cost with fewer expanded.',
} as const satisfies ChoiceParam<'search', Search>
