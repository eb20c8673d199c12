import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask } from '../ours'
import { allQueries } from '../questions'

/** A potential field with a wide influence of the obstacles, against a narrow one. */
export function fieldCase(map: BenchMap): Case {
  const work = (influence: number) =>
    allQueries([map], (grid, query) => ask(grid, query, 'potential-field', { influence }))
  return {
    name: `potential field, influence 5, ${map.name}`,
    against: 'influence 1',
    ours: work(5),
    peer: work(1),
    unit: 'query',
    target: { atMost: 3 },
  }
}
