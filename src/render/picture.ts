import type { Box } from './box'
import { CellCanvas } from './cell-canvas'
import { CellImage } from './cell-image'
import { dottedRows, drawGround, drawMarks, drawPlan, latestEdge } from './drawing'
import { EdgeCover } from './edge-lines'
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
import { SlicedIndex } from './sliced-index'
import { VertexIndex } from './vertex-index'
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
  #hidesEdges = false
  #hidesVertices = false
  readonly #vertices = new SlicedIndex((columns, rows) => new VertexIndex(columns, rows))
  readonly #lines = new SlicedIndex((columns, rows) => new EdgeCover(columns, rows))

  constructor(host: HTMLElement) {
    this.#ground = new Sheet(host, 'ground', true)
    this.#roadmap = new Sheet(host, 'roadmap')
    this.#plan = new Sheet(host, 'plan')
    this.#comparison = new Sheet(host, 'comparison')
    this.#marks = new Sheet(host, 'marks')
  }

  /** Size of the screen in CSS pixels; the next `draw` draws everything anew. */
  resize(width: number, height: number, devicePixelRatio: number): void {
    const sheets = [this.#ground, this.#roadmap, this.#plan, this.#comparison, this.#marks]
    for (const sheet of sheets) sheet.resize(width, height, devicePixelRatio)
    this.#screen = {
      width: Math.round(width * devicePixelRatio),
      height: Math.round(height * devicePixelRatio),
      pixel: devicePixelRatio,
    }
  }

  /**
   * Draws what has changed since the last time. To be called once in an animation frame.
   * @param isTimeUp says when to leave what is not urgent to the next frame
   * @returns whether all is drawn; if not, it has to be called in the next frame too
   */
  draw(scene: Scene, view: View, isTimeUp = () => false): boolean {
    const { grid } = scene.problem
    const place = placeMap(view, grid, this.#screen)
    const isInView = (box: Box) => isBoxVisible(place, box)
    const painted = this.#image.update(scene, { isInView, isTimeUp })
    this.#cells.take(this.#image.pixels, grid, painted)
    // What all sheets are drawn from.
    const common = [place.left, place.top, place.cell, grid.width, grid.height, scene.theme]
    this.#drawGround(scene, place, common, painted.filter(isInView))
    const isIndexed = this.#indexRoadmap(scene, isTimeUp)
    this.#drawRoadmap(scene, place, common)
    this.#drawPlan(scene, place, common)
    this.#drawComparison(scene, place, common)
    this.#drawMarks(scene, place, common)
    return this.#image.isComplete && isIndexed
  }

  /** Whether vertices or edges are left out because there are too many of them on the screen. */
  get isCrowded(): boolean {
    return this.#hidesEdges || this.#hidesVertices
  }

  /** All of it, or only around the cells that were painted. */
  #drawGround(
    scene: Scene,
    place: Placement,
    common: readonly unknown[],
    painted: readonly Box[],
  ): void {
    const rows = cellsAreAtLeast(place, DOTS_FROM) ? dottedRows(scene) : 0
    const isOutdated = this.#ground.isOutdated([...common, rows])
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
    // A cell also changes the rims of its neighbours, and smoothed pixels around it.
    const margin = 1 + Math.ceil(2 / place.cell)
    for (const box of painted) {
      const part = placeOfBox(place, box, margin)
      this.#ground.within(part, () => draw(placeOfBox(place, box, margin + 1)))
    }
  }

  /** Returns whether all of the roadmap is in its indexes. */
  #indexRoadmap(scene: Scene, isTimeUp: () => boolean): boolean {
    const plan = planOnMap(scene)
    const tape = plan?.tape ?? null
    const hasVertices = this.#vertices.update(tape, plan?.frame.vertices ?? [], isTimeUp)
    const hasEdges = this.#lines.update(tape, plan?.frame.edges ?? [], isTimeUp)
    return hasVertices && hasEdges
  }

  #drawRoadmap(scene: Scene, place: Placement, common: readonly unknown[]): void {
    const { ready } = this.#lines
    if (!this.#roadmap.isOutdated([...common, ready])) return
    const inView = ready?.inView(place)
    const lines = inView ?? []
    this.#hidesEdges = inView === null
    this.#roadmap.redraw(lines.length > 0, () =>
      drawEdges(this.#roadmap.context, place, scene.theme, lines),
    )
  }

  /** Later frames of a tape have the same and more, so the counts say whether anything is new. */
  #drawPlan(scene: Scene, place: Placement, common: readonly unknown[]): void {
    const plan = planOnMap(scene)
    const frame = plan?.frame
    const { ready, readyLength } = this.#vertices
    const counts = [
      readyLength,
      frame?.mLine.length,
      frame?.trail.length,
      frame?.path.length,
      frame?.hits.length,
      frame?.leaves.length,
    ]
    if (!this.#plan.isOutdated([...common, plan?.tape, ready, ...counts])) return
    const vertices = ready?.inView(place)
    this.#hidesVertices = vertices === null
    this.#plan.redraw(counts.some(Boolean), () => {
      if (frame) drawPlan(this.#plan.context, place, scene.theme, frame, vertices ?? [])
    })
  }

  #drawComparison(scene: Scene, place: Placement, common: readonly unknown[]): void {
    const paths = scene.comparison.flatMap(({ path, style }) => [path, style])
    if (!this.#comparison.isOutdated([...common, ...paths])) return
    this.#comparison.redraw(paths.length > 0, () =>
      drawComparison(this.#comparison.context, place, scene.theme, scene.comparison),
    )
  }

  #drawMarks(scene: Scene, place: Placement, common: readonly unknown[]): void {
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
    if (!this.#marks.isOutdated([...common, ...inputs, ...lists])) return
    this.#marks.redraw(true, () => drawMarks(this.#marks.context, place, scene))
  }
}
