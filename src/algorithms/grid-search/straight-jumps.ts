import type { Direction } from '../../grid/directions'

/** How a straight jump from each cell ends, of the latest map that was asked about. */
interface Known {
  readonly legal: Uint8Array
  readonly successors: Uint8Array
  readonly jumps: Int16Array
}

let known: Known | null = null

const NORTH = 0
const EAST = 2
const SOUTH = 4
const WEST = 6

/**
 * How far a straight jump goes from each cell: `jumps[4 * cell + direction / 2]`. After k steps it
 * comes to a cell with another way than onward: k. After k steps there is no way at all: -k.
 * (D. Harabor and A. Grastien, "Improving jump point search", 2014.)
 */
export function straightJumps(
  legal: Uint8Array,
  successors: Uint8Array,
  width: number,
): Int16Array {
  if (known?.legal === legal && known.successors === successors) return known.jumps
  const jumps = new Int16Array(4 * legal.length)
  fill(jumps, legal, successors, NORTH, -width)
  fill(jumps, legal, successors, EAST, 1)
  fill(jumps, legal, successors, SOUTH, width)
  fill(jumps, legal, successors, WEST, -1)
  known = { legal, successors, jumps }
  return jumps
}

/** Goes over the map against the direction, so that the cell after each one is known already. */
function fill(
  jumps: Int16Array,
  legal: Uint8Array,
  successors: Uint8Array,
  direction: Direction,
  offset: number,
): void {
  const onward = 1 << direction
  const row = direction << 8
  const place = direction >> 1
  const cells = legal.length
  for (let i = 0; i < cells; i++) {
    const cell = offset > 0 ? cells - 1 - i : i
    if ((legal[cell] & onward) === 0) continue
    const next = cell + offset
    const ways = successors[row | legal[next]]
    const after = jumps[4 * next + place]
    if (ways === onward) jumps[4 * cell + place] = after > 0 ? after + 1 : after - 1
    else jumps[4 * cell + place] = ways === 0 ? -1 : 1
  }
}
