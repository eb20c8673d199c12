import { describe, expect, it } from 'vitest'
import { contrast, mix, pixelOf, rgbOf } from '../../src/render/colour'
import { heatColours, heatInks } from '../../src/render/heat'
import { type Theme, themes } from '../../src/render/theme'

const between = (a: string, b: string) => contrast(rgbOf(a), rgbOf(b))
const BLACK = rgbOf('#000000')

describe('colours', () => {
  it('have the contrast of WCAG', () => {
    expect(between('#000000', '#ffffff')).toBe(21)
    expect(between('#777777', '#ffffff')).toBeCloseTo(4.48, 2)
    expect(between('#336699', '#336699')).toBe(1)
  })

  it('are opaque pixels, red in the lowest byte', () => {
    expect(pixelOf(rgbOf('#123456'))).toBe(0xff563412)
  })

  it('mix channel by channel', () => {
    expect(mix(rgbOf('#000a14'), rgbOf('#640a00'), 0.5)).toEqual([50, 10, 10])
    expect(mix([0, 10, 0], [3, 0, 10], 0.25)).toEqual([1, 8, 3])
  })
})

describe.each(Object.values(themes))('the $name theme', (theme: Theme) => {
  const { cell, obstacle } = theme
  const groundsSeen = [cell.free, cell.open, cell.closed, cell.sensed]

  it.each(groundsSeen)('tells obstacles from free cells of %s', (ground) => {
    expect(between(obstacle.seen, ground)).toBeGreaterThanOrEqual(2.5)
    expect(between(theme.rim, ground)).toBeGreaterThanOrEqual(3)
  })

  it('tells obstacles from free cells at 3:1, seen or not', () => {
    expect(between(obstacle.seen, cell.free)).toBeGreaterThanOrEqual(3)
    expect(between(obstacle.seen, cell.sensed)).toBeGreaterThanOrEqual(3)
    expect(between(obstacle.felt, cell.sensed)).toBeGreaterThanOrEqual(3)
    expect(between(obstacle.unsensed, cell.unsensed)).toBeGreaterThanOrEqual(3)
  })

  it('tells what has been sensed from what has not by lightness', () => {
    expect(between(cell.sensed, cell.unsensed)).toBeGreaterThanOrEqual(1.4)
    expect(between(cell.closed, cell.free)).toBeGreaterThanOrEqual(1.2)
    expect(between(cell.open, cell.closed)).toBeGreaterThanOrEqual(1.2)
  })

  it.each([
    'path',
    'start',
    'goal',
    'roadmap',
    'vertex',
    'mLine',
    'hit',
    'leave',
    'passed',
    'failed',
  ] as const)('shows %s on every free cell', (name) => {
    expect(between(theme[name], cell.free)).toBeGreaterThanOrEqual(3)
    for (const ground of [...groundsSeen, cell.unsensed]) {
      const best = Math.max(between(theme[name], ground), between(theme.casing, ground))
      expect(best).toBeGreaterThanOrEqual(3)
    }
  })

  it('outlines lines and marks, so that they can be seen on obstacles', () => {
    for (const name of [
      'path',
      'start',
      'goal',
      'mLine',
      'hit',
      'leave',
      'rover',
      'passed',
      'failed',
    ] as const) {
      expect(between(theme[name], theme.casing)).toBeGreaterThanOrEqual(3)
    }
  })

  it('shows the cursor on every cell, by one of its two lines', () => {
    for (const ground of [...groundsSeen, cell.unsensed, ...Object.values(obstacle)]) {
      const best = Math.max(between(theme.cursor, ground), between(theme.casing, ground))
      expect(best).toBeGreaterThanOrEqual(3)
    }
  })

  it('writes potentials so that they can be read at every level', () => {
    const inks = heatInks(theme)
    heatColours(theme).forEach((colour, level) => {
      expect(contrast(colour, rgbOf(inks[level]))).toBeGreaterThanOrEqual(4.5)
    })
  })

  it('orders the heat levels by lightness', () => {
    const lights = heatColours(theme).map((colour) => contrast(colour, BLACK))
    const rising = theme.name === 'dark' ? 1 : -1
    // Channels are whole numbers, so that levels next to each other may be equal or waver by one.
    for (let level = 8; level < lights.length; level++) {
      expect(rising * (lights[level] - lights[level - 8])).toBeGreaterThan(0)
    }
    expect(Math.max(...lights) / Math.min(...lights)).toBeGreaterThan(2)
  })

  it('keeps obstacles and the path apart from every heat level', () => {
    for (const colour of heatColours(theme)) {
      expect(contrast(colour, rgbOf(theme.rim))).toBeGreaterThanOrEqual(3)
      expect(contrast(colour, rgbOf(obstacle.seen))).toBeGreaterThanOrEqual(1.5)
      expect(contrast(colour, rgbOf(theme.path))).toBeGreaterThanOrEqual(2)
    }
  })
})
