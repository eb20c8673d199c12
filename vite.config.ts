import { defineConfig } from 'vite'

// Relative addresses, so that the built page works from any sub-path.
export default defineConfig({
  base: './',
  worker: { format: 'es' },
})
