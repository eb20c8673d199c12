import { availableParallelism } from 'node:os'
import { defineConfig, type PlaywrightTestOptions } from '@playwright/test'
import { findBrowser } from './scripts/browser.mjs'

// Far from the root of its server: the built page must work from any sub-path.
const SUB_PATH = '/some/sub-path/'

const executablePath = findBrowser()
const desktop = { viewport: { width: 1280, height: 800 } }
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }

/**
 * What must hold everywhere runs on both devices in both themes, what has nothing to do with colours on
 * both devices once, the rest on its device.
 */
function project(name: string, folders: string[], use: Partial<PlaywrightTestOptions>) {
  return { name, testMatch: folders.map((folder) => `${folder}/*.spec.ts`), use }
}

export default defineConfig({
  testDir: 'e2e',
  fullyParallel: true,
  forbidOnly: true,
  // On a machine with much else to do a step may come too early; what fails once is named all the same.
  retries: 1,
  // The planners of a page work beside it, and the browser itself: a core is left to them.
  workers: Math.min(4, Math.max(2, availableParallelism() - 1)),
  // Generous, for machines with much else to do: a test never waits longer than it must.
  timeout: 90_000,
  expect: { timeout: 20_000 },
  reporter: [['list'], ['json', { outputFile: 'reports/e2e.json' }]],
  use: {
    baseURL: `http://127.0.0.1:${process.env.PREVIEW_PORT}${SUB_PATH}`,
    contextOptions: { reducedMotion: 'reduce' },
    screenshot: 'only-on-failure',
    launchOptions: {
      ...(executablePath && { executablePath }),
      args: [
        '--no-sandbox',
        '--disable-gpu',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--no-first-run',
      ],
    },
  },
  projects: [
    project('desktop dark', ['everywhere', 'either-theme', 'desktop'], {
      ...desktop,
      colorScheme: 'dark',
    }),
    project('desktop light', ['everywhere'], { ...desktop, colorScheme: 'light' }),
    project('phone dark', ['everywhere', 'phone'], { ...phone, colorScheme: 'dark' }),
    project('phone light', ['everywhere', 'either-theme'], { ...phone, colorScheme: 'light' }),
  ],
  // Takes the next free port, so that two runs on one machine do not meet.
  webServer: {
    command: `npx vite preview --host 127.0.0.1 --base ${SUB_PATH}`,
    wait: { stdout: /127\.0\.0\.1:(?<preview_port>\d+)\// },
  },
})
