// Builds the searches over cells as if there were no tapes, to find out what it costs that one may be
// given.

/** The tape among what a search over cells is given, up to the beginning of its body. */
const TAPE_GIVEN = /\btape,(\s[^{}]*\}: SearchTask[^{}]*\{)/g
const TASK_GIVEN = /: SearchTask[,)][^;{}=]*\{/
const TAPE_NAMED = /\btape\b/

/**
 * The source of a search with a constant in the place of the tape that it is given, so that all that
 * writes is left out when it is built.
 * @param {string} source
 * @returns {string}
 * @throws Error if it uses a tape that it is not given in this way
 */
export function withoutTapeGiven(source) {
  const changed = source.replaceAll(TAPE_GIVEN, '$1\n  const tape = undefined')
  if (changed === source && TASK_GIVEN.test(source) && TAPE_NAMED.test(source)) {
    throw new Error('A search is given its tape in another way: without-tape.mjs is out of date.')
  }
  return changed
}

/** @returns {import('vite').Plugin} */
export function withoutTape() {
  return {
    name: 'without-tape',
    enforce: 'pre',
    transform: {
      filter: { id: /\/src\/algorithms\/grid-search\// },
      handler: withoutTapeGiven,
    },
  }
}
