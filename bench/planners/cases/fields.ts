import type { Case } from '../case'
import type { BenchMap } from '../maps'
import { ask } from '../ours'

/** A potential field with a wide influence of the obstacles, against a narrow one. */
export function fieldCase({ name, grid, queries }: BenchMap): Case {
  const work = (influence: number) => () => {
    for (const query of queries) ask(grid, query, 'potential-field', { influence })
    return queries.length
  }
  return {
    name: `potential field, influence 5, ${name}`,
    against: 'influence 1',
    ours: work(5),
    peer: work(1),
    unit: 'query',
    target: { atMost: 3 },
  }
}
