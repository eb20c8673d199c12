import * as v from 'valibot'
import { InputError } from '../errors'
import { describe } from '../excerpt'
import type { Grid } from '../grid'
import { plural } from '../plural'
import { checkSize } from '../problem'
import { type OpenedMap, openedWithoutEnds } from './opened-map'
import { list, readShape, whole } from './shape'

const shape = v.object({ size: v.object({ x: whole, y: whole }), wall_map: list })

const words = {
  size: 'an object with the whole numbers "x" and "y"',
  'size.x': 'a whole number',
  'size.y': 'a whole number',
  wall_map: 'a list of columns',
}

/**
 * The map in the JSON value of a file of the original Path Planner: `size: { x, y }` and
 * `wall_map[x][y]`, 1 for an obstacle. Start and goal are not in such a file.
 * @throws InputError that says which key, column or cell is wrong.
 */
export function readOriginal(value: unknown): OpenedMap {
  const { size, wall_map: columns } = readShape(shape, words, value)
  return openedWithoutEnds(gridFromColumns(size.x, size.y, columns), 'if-at-most-one-obstacle')
}

function gridFromColumns(width: number, height: number, columns: readonly unknown[]): Grid {
  checkSize(width, height)
  if (columns.length !== width) {
    throw new InputError(
      `"wall_map" has ${columns.length} ${plural(columns.length, 'column')}, but "size.x" is ${width}.`,
    )
  }
  const walls = new Uint8Array(width * height)
  columns.forEach((column: unknown, x) => {
    if (!Array.isArray(column)) {
      throw new InputError(`"wall_map" column ${x} must be a list, but is ${describe(column)}.`)
    }
    if (column.length !== height) {
      throw new InputError(
        `"wall_map" column ${x} has ${column.length} ${plural(column.length, 'cell')}, but "size.y" is ${height}.`,
      )
    }
    for (let y = 0; y < height; y++) {
      const cell: unknown = column[y]
      if (cell === 1) walls[y * width + x] = 1
      else if (cell !== 0) {
        throw new InputError(
          `"wall_map" column ${x}, cell ${y} must be 1 (obstacle) or 0 (free), but is ${describe(cell)}.`,
        )
      }
    }
  })
  return { width, height, walls }
}
