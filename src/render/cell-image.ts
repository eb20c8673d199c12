import { editedCells } from '../grid/edits'
import { type Cell, isSameSize, type Size } from '../grid/grid'
import type { Field, Frame } from '../trace/frame'
import type { Tape } from '../trace/tape'
import { type Box, GrowingBox } from './box'
import { cellColours } from './cell-colour'
import { type FieldRange, fieldRange, heatPixels } from './heat'
import { type CellStates, paintBox, paintEdits, paintEvents } from './paint-cells'
import { planOnMap, type Scene, type Sight, sightOf } from './scene'
import type { Theme } from './theme'
import { type Tiling, tileAt, tilingOf } from './tiling'

/** What an image was painted from. The frame is not kept, because playing goes on changing it. */
interface Painted extends Size {
  readonly walls: Uint8Array
  readonly theme: Theme
  readonly tape: Tape | null
  readonly time: number
  readonly sight: Sight
  /** The field on show. */
  readonly field: Field | null
}

function paintedFrom(scene: Scene): Painted {
  const { width, height, walls } = scene.problem.grid
  const { theme } = scene
  const plan = planOnMap(scene)
  const tape = plan?.tape ?? null
  const time = plan?.frame.time ?? 0
  const field = scene.showPotential && plan ? plan.frame.field : null
  return { width, height, walls, theme, tape, time, sight: sightOf(scene), field }
}

/** With more events than this for each cell of the map, it is quicker to paint the whole map. */
const MOST_EVENTS = 0.125

/** A map that differs from the last one in more cells than this is another map, and no edit. */
const MOST_EDITED = 2 ** 16

/** Some events of a tape, up to `to`. */
interface Stretch {
  readonly tape: Tape
  readonly from: number
  readonly to: number
}

/**
 * The events whose cells may look different now, apart from edited walls. On the same tape these are
 * the events between the two moments; if another plan has come, all events of both up to then. `null`
 * if other cells may look different too, or if there are too many events.
 */
function eventsBetween(before: Painted, now: Painted): readonly Stretch[] | null {
  const isSameKind =
    now.theme === before.theme && now.sight === before.sight && now.field === before.field
  const [from, to] = [Math.min(before.time, now.time), Math.max(before.time, now.time)]
  const stretches =
    now.tape === before.tape
      ? [{ tape: now.tape, from, to }]
      : [before, now].map(({ tape, time }) => ({ tape, from: 0, to: time }))
  // Each field has colours of its own on each tape.
  if (!isSameKind || (now.field && now.tape !== before.tape)) return null
  const count = stretches.reduce((sum, stretch) => sum + stretch.to - stretch.from, 0)
  if (count > Math.max(1024, MOST_EVENTS * now.width * now.height)) return null
  return stretches.flatMap(({ tape, ...rest }) => (tape ? [{ tape, ...rest }] : []))
}

/** What comes first, and what may wait, when an image is brought up to date a part at a time. */
export interface Priorities {
  /** Whether a part of the map is on screen: those parts come first. */
  isInView(box: Box): boolean
  /** Whether what is left has to wait for the next time. */
  isTimeUp(): boolean
}

const ALL_AT_ONCE: Priorities = { isInView: () => true, isTimeUp: () => false }

/**
 * The map as an image with one pixel a cell. It remembers what it shows and paints only what has
 * changed: the cells of events since then, and of walls that were edited. Where everything has
 * changed, it paints tile by tile, so that it can stop when the time is up.
 */
export class CellImage {
  pixels = new Uint32Array(0)
  /** Range of the field on show; `null` if none is. */
  fieldRange: FieldRange | null = null
  #painted: Painted | null = null
  #colours: Uint32Array | null = null
  #tiling: Tiling = { columns: 0, boxes: [] }
  /** Tiles that show something older than the others. */
  readonly #late = new Set<number>()
  #fresh: readonly GrowingBox[] = []

  /** Whether all of it shows the latest scene. */
  get isComplete(): boolean {
    return this.#late.size === 0
  }

  /**
   * Brings the image up to date with the scene; edited cells at once, however little time there is,
   * unless they are very many.
   * @returns the cells it painted: one box for each tile where it painted any
   */
  update(scene: Scene, priorities = ALL_AT_ONCE): readonly Box[] {
    const before = this.#painted
    const now = paintedFrom(scene)
    this.#painted = now
    const states = this.#statesOf(now, before, planOnMap(scene)?.frame ?? null)
    for (const box of this.#fresh) box.clear()
    if (!before || !isSameSize(before, now)) this.#begin(now)
    else this.#paintNew(before, now, states)
    this.#paintLate(states, priorities)
    return this.#fresh.filter((box) => !box.isEmpty)
  }

  #statesOf(now: Painted, before: Painted | null, frame: Frame | null): CellStates {
    const { width, walls, sight, theme, tape, field } = now
    if (!this.#colours || theme !== before?.theme || sight !== before.sight) {
      this.#colours = cellColours(theme, sight)
    }
    if (tape !== before?.tape || field !== before.field) {
      this.fieldRange = tape && field ? fieldRange(tape, field) : null
    }
    const heat = this.fieldRange && { range: this.fieldRange, pixels: heatPixels(theme) }
    return { width, walls, frame, sight, heat, colours: this.#colours }
  }

  #begin(now: Painted): void {
    const cells = now.width * now.height
    if (this.pixels.length !== cells) this.pixels = new Uint32Array(cells)
    this.#tiling = tilingOf(now)
    this.#fresh = this.#tiling.boxes.map(() => new GrowingBox())
    this.#allAreLate()
  }

  #allAreLate(): void {
    this.#tiling.boxes.forEach((_, tile) => {
      this.#late.add(tile)
    })
  }

  #paintNew(before: Painted, now: Painted, states: CellStates): void {
    const painted = (cell: Cell) => {
      const x = cell % now.width
      const y = (cell - x) / now.width
      this.#fresh[tileAt(this.#tiling, x, y)].include(x, y)
    }
    const stretches = eventsBetween(before, now)
    if (!stretches) this.#allAreLate()
    for (const { tape, from, to } of stretches ?? []) {
      paintEvents(this.pixels, states, tape, from, to, painted)
    }
    if (now.walls === before.walls) return
    const edited = editedCells(before.walls, now.walls, MOST_EDITED)
    if (edited.length > MOST_EDITED) this.#allAreLate()
    else paintEdits(this.pixels, states, before.walls, edited, painted)
  }

  #paintLate(states: CellStates, { isInView, isTimeUp }: Priorities): void {
    const { boxes } = this.#tiling
    const late = [...this.#late]
    const inView = late.filter((tile) => isInView(boxes[tile]))
    const others = late.filter((tile) => !inView.includes(tile))
    for (const tile of [...inView, ...others]) {
      if (isTimeUp()) return
      paintBox(this.pixels, states, boxes[tile])
      this.#fresh[tile].includeBox(boxes[tile])
      this.#late.delete(tile)
    }
  }
}
