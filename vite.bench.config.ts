import { defineConfig } from 'vite'
import { withoutTape } from './bench/planners/without-tape.mjs'
import { inlined } from './scripts/inlined.mjs'

// The bench itself. What it times is not built into it, our library as others get it and the peers:
// but for the library as it would be without tapes.
export default defineConfig({
  publicDir: false,
  plugins: [withoutTape()],
  build: {
    target: 'es2022',
    outDir: 'dist-bench',
    lib: { entry: { bench: 'bench/planners/main.ts' }, formats: ['es'] },
    rolldownOptions: {
      optimization: inlined,
      external: [/^node:/, 'path-planner', 'pathfinding', /^ngraph\./, 'easystarjs'],
    },
  },
})
