import createGraph, { type Graph } from 'ngraph.graph'
import { aStar, nba, type PathFinder } from 'ngraph.path'
import type { Cell, Grid } from '../../../src/grid/grid'
import { isLegalStep } from '../plain/steps'
import type { Peer } from './peer'

/** Where a cell lies: the data of a node, so that distances need no division. */
interface Place {
  readonly x: number
  readonly y: number
}

type CellGraph = Graph<Place, undefined>
type Finder = (graph: CellGraph) => PathFinder<Place>

const octile = ({ data: a }: { data: Place }, { data: b }: { data: Place }): number => {
  const dx = Math.abs(a.x - b.x)
  const dy = Math.abs(a.y - b.y)
  return dx < dy ? dy + (Math.SQRT2 - 1) * dx : dx + (Math.SQRT2 - 1) * dy
}
const options = { distance: octile, heuristic: octile }

/** The free cells as nodes, joined by legal steps. Its search takes links in both directions. */
function graphOf(grid: Grid): CellGraph {
  const { width, height, walls } = grid
  const graph: CellGraph = createGraph()
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (!walls[y * width + x]) graph.addNode(y * width + x, { x, y })
    }
  }
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (walls[y * width + x]) continue
      for (const [nextX, nextY] of [
        [x + 1, y],
        [x - 1, y + 1],
        [x, y + 1],
        [x + 1, y + 1],
      ]) {
        if (!isLegalStep(grid, x, y, nextX, nextY)) continue
        graph.addLink(y * width + x, nextY * width + nextX)
      }
    }
  }
  return graph
}

/** Unlike a grid of pathfinding's, its graph serves any number of queries. */
function kept(name: string, finder: Finder): Peer {
  const on = (grid: Grid) => {
    const search = finder(graphOf(grid))
    return (start: Cell, goal: Cell) => cellsOf(search, start, goal)
  }
  return { name: `ngraph.path ${name}, graph kept`, on }
}

/** The graph made of the walls for each query, as our own planners do. */
function built(name: string, finder: Finder): Peer {
  const on = (grid: Grid) => (start: Cell, goal: Cell) =>
    cellsOf(finder(graphOf(grid)), start, goal)
  return { name: `ngraph.path ${name}, graph built`, on }
}

function cellsOf(search: PathFinder<Place>, start: Cell, goal: Cell): readonly Cell[] {
  return search
    .find(start, goal)
    .map(({ id }) => Number(id))
    .reverse()
}

export const ngraphAStar = kept('aStar', (graph) => aStar(graph, options))
export const ngraphAStarBuilt = built('aStar', (graph) => aStar(graph, options))
export const ngraphNba = kept('nba', (graph) => nba(graph, options))
