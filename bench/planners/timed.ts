import type { Case } from './case'
import { type Figures, figuresOf, timeInTurn } from './timing'
import { COLUMNS, columnsOf, lineOf, say } from './words'

/** What one case came to. */
export interface Result {
  readonly one: Case
  readonly figures: Figures
}

/** Times cases one after the other and says what came of each. */
export function timeAll(cases: Iterable<Case>): Result[] {
  say(`\n${lineOf(COLUMNS)}`)
  const results: Result[] = []
  for (const one of cases) {
    const figures = figuresOf(one.target, timeInTurn(one.ours, one.peer, one.isClose))
    say(lineOf(columnsOf(one, figures)))
    results.push({ one, figures })
  }
  return results
}

/** Whether all cases met their targets; says which did not. */
export function targetsMet(results: readonly Result[]): boolean {
  const missed = results.filter(({ figures }) => !figures.met)
  const bound = results.filter(({ one }) => one.target !== null)
  say(`\n${bound.length - missed.length} of ${bound.length} targets met.`)
  for (const { one } of missed) say(`  missed: ${one.name} against ${one.against}`)
  return missed.length === 0
}
