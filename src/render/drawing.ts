import type { Cell } from '../grid/grid'
import { KNOWN } from '../trace/cell-state'
import { EVENT } from '../trace/events'
import { type CellList, type Cells, type Frame, knownOf } from '../trace/frame'
import type { FieldRange } from './heat'
import { knownGrid } from './known-obstacles'
import { drawHits, drawLeaves } from './layers/boundary-points'
import { drawCornerTest } from './layers/corner-test'
import { drawCursor, drawHovered } from './layers/cursor'
import { drawEnds } from './layers/ends'
import { drawFelt } from './layers/felt'
import { drawAtSide, drawRail, railAngle } from './layers/following'
import { drawLines } from './layers/lines'
import { drawMLine } from './layers/m-line'
import { drawPotentials } from './layers/potentials'
import { drawRims } from './layers/rims'
import { drawVertices } from './layers/roadmap'
import { drawRoute } from './layers/route'
import { drawRover, drawSensedSquare, headingOf } from './layers/rover'
import { DOTS_FROM, drawRowDots } from './layers/row-dots'
import { drawTangentGraph } from './layers/tangent-graph'
import { drawTarget } from './layers/target'
import { drawLatestEdge, drawRefusal } from './layers/tried-edges'
import type { Pen } from './pen'
import { cellsAreAtLeast, type Placement } from './placement'
import { planOnMap, type Scene, sightOf } from './scene'
import type { Theme } from './theme'
import { LINES_FROM } from './view'

/** Smaller cells have their colour and nothing else. */
const DETAILS_FROM = Math.min(DOTS_FROM, LINES_FROM)

/**
 * What lies directly upon the cells.
 * @param range that of the field on show; `null` if none is
 */
export function drawGround(
  pen: Pen,
  place: Placement,
  scene: Scene,
  range: FieldRange | null,
): void {
  if (!cellsAreAtLeast(place, DETAILS_FROM)) return
  const { theme, problem } = scene
  const frame = planOnMap(scene)?.frame
  const sight = sightOf(scene)
  const isVeiled = (cell: Cell) =>
    sight !== 'world' && frame !== undefined && knownOf(frame, cell) !== KNOWN.obstacle
  const grid = frame && sight === 'known' ? knownGrid(problem.grid, frame, place) : problem.grid
  drawLines(pen, place, theme)
  drawRims(pen, place, grid, (cell) => (isVeiled(cell) ? theme.unsensedRim : theme.rim))
  if (!frame) return
  drawFelt(pen, place, theme, grid, frame)
  drawRowDots(pen, place, theme, grid, dottedRows(scene))
  const field = frame.field && frame.fields[frame.field]
  if (field && range) drawPotentials(pen, place, theme, grid, field, range)
}

/** How many rows have dots: those made vertices, until the search goes on to colour them. */
export function dottedRows(scene: Scene): number {
  const frame = planOnMap(scene)?.frame
  return frame?.phase === 0 ? frame.rows : 0
}

/** What a plan leaves behind, from the first of its vertices to the path. */
export function drawPlan(
  pen: Pen,
  place: Placement,
  theme: Theme,
  frame: Frame,
  vertices: Cells,
): void {
  drawVertices(pen, place, theme, vertices)
  drawMLine(pen, place, theme, frame.mLine)
  drawRoute(pen, place, theme, frame.trail)
  drawRoute(pen, place, theme, frame.path)
  drawHits(pen, place, theme, frame.hits)
  drawLeaves(pen, place, theme, frame.leaves)
}

/** The ends of the edge that was written last of all; none as soon as something else happens. */
export function latestEdge(scene: Scene): CellList {
  const plan = planOnMap(scene)
  if (!plan || plan.frame.time === 0) return []
  const { tape, frame } = plan
  return tape.kind(frame.time - 1) === EVENT.edge ? frame.edges.slice(-2) : []
}

/** What there is only at this moment, start and goal, and the cells that a person points at. */
export function drawMarks(pen: Pen, place: Placement, scene: Scene): void {
  const { problem, theme, cursor, hovered } = scene
  const frame = planOnMap(scene)?.frame
  const rover = frame?.rover ?? -1
  if (rover >= 0 && scene.sensorRange > 0) {
    drawSensedSquare(pen, place, theme, rover, scene.sensorRange)
  }
  if (frame) drawTries(pen, place, scene, frame)
  drawEnds(pen, place, theme, problem, rover)
  if (frame && rover >= 0) drawMovement(pen, place, scene, frame)
  if (hovered >= 0) drawHovered(pen, place, theme, hovered)
  if (cursor >= 0) drawCursor(pen, place, theme, cursor)
}

/** What a roadmap's planner is trying. */
function drawTries(pen: Pen, place: Placement, scene: Scene, frame: Frame): void {
  const { theme, problem } = scene
  const [from, to] = latestEdge(scene)
  if (from !== undefined) drawLatestEdge(pen, place, theme, from, to)
  if (frame.refusal) {
    drawRefusal(pen, place, theme, frame.refusal)
    // The refused path may hide some vertices. There are few: only small roadmaps have refusals.
    drawVertices(pen, place, theme, frame.vertices)
  }
  if (frame.test) drawCornerTest(pen, place, theme, problem.grid, frame.test)
}

/** The rover, what it heads for and what it follows. */
function drawMovement(pen: Pen, place: Placement, scene: Scene, frame: Frame): void {
  const { theme, problem } = scene
  const { rover, target, nodes, atSide, following, turn } = frame
  const heading = headingOf(place.columns, frame.trail, problem.goal)
  if (rover !== problem.goal) drawTangentGraph(pen, place, theme, rover, nodes)
  if (target >= 0 && target !== rover) drawTarget(pen, place, theme, rover, target)
  // A thinned tape does not tell the side on which the obstacle is.
  if (following && scene.plan?.tape.thinning === 'whole') {
    if (atSide >= 0) drawAtSide(pen, place, theme, atSide)
    drawRail(pen, place, theme, rover, railAngle(place.columns, frame, heading), turn)
  }
  drawRover(pen, place, theme, rover, heading)
}
