import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vitest/config'

// Random tests read both; the same seed makes the same maps.
const { SEED = '1', MAPS } = process.env

// `--mode properties` is the long run: many maps, and as long as they take.
export default defineConfig(({ mode }) => {
  const long = mode === 'properties'
  const env = { SEED, MAPS: MAPS ?? (long ? '100000' : '2000') }
  console.log(`Random maps: ${env.MAPS}, seed ${env.SEED} (set MAPS and SEED to change them)`)
  return {
    // The bench names the library as other programs do; its tests take it from the source.
    resolve: { alias: { 'path-planner': fileURLToPath(new URL('src/index.ts', import.meta.url)) } },
    test: {
      include: ['tests/**/*.test.ts'],
      setupFiles: ['tests/setup.ts'],
      env,
      testTimeout: long ? 0 : 60_000,
      reporters: ['default', 'json'],
      outputFile: { json: 'reports/unit.json' },
    },
  }
})
