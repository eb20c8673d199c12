import { defineConfig } from 'vite'

// Relative addresses, so that the built page works from any sub-path.
export default defineConfig({
  base: './',
  // There is one page: any other address is an error, also where the built page is tried out.
  appType: 'mpa',
  worker: { format: 'es' },
})
