import type { Grid } from '../../grid/grid'
import type { Rect, ScreenSize } from '../../render/view'

const overlap = (a: Rect, b: Rect): boolean =>
  a.left < b.left + b.width &&
  b.left < a.left + a.width &&
  a.top < b.top + b.height &&
  b.top < a.top + a.height

const ascending = (values: readonly number[]): number[] =>
  [...new Set(values)].sort((a, b) => a - b)

/** How much smaller a map may get for the sake of a larger room, in which it lies less squeezed. */
const WORTH = 0.88

/**
 * The part of the screen that no card covers and in which the map gets largest, or nearly so: of
 * those the largest. The whole screen if the cards leave no room worth the name.
 */
export function roomForMap(
  screen: ScreenSize,
  covered: readonly Rect[],
  grid: Pick<Grid, 'width' | 'height'>,
): Rect {
  const rooms = emptyRooms(screen, covered)
  const scaleIn = (room: Rect) => Math.min(room.width / grid.width, room.height / grid.height)
  const enough = WORTH * Math.max(0, ...rooms.map(scaleIn))
  const [largest] = rooms
    .filter((room) => scaleIn(room) >= enough)
    .sort((a, b) => b.width * b.height - a.width * a.height)
  const isWorthIt = largest !== undefined && Math.min(largest.width, largest.height) >= 64
  return isWorthIt ? largest : { left: 0, top: 0, ...screen }
}

/** All rectangles between the edges of cards and screen that no card covers. */
function emptyRooms(screen: ScreenSize, covered: readonly Rect[]): Rect[] {
  const edges = (size: number, values: readonly number[]) =>
    ascending([0, size, ...values.map((value) => Math.max(0, Math.min(value, size)))])
  const xs = edges(
    screen.width,
    covered.flatMap((card) => [card.left, card.left + card.width]),
  )
  const ys = edges(
    screen.height,
    covered.flatMap((card) => [card.top, card.top + card.height]),
  )
  const rooms: Rect[] = []
  for (const left of xs) {
    for (const right of xs.filter((x) => x > left)) {
      for (const top of ys) {
        for (const bottom of ys.filter((y) => y > top)) {
          const room = { left, top, width: right - left, height: bottom - top }
          if (!covered.some((card) => overlap(card, room))) rooms.push(room)
        }
      }
    }
  }
  return rooms
}
