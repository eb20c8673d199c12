import { defineConfig } from 'vite'
import { inlined } from './scripts/inlined.mjs'

// The planners as a library for Node and other programs, and the programs of the command line.
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist-lib',
    lib: {
      entry: {
        index: 'src/index.ts',
        experiment: 'src/cli/experiment.ts',
        evaluation: 'src/cli/evaluation.ts',
      },
      formats: ['es'],
    },
    rolldownOptions: { external: /^node:/, optimization: inlined },
  },
})
