import { describe, expect, it } from 'vitest'
import { rgbOf } from '../../src/render/colour'
import { fieldRange, HEAT_LEVELS, heatColours, heatLevel } from '../../src/render/heat'
import { themes } from '../../src/render/theme'
import { EVENT } from '../../src/trace/events'
import { Tape } from '../../src/trace/tape'

function tapeWith(...potentials: number[]): Tape {
  const tape = new Tape()
  tape.begin(4, 4)
  tape.write(EVENT.close, 3, -1, -500)
  potentials.forEach((potential, cell) => {
    tape.write(EVENT.potential, cell, -1, potential)
  })
  return tape
}

describe('fieldRange', () => {
  it('is that of the finite potentials, and of nothing else on the tape', () => {
    expect(fieldRange(tapeWith(9, Number.POSITIVE_INFINITY, 4, 25), 'potential')).toEqual({
      min: 4,
      max: 25,
    })
  })

  it('is null without any', () => {
    expect(fieldRange(tapeWith(), 'potential')).toBeNull()
    expect(fieldRange(tapeWith(Number.POSITIVE_INFINITY), 'potential')).toBeNull()
  })
})

describe('heatLevel', () => {
  const range = { min: 0, max: 10_000 }

  it('is even in the distance, not in its square', () => {
    expect(heatLevel(range, 0)).toBe(0)
    expect(heatLevel(range, 2500)).toBe(128)
    expect(heatLevel(range, 10_000)).toBe(HEAT_LEVELS - 1)
  })

  it('begins with the least potential of the field', () => {
    const levels = [100, 200, 500].map((potential) => heatLevel({ min: 100, max: 500 }, potential))
    expect(levels).toEqual([0, 128, HEAT_LEVELS - 1])
  })

  it('is -1 where there is no finite potential', () => {
    expect(heatLevel(range, Number.NaN)).toBe(-1)
    expect(heatLevel(range, Number.POSITIVE_INFINITY)).toBe(-1)
  })

  it('is 0 where all potentials are the same', () => {
    expect(heatLevel({ min: 5, max: 5 }, 5)).toBe(0)
  })
})

it('begins and ends the heat colours with the theme’s', () => {
  const colours = heatColours(themes.dark)
  expect(colours).toHaveLength(HEAT_LEVELS)
  expect(colours[0]).toEqual(rgbOf(themes.dark.heat[0]))
  expect(colours.at(-1)).toEqual(rgbOf(themes.dark.heat.at(-1) ?? ''))
})
