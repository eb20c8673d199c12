import { isDiagonal } from '../../grid/directions'
import type { DiagonalRule, Directions } from '../../grid/steps'

/** Stands for the direction of the start, to which no step led. */
export const NO_DIRECTION = 8

const tables: Partial<Record<DiagonalRule, Uint8Array>> = {}

/**
 * The neighbours to which a cell must offer a way, by the direction of the step that led to the cell
 * and by its legal steps: at `direction << 8 | legal` a set of directions.
 *
 * Left out are neighbours that the cell before reaches as cheaply without this one. So of all orders
 * of the same steps only one is followed, the canonical one, diagonal steps first, and nearly every
 * cell is reached only once. That holds for every weight of a diagonal step between 1 and 2; an
 * obstacle beside the way brings back the neighbours that it hides from the cell before.
 * (D. Harabor and A. Grastien, "Online graph pruning for pathfinding on grid maps", 2011.)
 */
export function successorsUnder(rule: DiagonalRule): Uint8Array {
  tables[rule] ??= successors(rule === 'only-when-no-obstacles')
  return tables[rule]
}

function successors(cornersBlock: boolean): Uint8Array {
  const table = new Uint8Array((NO_DIRECTION + 1) << 8)
  for (let legal = 0; legal < 256; legal++) {
    for (let d = 0; d < 8; d++) {
      const wanted = isDiagonal(d) ? afterDiagonal(d, legal) : afterStraight(d, legal, cornersBlock)
      table[(d << 8) | legal] = wanted & legal
    }
    table[(NO_DIRECTION << 8) | legal] = legal
  }
  return table
}

function bit(direction: number): Directions {
  return 1 << (direction & 7)
}

/** Onward, to both sides of that, and back around an obstacle beside the cell before. */
function afterDiagonal(d: number, legal: Directions): Directions {
  let wanted = bit(d) | bit(d - 1) | bit(d + 1)
  for (const side of [-1, 1]) if ((legal & bit(d + 3 * side)) === 0) wanted |= bit(d + 2 * side)
  return wanted
}

/**
 * Onward; to a side only if the cell before could not turn there diagonally: because of an obstacle
 * beside this cell, or, where corners block, beside the cell before.
 */
function afterStraight(d: number, legal: Directions, cornersBlock: boolean): Directions {
  let wanted = bit(d)
  for (const side of [-1, 1]) {
    if ((legal & bit(d + 2 * side)) === 0) wanted |= bit(d + side)
    else if (cornersBlock && (legal & bit(d + 3 * side)) === 0) {
      wanted |= bit(d + side) | bit(d + 2 * side)
    }
  }
  return wanted
}
