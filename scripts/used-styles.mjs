// Leaves out what Materialize says of classes that no page has: most of its style sheet, which a
// browser would have to read and to match before anything is seen. Its tokens, and what it says of
// plain elements, stay. A class that is new in the code counts from the next start of Vite on.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))
const code = readdirSync(join(root, 'src', 'app'), { recursive: true, encoding: 'utf8' })
  .filter((path) => /\.(ts|html)$/.test(path))
  .map((path) => join('src', 'app', path))
const texts = ['index.html', 'experiments.html', ...code].map((path) =>
  readFileSync(join(root, path), 'utf8'),
)
/** Whatever may be the name of a class. */
const words = new Set(texts.join(' ').match(/[\w-]+/g))

/** @param {string} selector */
function mayMatch(selector) {
  const needed = selector.replace(/:not\([^)]*\)/g, '').matchAll(/\.([a-z][\w-]*)/gi)
  return [...needed].every(([, name]) => words.has(name))
}

/** @type {Exclude<import('vite').CSSOptions['postcss'], string | undefined>} */
export const usedStyles = {
  plugins: [
    {
      postcssPlugin: 'used-styles',
      Rule(rule) {
        if (!rule.source?.input.file?.includes('/materialize-css/')) return
        const used = rule.selectors.filter(mayMatch)
        if (used.length === 0) rule.remove()
        else if (used.length < rule.selectors.length) rule.selectors = used
      },
    },
  ],
}
