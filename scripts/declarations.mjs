// Names the files of the library's declarations in full: in Node, imports of types need it, too.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'

const [folder] = process.argv.slice(2)
/** What stands before the name of a file, its quote, and the name without an end. */
const IMPORT = /(\bfrom |\bimport\()(['"])(\.[^'"]*?)(?<!\.js)\2/g

for (const name of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
  if (!name.endsWith('.d.ts')) continue
  const path = join(folder, name)
  const text = readFileSync(path, 'utf8').replaceAll(IMPORT, (_, before, quote, file) => {
    const isFile = existsSync(join(dirname(path), `${file}.d.ts`))
    return `${before}${quote}${file}${isFile ? '' : '/index'}.js${quote}`
  })
  writeFileSync(path, text)
}
