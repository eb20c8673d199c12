/**
 * For the bundler: a number that one module exports stands in the others wherever it is used. Engines
 * read a module's own numbers from memory each time, which inner loops notice.
 * @satisfies {import('vite').Rolldown.InputOptions['optimization']}
 */
export const inlined = { inlineConst: { mode: /** @type {const} */ ('all'), pass: 3 } }
