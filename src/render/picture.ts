import type { Cell } from '../grid/grid'
import type { Tape } from '../trace/tape'
import type { Box } from './box'
import { CellCanvas } from './cell-canvas'
import { CellImage } from './cell-image'
import { dottedRows, drawGround, drawMarks, drawPlan, latestEdge } from './drawing'
import { edgeLines } from './edge-lines'
import { drawBorder } from './layers/border'
import { drawComparison } from './layers/comparison'
import { drawEdges } from './layers/roadmap'
import { DOTS_FROM } from './layers/row-dots'
import {
  cellsAreAtLeast,
  type DeviceScreen,
  isBoxVisible,
  type Placement,
  placeMap,
  placeOfBox,
} from './placement'
import { planOnMap, type Scene } from './scene'
import { Sheet } from './sheet'
import type { View } from './view'

/**
 * The picture of the map: canvases one upon the other inside an element that is positioned and as
 * large as the screen. It shows a scene, knows nothing else and changes nothing.
 */
export class Picture {
  readonly #image = new CellImage()
  readonly #cells = new CellCanvas()
  readonly #ground: Sheet
  readonly #roadmap: Sheet
  readonly #plan: Sheet
  readonly #comparison: Sheet
  readonly #marks: Sheet
  #screen: DeviceScreen = { width: 0, height: 0, pixel: 1 }
  #edgesTape: Tape | undefined
  #edges = 0
  #lines: readonly Cell[] = []

  constructor(host: HTMLElement) {
    this.#ground = new Sheet(host, 'ground')
    this.#roadmap = new Sheet(host, 'roadmap')
    this.#plan = new Sheet(host, 'plan')
    this.#comparison = new Sheet(host, 'comparison')
    this.#marks = new Sheet(host, 'marks')
  }

  /** Size of the screen in CSS pixels; the next `draw` draws everything anew. */
  resize(width: number, height: number, devicePixelRatio: number): void {
    for (const sheet of this.#sheets()) sheet.resize(width, height, devicePixelRatio)
    this.#screen = {
      width: Math.round(width * devicePixelRatio),
      height: Math.round(height * devicePixelRatio),
      pixel: devicePixelRatio,
    }
  }

  /**
   * Draws what has changed since the last time, in as much time as there is in a frame. To be called
   * once in an animation frame, and in the next one as well if it returns that not all is drawn yet.
   */
  draw(scene: Scene, view: View, isTimeUp = () => false): boolean {
    const { grid } = scene.problem
    const place = placeMap(view, grid, this.#screen)
    const isInView = (box: Box) => isBoxVisible(place, box)
    const painted = this.#image.update(scene, { isInView, isTimeUp })
    this.#cells.take(this.#image.pixels, grid, painted)
    const ground = [place.left, place.top, place.cell, grid.width, grid.height, scene.theme]
    this.#drawGround(scene, place, ground, painted.filter(isInView))
    this.#drawRoadmap(scene, place, ground)
    this.#drawPlan(scene, place, ground)
    this.#drawComparison(scene, place, ground)
    this.#drawMarks(scene, place, ground)
    return this.#image.isComplete
  }

  /** Takes the canvases out of the page. */
  dispose(): void {
    for (const sheet of this.#sheets()) sheet.remove()
  }

  #sheets(): Sheet[] {
    return [this.#ground, this.#roadmap, this.#plan, this.#comparison, this.#marks]
  }

  /** All of it, or only around the cells that were painted. */
  #drawGround(
    scene: Scene,
    place: Placement,
    ground: readonly unknown[],
    painted: readonly Box[],
  ): void {
    const rows = cellsAreAtLeast(place, DOTS_FROM) ? dottedRows(scene) : 0
    const isOutdated = this.#ground.isOutdated([...ground, rows])
    if (!isOutdated && painted.length === 0) return
    const range = this.#image.fieldRange
    const draw = (part: Placement) => {
      this.#ground.fill(scene.theme.outside)
      drawBorder(this.#ground.context, place, scene.theme)
      this.#cells.draw(this.#ground.context, place, part)
      drawGround(this.#ground.context, part, scene, range)
    }
    if (isOutdated) {
      draw(place)
      return
    }
    // What a cell looks like can be seen in the pixels and the rims around it.
    const margin = 1 + Math.ceil(2 / place.cell)
    for (const box of painted) {
      const part = placeOfBox(place, box, margin)
      this.#ground.within(part, () => draw(placeOfBox(place, box, margin + 1)))
    }
  }

  #drawRoadmap(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const plan = planOnMap(scene)
    const edges = plan?.frame.edges ?? []
    if (plan?.tape !== this.#edgesTape || edges.length !== this.#edges) {
      this.#edgesTape = plan?.tape
      this.#edges = edges.length
      this.#lines = edgeLines(place.columns, place.rows, edges)
    }
    if (!this.#roadmap.isOutdated([...ground, this.#lines])) return
    this.#roadmap.redraw(this.#lines.length > 0, () =>
      drawEdges(this.#roadmap.context, place, scene.theme, this.#lines),
    )
  }

  /** Later frames of a tape only have more of everything, so the counts tell what is drawn. */
  #drawPlan(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const plan = planOnMap(scene)
    const frame = plan?.frame
    const counts = [
      frame?.vertices.length,
      frame?.mLine.length,
      frame?.trail.length,
      frame?.path.length,
      frame?.hits.length,
      frame?.leaves.length,
    ]
    if (!this.#plan.isOutdated([...ground, plan?.tape, ...counts])) return
    this.#plan.redraw(counts.some(Boolean), () => {
      if (frame) drawPlan(this.#plan.context, place, scene.theme, frame)
    })
  }

  #drawComparison(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const paths = scene.comparison.flatMap(({ path, style }) => [path, style])
    if (!this.#comparison.isOutdated([...ground, ...paths])) return
    this.#comparison.redraw(paths.length > 0, () =>
      drawComparison(this.#comparison.context, place, scene.theme, scene.comparison),
    )
  }

  #drawMarks(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const { start, goal } = scene.problem
    const plan = planOnMap(scene)
    const frame = plan?.frame
    const inputs = [
      plan?.tape,
      start,
      goal,
      scene.cursor,
      scene.hovered,
      scene.sensorRange,
      frame?.trail.length,
      frame?.rover,
      frame?.target,
      frame?.following,
      frame?.atSide,
      frame?.turn,
      frame?.test,
      frame?.refusal,
    ]
    const lists = [...latestEdge(scene), null, ...(frame?.nodes ?? [])]
    if (!this.#marks.isOutdated([...ground, ...inputs, ...lists])) return
    this.#marks.redraw(true, () => drawMarks(this.#marks.context, place, scene))
  }
}
