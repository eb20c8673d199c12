import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { openMap } from '../../../src/grid/formats/open-map'
import { checkProblem } from '../../../src/index'
import { problems } from '../arbitraries'
import { mustRefuse } from './files'

describe('the file of the original program', () => {
  const columns = (...texts: string[]) => texts.map((text) => Array.from(text, Number))
  const original = (change: object = {}): string =>
    JSON.stringify({
      spacing_x: 1,
      cell_side_length: 30,
      size: { x: 3, y: 3 },
      wall_map: columns('010', '000', '100'),
      objects: { 'w2-0': { type: 'TYPE_RECT', x: 2, y: 0 } },
      ...change,
    })

  test('is read column by column, with start and goal at the sides', () => {
    expect(openMap(original())).toEqual({
      problem: {
        grid: { width: 3, height: 3, walls: Uint8Array.of(0, 0, 1, 1, 0, 0, 0, 0, 0) },
        start: 0,
        goal: 5,
        diagonal: 'if-at-most-one-obstacle',
      },
      notes: ['The file has no start or goal: they were put at (0, 0) and (2, 1).'],
    })
  })

  test('the walls are those of the file on any map', () => {
    fc.assert(
      fc.property(problems, ({ grid: { width, height, walls } }) => {
        const columns = Array.from({ length: width }, (_, x) =>
          Array.from({ length: height }, (_, y) => walls[y * width + x]),
        )
        const { problem } = openMap(original({ size: { x: width, y: height }, wall_map: columns }))
        checkProblem(problem)
        expect(problem.grid).toEqual({ width, height, walls })
      }),
    )
  })

  test('a single free cell is start and goal', () => {
    const { problem } = openMap(original({ size: { x: 2, y: 2 }, wall_map: columns('11', '01') }))
    expect([problem.start, problem.goal]).toEqual([1, 1])
  })

  test.each<[string, object, string]>([
    [
      'without a free cell',
      { wall_map: columns('111', '111', '111') },
      'The map has no free cell.',
    ],
    ['without size', { size: undefined }, '"size" is missing'],
    ['with a size that is a number', { size: 3 }, '"size" must be an object'],
    ['with half a size', { size: { x: 3 } }, '"size.y" is missing: it must be a whole number.'],
    [
      'with a size of texts',
      { size: { x: '3', y: 3 } },
      '"size.x" must be a whole number, but is "3".',
    ],
    [
      'with a size of 2.5',
      { size: { x: 3, y: 2.5 } },
      '"size.y" must be a whole number, but is 2.5.',
    ],
    ['that claims to be huge', { size: { x: 100_000, y: 100_000 } }, "The map's width is 100000"],
    ['of one column', { size: { x: 1, y: 3 }, wall_map: [[0, 0, 0]] }, "The map's width is 1"],
    ['of negative size', { size: { x: -3, y: 3 } }, "The map's width is -3"],
    [
      'with a wall_map that is a text',
      { wall_map: 'walls' },
      '"wall_map" must be a list of columns',
    ],
    [
      'with too few columns',
      { size: { x: 2048, y: 2048 } },
      '"wall_map" has 3 columns, but "size.x" is 2048.',
    ],
    [
      'with a column too short',
      { wall_map: columns('000', '000', '0') },
      '"wall_map" column 2 has 1 cell, but "size.y" is 3.',
    ],
    [
      'with a column that is none',
      { wall_map: [[0, 0, 0], null, [0, 0, 0]] },
      '"wall_map" column 1 must be a list, but is null.',
    ],
    [
      'with a cell of 2',
      { wall_map: columns('000', '020', '000') },
      '"wall_map" column 1, cell 1 must be 1 (obstacle) or 0 (free), but is 2.',
    ],
    [
      'with a cell of text',
      { wall_map: [['1', 0, 0], ...columns('000', '000')] },
      'column 0, cell 0 must be 1 (obstacle) or 0 (free), but is "1".',
    ],
    [
      'with a cell of nothing',
      { wall_map: [[0, null, 0], ...columns('000', '000')] },
      'but is null.',
    ],
  ])('%s is refused', (_, change, message) => {
    mustRefuse(original(change), message)
  })
})
