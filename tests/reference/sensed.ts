import { canSee } from './sight'
import { DIRECTIONS, isWall, steps, type World, type XY } from './world'

/** What was sensed of a world, places beyond its border included. */
export class Sensed {
  readonly #places = new Set<string>()
  readonly #world: World
  readonly #range: number
  readonly #lineOfSight: boolean

  constructor(world: World, range: number, lineOfSight: boolean) {
    this.#world = world
    this.#range = range
    this.#lineOfSight = lineOfSight
  }

  /** How many places were sensed. */
  get count(): number {
    return this.#places.size
  }

  lookFrom(from: XY): void {
    for (const place of squareAround(from, this.#range)) {
      if (!this.#lineOfSight || canSee(this.#world, from, place)) this.#places.add(String(place))
    }
  }

  has(place: XY): boolean {
    return this.#places.has(String(place))
  }

  isObstacle(place: XY): boolean {
    return this.has(place) && isWall(this.#world, place[0], place[1])
  }

  /** Whether all that was sensed says that a step is legal; a place out of sight does not. */
  allows(from: XY, to: XY): boolean {
    const [free, ...besides] = [to, ...beside(from, to)].map(
      (p) => this.has(p) && !this.isObstacle(p),
    )
    const needed =
      this.#world.rule === 'only-when-no-obstacles' ? besides.length : besides.length / 2
    return free && besides.filter((isFree) => isFree).length >= needed
  }

  /**
   * The obstacle that was sensed to refuse a step; a place out of sight refuses nothing. Where the
   * description leaves a choice: of the two beside a diagonal step the first one clockwise.
   */
  refusing(from: XY, to: XY): XY | undefined {
    if (this.isObstacle(to)) return to
    const refusing = beside(from, to).filter((place) => this.isObstacle(place))
    const needed = this.#world.rule === 'only-when-no-obstacles' ? 1 : 2
    return refusing.length >= needed ? refusing[0] : undefined
  }

  /**
   * The obstacle cells of the square around a place that hang together with one, corners included: as
   * a flood meets them, clockwise from north.
   */
  obstacle(around: XY, seed: XY): XY[] {
    const found: XY[] = [seed]
    const seen = new Set([String(seed)])
    for (const cell of found) {
      for (const [dx, dy] of DIRECTIONS) {
        const next: XY = [cell[0] + dx, cell[1] + dy]
        const isIn = steps(around, next) <= this.#range && this.isObstacle(next)
        if (!isIn || seen.has(String(next))) continue
        seen.add(String(next))
        found.push(next)
      }
    }
    return found
  }
}

/** The two cells beside a diagonal step, in clockwise order; none beside a straight one. */
function beside([x, y]: XY, [nx, ny]: XY): XY[] {
  if (x === nx || y === ny) return []
  const sides: XY[] = [
    [nx, y],
    [x, ny],
  ]
  return (nx - x) * (ny - y) > 0 ? sides : sides.reverse()
}

function squareAround([x, y]: XY, range: number): XY[] {
  const places: XY[] = []
  for (let py = y - range; py <= y + range; py++) {
    for (let px = x - range; px <= x + range; px++) places.push([px, py])
  }
  return places
}
