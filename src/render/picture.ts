import type { Cell } from '../grid/grid'
import type { TapeColumns } from '../trace/tape'
import { CellCanvas } from './cell-canvas'
import { CellImage } from './cell-image'
import { dottedRows, drawGround, drawMarks, drawPlan, latestEdge } from './drawing'
import { edgeLines } from './edge-lines'
import { drawBorder, drawCells } from './layers/cells'
import { drawComparison } from './layers/comparison'
import { drawEdges } from './layers/roadmap'
import { type DeviceScreen, type Placement, placeMap } from './placement'
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
  #paintings = 0
  #edgesTape: TapeColumns | undefined
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

  /** Draws what has changed since the last time. To be called once in an animation frame. */
  draw(scene: Scene, view: View): void {
    const { grid } = scene.problem
    const box = this.#image.update(scene)
    if (box) {
      this.#cells.take(this.#image.pixels, grid, box)
      this.#paintings++
    }
    const place = placeMap(view, grid, this.#screen)
    const ground = [place.left, place.top, place.cell, grid.width, grid.height, scene.theme]
    this.#drawGround(scene, place, ground)
    this.#drawRoadmap(scene, place, ground)
    this.#drawPlan(scene, place, ground)
    this.#drawComparison(scene, place, ground)
    this.#drawMarks(scene, place, ground)
  }

  /** Takes the canvases out of the page. */
  dispose(): void {
    for (const sheet of this.#sheets()) sheet.remove()
  }

  #sheets(): Sheet[] {
    return [this.#ground, this.#roadmap, this.#plan, this.#comparison, this.#marks]
  }

  #drawGround(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    if (!this.#ground.isOutdated([...ground, this.#paintings, dottedRows(scene)])) return
    const { context } = this.#ground
    this.#ground.fill(scene.theme.outside)
    drawBorder(context, place, scene.theme)
    drawCells(context, place, this.#cells.canvas)
    drawGround(context, place, scene, this.#image.fieldRange)
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
    this.#roadmap.clear()
    drawEdges(this.#roadmap.context, place, scene.theme, this.#lines)
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
    this.#plan.clear()
    if (frame) drawPlan(this.#plan.context, place, scene.theme, frame)
  }

  #drawComparison(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const paths = scene.comparison.flatMap(({ path, style }) => [path, style])
    if (!this.#comparison.isOutdated([...ground, ...paths])) return
    this.#comparison.clear()
    drawComparison(this.#comparison.context, place, scene.theme, scene.comparison)
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
    this.#marks.clear()
    drawMarks(this.#marks.context, place, scene)
  }
}
