import EasyStar from 'easystarjs'
import type { Cell, Grid } from '../../../src/grid/grid'
import type { Peer } from './peer'

/** Its grid is an array of rows, which serves any number of queries. */
export const easystar: Peer = {
  name: 'easystarjs',
  on({ width, height, walls }: Grid) {
    const finder = new EasyStar.js()
    const rows = Array.from({ length: height }, (_, y) =>
      Array.from(walls.subarray(y * width, y * width + width)),
    )
    finder.setGrid(rows)
    finder.setAcceptableTiles([0])
    finder.enableDiagonals()
    finder.disableCornerCutting()
    finder.enableSync()
    return (start: Cell, goal: Cell) => {
      let found: readonly Cell[] = []
      const [x, y] = [start % width, goal % width]
      finder.findPath(x, (start - x) / width, y, (goal - y) / width, (path) => {
        found = (path ?? []).map((place) => place.y * width + place.x)
      })
      finder.calculate()
      return found
    }
  },
}
