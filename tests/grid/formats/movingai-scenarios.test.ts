import { describe, expect, test } from 'vitest'
import { readScenarios } from '../../../src/grid/formats/movingai-scenarios'
import { InputError } from '../../../src/index'

describe('scenarios', () => {
  const line = '3\tmaps/a b.map\t5\t4\t0\t1\t4\t3\t6.24264069'

  test('are read line by line', () => {
    const scenario = {
      bucket: 3,
      map: 'maps/a b.map',
      width: 5,
      height: 4,
      start: { x: 0, y: 1 },
      goal: { x: 4, y: 3 },
      length: 6.24264069,
    }
    expect(readScenarios(`version 1\n${line}\n${line}\n`)).toEqual([scenario, scenario])
    expect(readScenarios(`version 1.0\r\n\r\n${line}\r\n`)).toEqual([scenario])
    expect(readScenarios('version 1\n0 a.map 5 4 0 1 4 3 0')).toEqual([
      { ...scenario, bucket: 0, map: 'a.map', length: 0 },
    ])
    expect(readScenarios('version 1')).toEqual([])
  })

  test.each([
    ['', 'Line 1 must be "version 1", but is "".'],
    [line, 'Line 1 must be "version 1"'],
    ['version 2', 'Line 1 must be "version 1", but is "version 2".'],
    [
      `version 1\n${line}\n3\ta.map`,
      'Line 3 of the scenarios: expected 9 fields, but there are 2.',
    ],
    [`version 1\n\n${line}\t7`, 'Line 3 of the scenarios: expected 9 fields, but there are 10.'],
    [
      `version 1\n${line.replace('\t5\t', '\t-5\t')}`,
      'Line 2 of the scenarios: the width must be a whole number, but is "-5".',
    ],
    [
      `version 1\n${line.replace('\t0\t', '\t\t')}`,
      'the start x must be a whole number, but is "".',
    ],
    [
      `version 1\n${line.replace('\t4\t3', '\t5\t3')}`,
      'Line 2 of the scenarios: the goal (5, 3) is not on the 5 × 4 map.',
    ],
    [`version 1\n${line.replace('\t0\t1', '\t0\t4')}`, 'the start (0, 4) is not on the 5 × 4 map.'],
    [
      `version 1\n${line.replace('6.24', 'x')}`,
      'the optimal length must be a number, but is "x264069".',
    ],
    [
      `version 1\n${line.replace('6.24', '9'.repeat(400))}`,
      'Line 2 of the scenarios: the optimal length must be a number, but is "999',
    ],
  ])('%j is refused', (text, message) => {
    expect(() => readScenarios(text)).toThrow(InputError)
    expect(() => readScenarios(text)).toThrow(message)
  })
})
