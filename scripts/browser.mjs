// The browser that the tests drive. As a program: makes sure that there is one.
import { spawnSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { homedir, platform } from 'node:os'
import { delimiter, dirname, join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from '@playwright/test'

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome']
const DOWNLOAD_LIMIT_MS = 5 * 60_000

/** Where installers put a Chromium or Chrome. */
function wellKnownPlaces() {
  const { env } = process
  if (platform() === 'win32') {
    return [env.PROGRAMFILES, env['PROGRAMFILES(X86)'], env.LOCALAPPDATA].flatMap((folder = '') => [
      join(folder, 'Google', 'Chrome', 'Application', 'chrome.exe'),
      join(folder, 'Chromium', 'Application', 'chrome.exe'),
    ])
  }
  const onPath = (env.PATH ?? '')
    .split(delimiter)
    .filter((folder) => folder !== '')
    .flatMap((folder) => NAMES.map((name) => join(folder, name)))
  if (platform() === 'darwin') {
    const apps = ['/Applications', join(homedir(), 'Applications')].flatMap((folder) => [
      join(folder, 'Google Chrome.app/Contents/MacOS/Google Chrome'),
      join(folder, 'Chromium.app/Contents/MacOS/Chromium'),
    ])
    return [...onPath, ...apps]
  }
  return [...onPath, '/usr/bin/chromium', '/opt/google/chrome/chrome', '/snap/bin/chromium']
}

/**
 * Whether the file is a browser that starts: Ubuntu has a `chromium-browser` that only prints what
 * to install, and a downloaded one may lack system libraries. Windows opens a window when asked.
 * @param {string} path
 */
function works(path) {
  if (!existsSync(path)) return false
  if (platform() === 'win32') return true
  return spawnSync(path, ['--version'], { timeout: 20_000 }).status === 0
}

/**
 * The path of a browser to test with: the one that CHROMIUM_PATH names, else a Chromium or Chrome
 * of this machine, else Playwright's own; undefined if there is none.
 */
export function findBrowser() {
  const named = process.env.CHROMIUM_PATH
  if (named) {
    if (!works(named)) throw new Error(`CHROMIUM_PATH is ${named}, but no browser starts there.`)
    return named
  }
  return [...wellKnownPlaces(), chromium.executablePath()].find(works)
}

function installPlaywrights() {
  console.log('No Chromium or Chrome was found: Playwright downloads one …')
  const cli = join(dirname(createRequire(import.meta.url).resolve('@playwright/test')), 'cli.js')
  spawnSync(process.execPath, [cli, 'install', 'chromium'], {
    stdio: 'inherit',
    timeout: DOWNLOAD_LIMIT_MS,
    env: { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '10000', ...process.env },
  })
}

function installDebians() {
  if (platform() !== 'linux') return
  const isRoot = process.getuid?.() === 0
  /** @param {string[]} args */
  const aptGet = (...args) => {
    const command = isRoot ? ['apt-get', ...args] : ['sudo', 'apt-get', ...args]
    return spawnSync(command[0], command.slice(1), {
      stdio: 'inherit',
      env: { ...process.env, DEBIAN_FRONTEND: 'noninteractive' },
    })
  }
  console.log("That gave no browser that starts: trying Debian's package …")
  if (aptGet('update').status === 0) aptGet('install', '-y', 'chromium')
}

function ensureBrowser() {
  for (const install of [installPlaywrights, installDebians]) {
    if (findBrowser()) return
    install()
  }
  if (findBrowser()) return
  throw new Error(
    'The browser tests need Chromium or Chrome. None was found, and none could be installed.\n' +
      'Install one, or set CHROMIUM_PATH to the program file of one, and run the tests again.',
  )
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  try {
    ensureBrowser()
  } catch (error) {
    console.error(error instanceof Error ? error.message : error)
    process.exit(1)
  }
}
