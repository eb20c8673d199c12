// Builds the library if it is missing or older than its sources, for the programs that run it.
import { spawnSync } from 'node:child_process'
import { readdirSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))

/** @param {string} path */
const changed = (path) => statSync(join(root, path), { throwIfNoEntry: false })?.mtimeMs ?? 0

const sources = readdirSync(join(root, 'src'), { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts'))
  .map((path) => join('src', path))
const newest = Math.max(...[...sources, 'vite.lib.config.ts', 'package-lock.json'].map(changed))

// Its types are made last.
if (changed('dist-lib/types/index.d.ts') < newest) {
  const { status } = spawnSync('npm run --silent library', {
    cwd: root,
    shell: true,
    stdio: 'inherit',
  })
  if (status !== 0) process.exit(1)
}
