// Text maps of 2048 × 2048 cells, the largest that the page takes.

export const SIDE = 2048

/** Numbers from 0 to 1 from a seed (a linear congruential generator). @param {number} seed */
function randomNumbers(seed) {
  let state = seed
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return state / 2 ** 32
  }
}

/**
 * Start at the top left, goal at the bottom right.
 * @param {(x: number, y: number) => boolean} isObstacle
 * @returns {string}
 */
function textMap(isObstacle) {
  const character = (/** @type {number} */ x, /** @type {number} */ y) => {
    if (x === 0 && y === 0) return 'S'
    if (x === SIDE - 1 && y === SIDE - 1) return 'G'
    return isObstacle(x, y) ? '#' : '.'
  }
  const rows = Array.from({ length: SIDE }, (_, y) =>
    Array.from({ length: SIDE }, (_, x) => character(x, y)),
  )
  return rows.map((row) => row.join('')).join('\n')
}

/** One cell in five is an obstacle. */
export function randomMap() {
  const random = randomNumbers(7)
  return textMap(() => random() < 0.2)
}

/** No obstacles but those around the goal: a search opens and closes every other cell in vain. */
export function walledGoalMap() {
  const last = SIDE - 1
  return textMap((x, y) => x >= last - 1 && y >= last - 1)
}
