import type { Field } from '../trace/frame'
import type { TapeColumns } from '../trace/tape'
import { type CellPalette, cellPalette } from './cell-colour'
import { type FieldRange, fieldRange } from './heat'
import { type Box, emptyBox, paintCells, paintEdits, paintEvents } from './paint-cells'
import { planOnMap, type Scene, type Sight, sightOf } from './scene'
import type { Theme } from './theme'

/** What an image was painted from. The frame is not kept: it changes under the same name. */
interface Painted {
  readonly width: number
  readonly height: number
  readonly walls: Uint8Array
  readonly theme: Theme
  readonly tape: TapeColumns | null
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

/** Whether `now` differs from `before` only by later events and edited walls. */
function onlyAdds(before: Painted, now: Painted): boolean {
  return (
    now.width === before.width &&
    now.height === before.height &&
    now.theme === before.theme &&
    now.tape === before.tape &&
    now.time >= before.time &&
    now.sight === before.sight &&
    now.field === before.field
  )
}

/**
 * The map as an image with one pixel a cell. It remembers what it shows and paints only what is
 * new: the cells of events that came since, and of walls that were edited.
 */
export class CellImage {
  pixels = new Uint32Array(0)
  /** Range of the field on show; `null` if none is. */
  fieldRange: FieldRange | null = null
  #painted: Painted | null = null
  #palette: CellPalette | null = null

  /** Brings the image up to the scene. Says which cells it painted; `null` if none. */
  update(scene: Scene): Box | null {
    const before = this.#painted
    const now = paintedFrom(scene)
    this.#painted = now
    if (!this.#palette || now.theme !== before?.theme) this.#palette = cellPalette(now.theme)
    if (now.tape !== before?.tape || now.field !== before.field) {
      this.fieldRange = now.tape && now.field ? fieldRange(now.tape, now.field) : null
    }
    const states = {
      walls: now.walls,
      frame: planOnMap(scene)?.frame ?? null,
      sight: now.sight,
      fieldRange: this.fieldRange,
    }

    if (!before || !onlyAdds(before, now)) {
      const cells = now.width * now.height
      if (this.pixels.length !== cells) this.pixels = new Uint32Array(cells)
      paintCells(this.pixels, states, this.#palette)
      return { left: 0, top: 0, right: now.width, bottom: now.height }
    }
    const box = emptyBox()
    if (now.tape && now.time > before.time) {
      paintEvents(this.pixels, states, this.#palette, now.tape, before.time, now.time, box)
    }
    if (now.walls !== before.walls) {
      paintEdits(this.pixels, states, this.#palette, before.walls, now.width, box)
    }
    return box.right > 0 ? box : null
  }
}
