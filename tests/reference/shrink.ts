import type { World, XY } from './world'

const MOST_TRIES = 4000

/** A smaller map that still fails: rows and columns cut, obstacles taken away, one by one. */
export function shrink(world: World, fails: (candidate: World) => boolean): World {
  let best = world
  let tries = 0
  for (let improved = true; improved; ) {
    improved = false
    for (const candidate of smaller(best)) {
      if (++tries > MOST_TRIES) return best
      if (!fails(candidate)) continue
      best = candidate
      improved = true
      break
    }
  }
  return best
}

function* smaller(world: World): Generator<World> {
  for (let y = 0; y < world.height; y++) {
    if (world.height > 2 && y !== world.start[1] && y !== world.goal[1]) yield withoutRow(world, y)
  }
  for (let x = 0; x < world.width; x++) {
    if (world.width > 2 && x !== world.start[0] && x !== world.goal[0])
      yield withoutColumn(world, x)
  }
  for (let y = 0; y < world.height; y++) {
    for (let x = 0; x < world.width; x++) {
      if (world.rows[y][x] !== '#') continue
      const row = `${world.rows[y].slice(0, x)}.${world.rows[y].slice(x + 1)}`
      yield { ...world, rows: world.rows.map((old, i) => (i === y ? row : old)) }
    }
  }
}

function withoutRow(world: World, y: number): World {
  const moved = ([px, py]: XY): XY => [px, py > y ? py - 1 : py]
  return {
    ...world,
    height: world.height - 1,
    rows: world.rows.filter((_, i) => i !== y),
    start: moved(world.start),
    goal: moved(world.goal),
  }
}

function withoutColumn(world: World, x: number): World {
  const moved = ([px, py]: XY): XY => [px > x ? px - 1 : px, py]
  return {
    ...world,
    width: world.width - 1,
    rows: world.rows.map((row) => row.slice(0, x) + row.slice(x + 1)),
    start: moved(world.start),
    goal: moved(world.goal),
  }
}
