import type { Cell } from '../grid/grid'
import { KNOWN } from '../trace/frame'
import type { TapeColumns } from '../trace/tape'
import { CellCanvas } from './cell-canvas'
import { CellImage } from './cell-image'
import { edgeLines } from './edge-lines'
import { drawHits, drawLeaves } from './layers/boundary-points'
import { drawCells } from './layers/cells'
import { drawCursor } from './layers/cursor'
import { drawEnds } from './layers/ends'
import { drawFelt } from './layers/felt'
import { drawLines } from './layers/lines'
import { drawMLine } from './layers/m-line'
import { drawPotentials } from './layers/potentials'
import { drawRims } from './layers/rims'
import { drawEdges, drawVertices } from './layers/roadmap'
import { drawRoute } from './layers/route'
import { drawRover, drawSensedSquare, headingOf } from './layers/rover'
import { drawTarget } from './layers/target'
import { type DeviceScreen, type Placement, placeMap } from './placement'
import { hasRover, planOnMap, type Scene } from './scene'
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
    this.#drawMarks(scene, place, ground)
  }

  /** Takes the canvases out of the page. */
  dispose(): void {
    for (const sheet of this.#sheets()) sheet.remove()
  }

  #sheets(): Sheet[] {
    return [this.#ground, this.#roadmap, this.#plan, this.#marks]
  }

  #drawGround(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    if (!this.#ground.isOutdated([...ground, this.#paintings])) return
    const { theme, problem } = scene
    const { context } = this.#ground
    const frame = planOnMap(scene)?.frame
    const isSeen = (cell: Cell) => !hasRover(scene) || frame?.known[cell] === KNOWN.obstacle
    this.#ground.fill(theme.outside)
    drawCells(context, place, theme, this.#cells.canvas)
    drawLines(context, place, theme)
    drawRims(context, place, problem.grid, (cell) => (isSeen(cell) ? theme.rim : theme.unsensedRim))
    if (frame) drawFelt(context, place, theme, problem.grid, frame.felt)
    const { fieldRange } = this.#image
    const field = frame?.field && frame.fields[frame.field]
    if (field && fieldRange) {
      drawPotentials(context, place, theme, problem.grid, field, fieldRange)
    }
  }

  #drawRoadmap(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const plan = planOnMap(scene)
    const edges = plan?.frame.edges ?? []
    if (plan?.tape !== this.#edgesTape || edges.length !== this.#edges) {
      this.#edgesTape = plan?.tape
      this.#edges = edges.length
      this.#lines = edges.length > 0 ? edgeLines(place.columns, place.rows, edges) : []
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
    const { context } = this.#plan
    const { theme } = scene
    this.#plan.clear()
    if (!frame) return
    drawVertices(context, place, theme, frame.vertices)
    drawMLine(context, place, theme, frame.mLine)
    drawRoute(context, place, theme, frame.trail)
    drawRoute(context, place, theme, frame.path)
    drawHits(context, place, theme, frame.hits)
    drawLeaves(context, place, theme, frame.leaves)
  }

  #drawMarks(scene: Scene, place: Placement, ground: readonly unknown[]): void {
    const { problem, theme, cursor } = scene
    const frame = planOnMap(scene)?.frame
    const rover = frame?.rover ?? -1
    const target = frame?.target ?? -1
    const heading = frame ? headingOf(problem.grid.width, frame.trail, problem.goal) : 0
    const range = scene.sensorRange
    const inputs = [problem.start, problem.goal, cursor, rover, target, heading, range]
    if (!this.#marks.isOutdated([...ground, ...inputs])) return
    const { context } = this.#marks
    this.#marks.clear()
    if (rover >= 0 && range > 0) drawSensedSquare(context, place, theme, rover, range)
    drawEnds(context, place, theme, problem, rover)
    if (rover >= 0) {
      if (target >= 0 && target !== rover) drawTarget(context, place, theme, rover, target)
      drawRover(context, place, theme, rover, heading)
    }
    if (cursor >= 0) drawCursor(context, place, theme, cursor)
  }
}
