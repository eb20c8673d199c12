import fc from 'fast-check'
import { expect, test } from 'vitest'
import {
  covers,
  joined,
  type View,
  Viewer,
} from '../../src/algorithms/grid-search/jump-points/views'

const side = fc.oneof(
  fc.integer({ min: 2, max: 2048 }),
  // As many squares as can be counted, and one column more.
  fc.constantFrom(127, 128, 254, 255, 508, 509, 1016, 1017, 2032, 2033),
)

/** A map's size with two rectangles on it, each as [left, top, right, bottom]. */
const rectangles = fc.tuple(side, side).chain(([width, height]) => {
  const span = (cells: number) =>
    fc
      .tuple(fc.nat(cells - 1), fc.nat(cells - 1))
      .map(([a, b]) => [Math.min(a, b), Math.max(a, b)] as const)
  const rectangle = fc
    .tuple(span(width), span(height))
    .map(([[left, right], [top, bottom]]) => [left, top, right, bottom] as const)
  return fc.record({ size: fc.constant({ width, height }), a: rectangle, b: rectangle })
})

type Rectangle = readonly [number, number, number, number]

const isWithin = (inner: Rectangle, outer: Rectangle, spare = 0): boolean =>
  inner[0] >= outer[0] - spare &&
  inner[1] >= outer[1] - spare &&
  inner[2] <= outer[2] + spare &&
  inner[3] <= outer[3] + spare

test('a view covers what lies within it, and what does not at most by the side of a square', () => {
  fc.assert(
    fc.property(rectangles, ({ size, a, b }) => {
      const viewer = new Viewer(size)
      const covered = covers(viewer.view(...a), viewer.view(...b))
      if (isWithin(b, a)) expect(covered).toBe(true)
      const longer = Math.max(size.width, size.height)
      if (covered) expect(isWithin(b, a, longer <= 127 ? 0 : Math.ceil(longer / 64))).toBe(true)
    }),
  )
})

test('two views joined cover both, and no more than their rectangle', () => {
  fc.assert(
    fc.property(rectangles, ({ size, a, b }) => {
      const viewer = new Viewer(size)
      const around = viewer.view(
        Math.min(a[0], b[0]),
        Math.min(a[1], b[1]),
        Math.max(a[2], b[2]),
        Math.max(a[3], b[3]),
      )
      expect(joined(viewer.view(...a), viewer.view(...b))).toBe(around)
    }),
  )
})

test('who looked at nothing covers nothing, and adds nothing', () => {
  const nothing: View = 0
  const cell = new Viewer({ width: 9, height: 9 }).view(0, 0, 0, 0)
  expect(covers(nothing, cell)).toBe(false)
  expect(joined(nothing, cell)).toBe(cell)
})
