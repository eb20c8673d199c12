import { isLegal, isSame, isWall, type World, type XY } from './world'

export interface Field {
  readonly influence: number
  readonly repulsiveValue: number
  readonly repulsionDistance: 'euclidean' | 'manhattan'
}

/** The potential of a free cell, from all obstacle cells in the square around it. */
export function potentialAt(world: World, field: Field, [x, y]: XY): number {
  const [gx, gy] = world.goal
  const attraction = (x - gx) ** 2 + (y - gy) ** 2
  if (x === gx && y === gy) return attraction
  let closest = Number.POSITIVE_INFINITY
  for (let oy = y - field.influence; oy <= y + field.influence; oy++) {
    for (let ox = x - field.influence; ox <= x + field.influence; ox++) {
      const inside = ox >= 0 && oy >= 0 && ox < world.width && oy < world.height
      if (!inside || !isWall(world, ox, oy)) continue
      const distance =
        field.repulsionDistance === 'euclidean'
          ? Math.sqrt((x - ox) ** 2 + (y - oy) ** 2)
          : Math.abs(x - ox) + Math.abs(y - oy)
      closest = Math.min(closest, distance)
    }
  }
  return closest === Number.POSITIVE_INFINITY
    ? attraction
    : attraction + field.repulsiveValue / closest
}

export interface Descent {
  readonly status: 'reached' | 'local-minimum' | 'dead-end'
  readonly path: readonly XY[]
}

/** The agent's walk over the field, one step at a time; `memory`: never to a cell twice. */
export function descend(world: World, field: Field, memory: boolean): Descent {
  const path: XY[] = [world.start]
  for (;;) {
    const here = path[path.length - 1]
    if (isSame(here, world.goal)) return { status: 'reached', path }
    let best: XY | undefined
    let lowest = memory ? Number.POSITIVE_INFINITY : potentialAt(world, field, here)
    const [x, y] = here
    for (const nx of [x + 1, x, x - 1]) {
      for (const ny of [y - 1, y, y + 1]) {
        const next: XY = [nx, ny]
        if (!isLegal(world, here, next)) continue
        if (memory && path.some((cell) => isSame(cell, next))) continue
        const potential = potentialAt(world, field, next)
        if (potential >= lowest) continue
        lowest = potential
        best = next
      }
    }
    if (!best) return { status: memory ? 'dead-end' : 'local-minimum', path }
    path.push(best)
  }
}
