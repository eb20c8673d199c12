import type { Size } from '../../grid/grid'
import type { Rect, ScreenSize } from '../../render/view'

const ascending = (values: readonly number[]): number[] =>
  [...new Set(values)].sort((a, b) => a - b)

/** How much smaller a map may get for the sake of a larger room, in which it lies less squeezed. */
const WORTH = 0.88

/** What is narrower is a gap between cards: a map of few rows would get largest in it. */
const NARROWEST = 64

/**
 * The part of the screen that no card covers and in which the map gets largest, or nearly so: of
 * those the largest. The whole screen if the cards leave no room worth the name.
 */
export function roomForMap(screen: ScreenSize, covered: readonly Rect[], grid: Size): Rect {
  const rooms = emptyRooms(screen, covered).filter(
    ({ width, height }) => Math.min(width, height) >= NARROWEST,
  )
  const scaleIn = (room: Rect) => Math.min(room.width / grid.width, room.height / grid.height)
  const enough = WORTH * Math.max(0, ...rooms.map(scaleIn))
  const [largest] = rooms
    .filter((room) => scaleIn(room) >= enough)
    .sort((a, b) => b.width * b.height - a.width * a.height)
  return largest ?? { left: 0, top: 0, ...screen }
}

/**
 * The rectangles that no card covers, each as wide and as high as it can be: it begins and ends at
 * cards or at the edges of the screen.
 */
function emptyRooms(screen: ScreenSize, covered: readonly Rect[]): Rect[] {
  const within = (size: number, edges: readonly number[]) =>
    ascending(edges.map((edge) => Math.max(0, Math.min(edge, size))))
  const lefts = within(screen.width, [0, ...covered.map(({ left, width }) => left + width)])
  const rights = within(screen.width, [screen.width, ...covered.map(({ left }) => left)])
  const tops = within(screen.height, [0, ...covered.map(({ top, height }) => top + height)])
  const rooms: Rect[] = []
  for (const left of lefts) {
    for (const right of rights.filter((edge) => edge > left)) {
      const between = covered.filter((card) => card.left < right && left < card.left + card.width)
      for (const top of tops) {
        const below = between.filter((card) => top < card.top + card.height)
        const bottom = Math.min(screen.height, ...below.map((card) => card.top))
        if (bottom > top) rooms.push({ left, top, width: right - left, height: bottom - top })
      }
    }
  }
  return rooms
}
