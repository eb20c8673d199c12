import { defineConfig } from 'vite'

// The bench itself. What it times is not built into it: our library as others get it, and the peers.
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'dist-bench',
    lib: { entry: { bench: 'bench/planners/main.ts' }, formats: ['es'] },
    rolldownOptions: {
      external: [/^node:/, 'path-planner', 'pathfinding', /^ngraph\./, 'easystarjs'],
    },
  },
})
