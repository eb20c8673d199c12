import { expect, test } from 'vitest'
import type { Grid } from '../../src/grid/grid'
import { randomInteger, randomNumbers } from '../../src/grid/random'
import { DIAGONAL_RULES } from '../../src/grid/steps'
import { type Outcome, type ParamSettings, plan } from '../../src/index'

/**
 * Blocks of several sizes, with rooms and dead ends between them.
 * @param scale how many times as large map and blocks are
 */
function blocks(random: () => number, scale: number): Grid {
  const width = scale * (10 + randomInteger(random, 50))
  const height = scale * (10 + randomInteger(random, 50))
  const walls = new Uint8Array(width * height)
  const count = randomInteger(random, 60)
  for (let i = 0; i < count; i++) {
    const [left, top] = [randomInteger(random, width), randomInteger(random, height)]
    const [right, bottom] = [
      left + scale * randomInteger(random, 9),
      top + scale * randomInteger(random, 9),
    ]
    for (let y = top; y <= Math.min(bottom, height - 1); y++) {
      walls.fill(1, y * width + left, y * width + Math.min(right + 1, width))
    }
  }
  return { width, height, walls }
}

test('what is kept of a map changes nothing but the time that the next search takes', () => {
  const random = randomNumbers(3)
  const wrong: string[] = []
  let reached = 0
  for (let map = 0; map < 60; map++) {
    // On large maps what jumps look at is known in squares of cells only.
    const grid = blocks(random, map % 6 === 0 ? 5 : 1)
    const free = Array.from(grid.walls.keys()).filter((cell) => grid.walls[cell] === 0)
    const anyFree = () => free[randomInteger(random, free.length)]
    const queries = Array.from({ length: 12 }, () => ({ start: anyFree(), goal: anyFree() }))
    for (const diagonal of DIAGONAL_RULES) {
      for (const cost of ['cells', 'euclidean']) {
        const ask = (query: (typeof queries)[number], search: string): Outcome => {
          const params: ParamSettings = { cost, search }
          return plan({ grid, ...query, diagonal }, 'decomposition', { params })
        }
        const first = queries.map((query) => ask(query, 'jump-point'))
        // Another map in between, and all is forgotten.
        const forget = () => {
          const other = { width: 2, height: 2, walls: new Uint8Array(4) }
          plan({ grid: other, start: 0, goal: 3, diagonal }, 'decomposition')
        }
        queries.forEach((query, i) => {
          forget()
          const alone = ask(query, 'jump-point')
          const { status, cost: least } = ask(query, 'dijkstra')
          if (status === 'reached') reached++
          const name = `map ${map}, query ${i}, ${diagonal}, ${cost}`
          if (first[i].status !== status || Math.abs(first[i].cost - least) > 1e-9) {
            wrong.push(`${name}: costs ${first[i].cost}, not ${least}`)
          }
          if (
            first[i].expanded !== alone.expanded ||
            String(first[i].path) !== String(alone.path)
          ) {
            wrong.push(`${name}: ${first[i].expanded} expanded, alone ${alone.expanded}`)
          }
        })
      }
    }
  }
  expect(wrong).toEqual([])
  expect(reached).toBeGreaterThan(2000)
})

test.each([
  ['a corridor round a block', '#######/#S....#/#.###.#/#.###.#/#.....#/#######/#G....#/#######'],
  [
    'a corridor that leads into a ring',
    '########/#S.....#/####.#.#/#....#.#/#.##.#.#/#......#/###.####/########/#G#####',
  ],
  ['two rings', '#########/#S..#...#/#.#...#.#/#...#...#/#########/#......G#/#########'],
])('a search ends where ways go round and round: %s', (_, text) => {
  const rows = text.split('/')
  const width = Math.max(...rows.map((row) => row.length))
  const cells = rows.map((row) => row.padEnd(width, '#')).join('')
  const grid = {
    width,
    height: rows.length,
    walls: Uint8Array.from(cells, (letter) => (letter === '#' ? 1 : 0)),
  }
  for (const diagonal of DIAGONAL_RULES) {
    const problem = { grid, start: cells.indexOf('S'), goal: cells.indexOf('G'), diagonal }
    const { status } = plan(problem, 'decomposition', { params: { search: 'jump-point' } })
    expect(status).toBe('unreachable')
  }
})
