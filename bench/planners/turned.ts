import type { BenchMap } from './maps'

/**
 * A map and the same turned by 180 degrees: every other query is asked on either. Asked in turn, no
 * two are on the same map, so that nothing which is kept of the map before is of use.
 */
export function turnAbout(map: BenchMap): readonly BenchMap[] {
  const half = (rest: number) => map.queries.filter((_, i) => i % 2 === rest)
  return [{ ...map, queries: half(0) }, turned({ ...map, queries: half(1) })]
}

/** With a row of obstacles more at its end: turned as it is, an open map would be the same map. */
function turned({ name, origin, grid, queries }: BenchMap): BenchMap {
  const { width, height } = grid
  const last = grid.walls.length - 1
  const walls = new Uint8Array(grid.walls.length + width).fill(1)
  walls.set(grid.walls.slice().reverse())
  return {
    name: `${name}, turned`,
    origin: `${origin}, turned`,
    grid: { width, height: height + 1, walls },
    queries: queries.map(({ start, goal }) => ({ start: last - start, goal: last - goal })),
  }
}
