// What a page fetches, and how large that is.
import { brotliCompressSync, gzipSync } from 'node:zlib'

/**
 * @typedef {object} Fetched
 * @property {string} path
 * @property {string} type what the page wants it for: "document", "script", "font" …
 * @property {string} content its media type
 * @property {number} raw bytes as they are
 * @property {number} gzip
 * @property {number} brotli
 */

/** Watches what a page and its workers fetch from now on; gives what there was up to a moment.
 * @param {import('@playwright/test').Page} page
 * @returns {() => Promise<Fetched[]>}
 */
export function fetchedBy(page) {
  /** @type {Set<import('@playwright/test').Request>} */
  const requests = new Set()
  page.context().on('requestfinished', (request) => requests.add(request))
  return () => Promise.all([...requests].map(measured))
}

/**
 * @param {import('@playwright/test').Request} request
 * @returns {Promise<Fetched>}
 */
async function measured(request) {
  const response = await request.response()
  if (!response) throw new Error(`There was no answer to ${request.url()}.`)
  const body = await response.body()
  return {
    path: new URL(request.url()).pathname,
    type: request.resourceType(),
    content: response.headers()['content-type'] ?? '',
    raw: body.length,
    gzip: gzipSync(body).length,
    brotli: brotliCompressSync(body).length,
  }
}
