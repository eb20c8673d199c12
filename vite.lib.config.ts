import { defineConfig } from 'vite'

// The planners as a library for Node and other programs.
export default defineConfig({
  publicDir: false,
  build: {
    outDir: 'dist-lib',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'index' },
  },
})
