import { defineConfig } from 'vite'
import { usedStyles } from './scripts/used-styles.mjs'

// Relative addresses, so that the built page works from any sub-path.
export default defineConfig({
  base: './',
  // Any address but those of the pages is an error, also where the built pages are tried out.
  appType: 'mpa',
  worker: { format: 'es' },
  css: { postcss: usedStyles },
  build: { rolldownOptions: { input: ['index.html', 'experiments.html'] } },
})
