import type { Grid } from '../../src/grid/grid'
import type { Work } from './case'
import type { BenchMap, Query } from './maps'

/** What is asked, and on which map. */
export interface Question {
  readonly map: BenchMap
  readonly query: Query
}

/** Maps with equally many queries in turn: the first query of each, then the second, and so on. */
export function questionsOn(maps: readonly BenchMap[]): Question[] {
  return maps[0].queries.flatMap((_, i) => maps.map((map) => ({ map, query: map.queries[i] })))
}

/** Work that asks all queries of maps in turn. */
export function allQueries(
  maps: readonly BenchMap[],
  ask: (grid: Grid, query: Query) => unknown,
): Work {
  const questions = questionsOn(maps)
  return () => {
    for (const { map, query } of questions) ask(map.grid, query)
    return questions.length
  }
}
