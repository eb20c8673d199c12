import { describe, expect, it } from 'vitest'
import { roomForMap } from '../../src/app/layout/room'

const screen = { width: 1000, height: 600 }
const wide = { width: 40, height: 20 }
const column = { left: 10, top: 10, width: 300, height: 400 }
const bar = { left: 600, top: 10, width: 390, height: 50 }

describe('the room for the map', () => {
  it('is the whole screen if nothing covers it', () => {
    expect(roomForMap(screen, [], wide)).toEqual({ left: 0, top: 0, ...screen })
  })

  it('lies beside a column and below a bar', () => {
    const room = roomForMap(screen, [column, bar], wide)
    expect(room).toEqual({ left: 310, top: 60, width: 690, height: 540 })
  })

  it('goes where the map gets larger, for a high map as for a wide one', () => {
    const middle = { left: 400, top: 0, width: 300, height: 500 }
    expect(roomForMap(screen, [middle], { width: 10, height: 60 })).toMatchObject({ height: 600 })
    const across = { left: 0, top: 200, width: 900, height: 100 }
    expect(roomForMap(screen, [across], { width: 90, height: 20 })).toMatchObject({
      top: 300,
      width: 1000,
    })
  })

  it('is the larger of two in which the map is nearly as large', () => {
    const bar = { left: 0, top: 280, width: 1000, height: 20 }
    const below = { left: 320, top: 300, width: 680, height: 300 }
    const square = { width: 10, height: 10 }
    const above = { left: 0, top: 0, width: 1000, height: 280 }
    expect(roomForMap(screen, [bar, below], square)).toEqual(above)
    const lower = { ...bar, top: 220, height: 80 }
    const corner = { left: 0, top: 300, width: 320, height: 300 }
    expect(roomForMap(screen, [lower, below], square)).toEqual(corner)
  })

  it('is no gap between cards, however wide, for the sake of a map of few rows', () => {
    const left = { left: 0, top: 12, width: 300, height: 500 }
    const right = { left: 800, top: 12, width: 200, height: 500 }
    const below = { left: 0, top: 540, width: 1000, height: 60 }
    const room = roomForMap(screen, [left, right, below], { width: 2048, height: 3 })
    expect(room).toEqual({ left: 300, top: 0, width: 500, height: 540 })
  })

  it('never lies under a card that sticks out of the screen', () => {
    const out = { left: -100, top: -50, width: 200, height: 800 }
    expect(roomForMap(screen, [out], wide)).toEqual({ left: 100, top: 0, width: 900, height: 600 })
  })

  it('is the whole screen if the cards leave next to nothing', () => {
    const all = { left: 0, top: 0, width: 990, height: 600 }
    expect(roomForMap(screen, [all], wide)).toEqual({ left: 0, top: 0, ...screen })
  })
})
