// The built page in a browser of its own, on a server of its own.
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname, join, normalize } from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from '@playwright/test'
import { findBrowser } from '../../scripts/browser.mjs'

const FOLDER = fileURLToPath(new URL('../../dist', import.meta.url))

/** @type {Readonly<Record<string, string>>} */
const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.woff2': 'font/woff2',
}

/** Isolated from other origins: only such a page may measure its memory. */
const ISOLATED = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
}

/** @returns {Promise<{ url: string, close: () => void }>} */
async function serve() {
  const server = createServer(async ({ url = '/' }, response) => {
    const path = normalize(new URL(url, 'http://page').pathname)
    const name = path.endsWith('/') ? `${path}index.html` : path
    try {
      const content = await readFile(join(FOLDER, name))
      response.writeHead(200, { ...ISOLATED, 'Content-Type': TYPES[extname(name)] ?? '' })
      response.end(content)
    } catch {
      response.writeHead(404).end()
    }
  })
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)))
  const address = server.address()
  if (address === null || typeof address === 'string') throw new Error('The server has no port.')
  return { url: `http://127.0.0.1:${address.port}/`, close: () => server.close() }
}

/**
 * Opens a new browser for each piece of work, so that nothing of one is left in the next.
 * @template T
 * @param {(page: import('@playwright/test').Page, url: string) => Promise<T>} work
 * @returns {Promise<T>}
 */
export async function withPage(work) {
  const executablePath = findBrowser()
  const server = await serve()
  const browser = await chromium.launch({
    ...(executablePath && { executablePath }),
    args: [
      '--no-sandbox',
      '--disable-gpu',
      // Memory is measured when it is asked for, not when the browser next has nothing to do.
      '--enable-blink-features=ForceEagerMeasureMemory',
    ],
  })
  try {
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: 'reduce',
    })
    const page = await context.newPage()
    page.on('pageerror', (error) => console.error(error))
    page.setDefaultTimeout(120_000)
    return await work(page, server.url)
  } finally {
    await browser.close()
    server.close()
  }
}
