// Installs the packages if they are missing or older than the lock file. Needs nothing but Node, so
// that `npm start` and `npm test` can call it first on a fresh clone.
import { spawnSync } from 'node:child_process'
import { statSync } from 'node:fs'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))

/** @param {string} path */
const changed = (path) => statSync(`${root}/${path}`, { throwIfNoEntry: false })?.mtimeMs ?? 0

// npm writes this file last, so it is missing after an installation that was broken off.
if (changed('node_modules/.package-lock.json') < changed('package-lock.json')) {
  console.log('Installing the packages that package-lock.json names …')
  // One string and a shell: on Windows npm is a script, which only a shell can run.
  const { status } = spawnSync('npm ci --no-audit --no-fund', {
    cwd: root,
    shell: true,
    stdio: 'inherit',
  })
  if (status !== 0) {
    console.error(
      '\nThe packages could not be installed: npm says why above. Path Planner needs Node 20.19, 22.12,\n' +
        '24 or newer and a way to the npm registry. Once that is mended, run the same command again.',
    )
    process.exit(1)
  }
}
