import { fileText } from '../grid/file-text'
import type { Results } from './results'
import { resultsFromCsv } from './results-csv'
import { resultsFromJson, resultsFromLines } from './results-json'

/**
 * Opens a results file: JSON lines, one JSON object, or CSV.
 * @throws InputError that says what is wrong with it, and where
 */
export function openResults(text: string): Results {
  const opening = openingResults(text)
  for (;;) {
    const step = opening.next()
    if (step.done) return step.value
  }
}

/** The same with rests: it yields what share of the rows is read, from 0 to 1. */
export function* openingResults(text: string): Generator<number, Results, void> {
  const content = fileText(text)
  if (isTable(content)) return yield* resultsFromCsv(content)
  return yield* beginsWithOrigin(content) ? resultsFromLines(content) : resultsFromJson(content)
}

/** Whether it is CSV, even if another program saved it anew or left out its comment. */
const isTable = (text: string): boolean => /^"?(#|map"?[,;\t])/.test(text)

/** Whether the first line is a JSON value of its own, and not all of the results in one line. */
function beginsWithOrigin(text: string): boolean {
  try {
    return !('rows' in Object(JSON.parse(text.split('\n', 1)[0])))
  } catch {
    return false
  }
}
