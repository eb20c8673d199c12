import { EVENT, type Tape } from '../../src/index'
import { DIRECTIONS } from '../reference/world'
import type { Event } from './arbitraries'

/** All that is on a tape. */
export const written = (tape: Tape): Event[] =>
  Array.from({ length: tape.length }, (_, i) => ({
    kind: tape.kind(i) as Event['kind'],
    line: tape.line(i),
    cell: tape.cell(i),
    other: tape.other(i),
    value: tape.value(i),
  }))

export const kindsOf = (tape: Tape): number[] => written(tape).map(({ kind }) => kind)

/** The neighbours that the directions of an event name, with what a step there costs. */
function neighbours({ cell, other }: Event, width: number, diagonalCost: number) {
  const [x, y] = [cell % width, Math.floor(cell / width)]
  return DIRECTIONS.flatMap(([dx, dy], direction) =>
    other > 0 && Math.floor(other / 2 ** direction) % 2 === 1
      ? [{ cell: (y + dy) * width + x + dx, cost: dx !== 0 && dy !== 0 ? diagonalCost : 1 }]
      : [],
  )
}

/**
 * The same events, with one more for each neighbour that is opened by the closing of a cell, and with
 * the costs that need not be written.
 */
export function withOpened(events: readonly Event[], width: number, diagonalCost = 1): Event[] {
  const costs = new Map<number, number>()
  return events.flatMap((event) => {
    if (event.kind !== EVENT.close || event.other < 0) return [event]
    const value = costs.get(event.cell) ?? 0
    const opened = neighbours(event, width, diagonalCost).map(({ cell, cost }) => {
      costs.set(cell, value + cost)
      return { ...event, kind: EVENT.open, cell, other: event.cell, value: value + cost }
    })
    return [{ ...event, value }, ...opened.reverse()]
  })
}

/** The directions in which a cell has neighbours on the map. */
export function directionsInside(cell: number, width: number, height: number): number {
  const [x, y] = [cell % width, Math.floor(cell / width)]
  return DIRECTIONS.reduce((directions, [dx, dy], direction) => {
    const [nx, ny] = [x + dx, y + dy]
    const isInside = nx >= 0 && ny >= 0 && nx < width && ny < height
    return isInside ? directions + 2 ** direction : directions
  }, 0)
}
