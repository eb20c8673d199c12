import { Dice } from './random'
import type { Rule, World, XY } from './world'

/** The kinds of maps, in turn: map number i is of kind i modulo their number. */
const KINDS = [randomCells, blocks, hollowRooms, maze, wallsOnBorder, nestedSpirals] as const

type Signs = string[][]

/** Map number `index` of the endless list `seed`: the same numbers always give the same map. */
export function mapNumber(seed: number, index: number, rule: Rule): World {
  const dice = new Dice(seed, index)
  const width = side(dice)
  const height = dice.onceIn(4) ? width : side(dice)
  const signs: Signs = Array.from({ length: height }, () => Array<string>(width).fill('.'))
  KINDS[index % KINDS.length](signs, dice)
  const start = freePlace(signs, dice)
  const goal = dice.onceIn(25) ? start : farPlace(signs, dice, start)
  if (dice.onceIn(10)) wallIn(signs, dice, goal)
  signs[start[1]][start[0]] = '.'
  signs[goal[1]][goal[0]] = '.'
  return { width, height, rows: signs.map((row) => row.join('')), start, goal, rule }
}

/** From 2 to 40, most of them small; one map in ten has any size alike. */
function side(dice: Dice): number {
  if (dice.onceIn(10)) return dice.between(2, 40)
  const most = dice.between(2, 24)
  return dice.between(2, most)
}

function set(signs: Signs, x: number, y: number, sign: string): void {
  if (y >= 0 && y < signs.length && x >= 0 && x < signs[0].length) signs[y][x] = sign
}

/** From 5 to 45 % of the cells. */
function randomCells(signs: Signs, dice: Dice): void {
  const percent = dice.between(5, 45)
  for (const row of signs) {
    for (let x = 0; x < row.length; x++) if (dice.below(100) < percent) row[x] = '#'
  }
}

function rectangle(
  signs: Signs,
  dice: Dice,
): [x: number, y: number, right: number, bottom: number] {
  const x = dice.between(-1, signs[0].length - 1)
  const y = dice.between(-1, signs.length - 1)
  const most = 2 + Math.floor(Math.max(signs.length, signs[0].length) / 3)
  return [x, y, x + dice.between(0, most), y + dice.between(0, most)]
}

function blocks(signs: Signs, dice: Dice): void {
  const count = dice.between(1, 2 + Math.floor((signs.length + signs[0].length) / 5))
  for (let i = 0; i < count; i++) {
    const [left, top, right, bottom] = rectangle(signs, dice)
    for (let y = top; y <= bottom; y++) for (let x = left; x <= right; x++) set(signs, x, y, '#')
  }
}

/** Rooms one within and across another, with up to three doors each. */
function hollowRooms(signs: Signs, dice: Dice): void {
  const count = dice.between(1, 2 + Math.floor((signs.length + signs[0].length) / 6))
  for (let i = 0; i < count; i++) {
    const [left, top, right, bottom] = rectangle(signs, dice)
    const wall: XY[] = []
    for (let y = top; y <= bottom; y++) {
      for (let x = left; x <= right; x++) {
        if (y === top || y === bottom || x === left || x === right) wall.push([x, y])
      }
    }
    for (const [x, y] of wall) set(signs, x, y, '#')
    for (let doors = dice.below(4); doors > 0; doors--) {
      const [x, y] = dice.pick(wall)
      set(signs, x, y, '.')
    }
  }
}

/** Corridors one cell wide, carved by a walk that backs up; sometimes a few walls more opened. */
function maze(signs: Signs, dice: Dice): void {
  for (const row of signs) row.fill('#')
  const height = signs.length
  const width = signs[0].length
  const way: XY[] = [[dice.below(width), dice.below(height)]]
  signs[way[0][1]][way[0][0]] = '.'
  while (way.length > 0) {
    const [x, y] = way[way.length - 1]
    const onward: XY[] = []
    for (const [dx, dy] of [
      [2, 0],
      [-2, 0],
      [0, 2],
      [0, -2],
    ]) {
      if (signs[y + dy]?.[x + dx] === '#') onward.push([dx, dy])
    }
    if (onward.length === 0) {
      way.pop()
      continue
    }
    const [dx, dy] = dice.pick(onward)
    set(signs, x + dx / 2, y + dy / 2, '.')
    set(signs, x + dx, y + dy, '.')
    way.push([x + dx, y + dy])
  }
  for (let holes = dice.below(6); holes > 0; holes--) {
    set(signs, dice.below(width), dice.below(height), '.')
  }
}

/** Obstacles along the border and a few inside. */
function wallsOnBorder(signs: Signs, dice: Dice): void {
  const border = dice.between(20, 100)
  const inside = dice.between(0, 25)
  signs.forEach((row, y) => {
    for (let x = 0; x < row.length; x++) {
      const outer = x === 0 || y === 0 || x === row.length - 1 || y === signs.length - 1
      if (dice.below(100) < (outer ? border : inside)) row[x] = '#'
    }
  })
}

/** Rings with one gap each, one inside another: long ways round for the Bugs. */
function nestedSpirals(signs: Signs, dice: Dice): void {
  const gap = dice.between(2, 4)
  const first = dice.below(2)
  for (let ring = first; ; ring += gap) {
    const right = signs[0].length - 1 - ring
    const bottom = signs.length - 1 - ring
    if (right <= ring || bottom <= ring) break
    const wall: XY[] = []
    for (let x = ring; x <= right; x++) wall.push([x, ring], [x, bottom])
    for (let y = ring; y <= bottom; y++) wall.push([ring, y], [right, y])
    for (const [x, y] of wall) set(signs, x, y, '#')
    for (let doors = dice.between(1, 2); doors > 0; doors--) {
      const [x, y] = dice.pick(wall)
      set(signs, x, y, '.')
    }
  }
  for (let more = dice.below(5); more > 0; more--) {
    set(signs, dice.below(signs[0].length), dice.below(signs.length), dice.pick(['#', '.']))
  }
}

function freePlace(signs: Signs, dice: Dice): XY {
  for (let tries = 0; tries < 50; tries++) {
    const place: XY = [dice.below(signs[0].length), dice.below(signs.length)]
    if (signs[place[1]][place[0]] === '.') return place
  }
  return [dice.below(signs[0].length), dice.below(signs.length)]
}

/** The farthest of a few places, so that most ways are long enough to go wrong. */
function farPlace(signs: Signs, dice: Dice, from: XY): XY {
  const far = ([x, y]: XY) => Math.max(Math.abs(x - from[0]), Math.abs(y - from[1]))
  let best = freePlace(signs, dice)
  for (let more = dice.below(3); more > 0; more--) {
    const other = freePlace(signs, dice)
    if (far(other) > far(best)) best = other
  }
  return best
}

/** Obstacles all around, next to the place or with some room inside. */
function wallIn(signs: Signs, dice: Dice, [x, y]: XY): void {
  const room = dice.between(1, 3)
  const corners = dice.onceIn(2)
  for (let dy = -room; dy <= room; dy++) {
    for (let dx = -room; dx <= room; dx++) {
      const outer = Math.max(Math.abs(dx), Math.abs(dy)) === room
      const corner = Math.abs(dx) === room && Math.abs(dy) === room
      if (outer && (corners || !corner)) set(signs, x + dx, y + dy, '#')
    }
  }
}
