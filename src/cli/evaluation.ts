import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { join } from 'node:path'
import { evaluate } from '../evaluation/evaluation'
import { openResults } from '../experiments/open-results'
import { countWork } from '../experiments/settings'
import { InputError } from '../grid/errors'

/** Writes `evaluation.md` and its drawings into a folder, out of the rows of the settings it is about. */
function main([rowsFile, folder]: readonly string[]): void {
  const results = openResults(readFileSync(rowsFile, 'utf8'))
  if (results.rows.length < countWork(results.settings).runs) {
    throw new InputError(`${rowsFile} is not complete.`)
  }
  const { node, v8 } = process.versions
  const machine = `Node ${node} (V8 ${v8}), ${availableParallelism()} cores, all of them busy`
  const { markdown, figures } = evaluate(results, machine, 'evaluation')
  mkdirSync(join(folder, 'evaluation'), { recursive: true })
  for (const { name, svg } of figures) {
    writeFileSync(join(folder, 'evaluation', `${name}.svg`), svg)
  }
  writeFileSync(join(folder, 'evaluation.md'), markdown)
}

main(process.argv.slice(2))
