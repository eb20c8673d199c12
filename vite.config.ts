import { defineConfig } from 'vite'
import { inlined } from './scripts/inlined.mjs'
import { usedStyles } from './scripts/used-styles.mjs'

// Relative addresses, so that the built page works from any sub-path.
export default defineConfig({
  base: './',
  // Any address but those of the pages is an error, also where the built pages are tried out.
  appType: 'mpa',
  worker: { format: 'es', rolldownOptions: { optimization: inlined } },
  css: { postcss: usedStyles },
  build: {
    // A browser that does not know these links loads the modules a little later, and that is all.
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: ['index.html', 'experiments.html'],
      optimization: inlined,
      // Both pages need these modules: in a file each, they take a slow machine longer to ask for.
      output: { codeSplitting: { groups: [{ name: 'planners', test: /\/src\/algorithms\// }] } },
    },
  },
})
