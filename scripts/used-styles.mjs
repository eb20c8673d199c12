// Leaves out what Materialize says of classes that no page has, and its tokens that nothing asks for:
// most of its style sheet, which a browser would have to read and to match before anything is seen.
// What it says of plain elements stays, but for rings around what has the focus that only Firefox would
// draw, dotted, in place of the page's own. What is new in the code counts from the next start of Vite on.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))
const paths = readdirSync(join(root, 'src'), { recursive: true, encoding: 'utf8' })

/** @param {RegExp} name of files in src */
const texts = (name) =>
  paths
    .filter((path) => name.test(path))
    .map((path) => readFileSync(join(root, 'src', path), 'utf8'))

const pages = ['index.html', 'experiments.html'].map((path) =>
  readFileSync(join(root, path), 'utf8'),
)
/** Whatever may be the name of a class, or of a token that a script asks for. */
const words = new Set([...pages, ...texts(/\.(ts|html)$/)].join(' ').match(/[\w-]+/g))

/** @param {string} style */
const tokensIn = (style) => [...style.matchAll(/var\(\s*(--[\w-]+)/g)].map(([, token]) => token)

const tokens = new Set([...words, ...tokensIn(texts(/\.css$/).join(' '))])

/** @param {string} selector */
function mayMatch(selector) {
  if (selector.includes(':-moz-focusring')) return false
  const needed = selector.replace(/:not\([^)]*\)/g, '').matchAll(/\.([a-z][\w-]*)/gi)
  return [...needed].every(([, name]) => words.has(name))
}

/**
 * Again and again, since tokens ask for others.
 * @param {import('postcss').Root} sheet
 */
function removeUnaskedTokens(sheet) {
  const asked = new Set(tokens)
  sheet.walkDecls(({ value }) => {
    for (const token of tokensIn(value)) asked.add(token)
  })
  let isDone = true
  sheet.walkDecls(/^--/, (declaration) => {
    if (asked.has(declaration.prop)) return
    declaration.remove()
    isDone = false
  })
  if (!isDone) removeUnaskedTokens(sheet)
}

/** @param {{ source?: { input: { file?: string } } }} node */
const isMaterialize = ({ source }) => source?.input.file?.includes('/materialize-css/')

/** @type {Exclude<import('vite').CSSOptions['postcss'], string | undefined>} */
export const usedStyles = {
  plugins: [
    {
      postcssPlugin: 'used-styles',
      Rule(rule) {
        if (!isMaterialize(rule)) return
        const used = rule.selectors.filter(mayMatch)
        if (used.length === 0) rule.remove()
        else if (used.length < rule.selectors.length) rule.selectors = used
      },
      OnceExit(sheet) {
        if (isMaterialize(sheet)) removeUnaskedTokens(sheet)
      },
    },
  ],
}
