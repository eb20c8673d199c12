import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { MAX_FILE_LENGTH, openMap } from '../../../src/grid/formats/open-map'
import { InputError, problemToText } from '../../../src/index'
import { problems } from '../arbitraries'
import { mustRefuse } from './files'
import { project } from './sound-file'

test('a text map is opened as problemFromText reads it', () => {
  fc.assert(
    fc.property(problems, (problem) => {
      fc.pre(problem.start !== problem.goal)
      const text = problemToText(problem)
      const opened = { problem: { ...problem, diagonal: 'if-at-most-one-obstacle' }, notes: [] }
      expect(openMap(text)).toEqual(opened)
      expect(openMap(`\uFEFF\r\n${text.replaceAll('\n', '\r\n')}`)).toEqual(opened)
    }),
  )
})

describe('what is no map', () => {
  test.each([
    ['', 'The file is empty.'],
    [' \n\t\r\n', 'The file is empty.'],
    ['\uFEFF', 'The file is empty.'],
    ['Hello, world', 'This file is no map. It begins with "Hello, world", but a map is'],
    ['# A heading', 'This file is no map. It begins with "# A heading"'],
    ['GIF89a\u0001\u0000', 'It begins with "GIF89a··"'],
    ['\u0089PNG\r\n\u001a\n', 'It begins with "·PNG'],
    ['[1, 2, 3]', 'This file is no map. It begins with "[1, 2, 3]"'],
    ['null', 'This file is no map.'],
    ['version 1\n0\tarena.map\t49\t49\t1\t11\t1\t12\t1\n', 'These are scenarios of a MovingAI map'],
    ['{}', 'it has neither "format": "path-planner" nor a "wall_map".'],
    ['{"rows": ["..", ".."]}', 'This JSON file is no map of Path Planner'],
    ['{"__proto__": {"format": "path-planner"}}', 'This JSON file is no map of Path Planner'],
    ['{"format": "path-planner", "version": 1, "constructor": 1}', '"diagonal" is missing'],
    [
      '{"format": "path-planner",',
      'line 1, column 27: expected a key in double quotes, but it ends.',
    ],
    ['S..\n..', 'Row 2 has 2 cells, but row 1 has 3.'],
    ['...\n...', 'The map has no start ("S").'],
    ['#S.\n#?G', '"?" at (1, 1) is no cell'],
  ])('%j', (text, message) => {
    mustRefuse(text, message)
  })

  test('a prototype in the file is only a key like others', () => {
    const hostile = project().replace(
      '{',
      '{"__proto__": {"rows": ["##", "##"], "polluted": true},',
    )
    expect(openMap(hostile)).toEqual(openMap(project()))
    expect(({} as { polluted?: boolean }).polluted).toBeUndefined()
  })
})

describe('size', () => {
  test.each([
    ['nested without end', `{"a":${'['.repeat(5_000_000)}`],
    ['many small columns', `{"size":{"x":2048,"y":2048},"wall_map":[${'[],'.repeat(2047)}[]]}`],
    [
      'a million rows',
      `{"format":"path-planner","version":1,"diagonal":"only-when-no-obstacles","start":[0,0],"goal":[1,1],"rows":[${'"..",'.repeat(1_000_000)}".."]}`,
    ],
    ['one line of text', '.'.repeat(5_000_000)],
    ['a million lines of text', '..\n'.repeat(1_000_000)],
  ])('%s is refused', (_, text) => {
    expect(() => openMap(text)).toThrow(InputError)
  })

  test.each([
    ['text than any text map', '..\n'.repeat(4_000_000), '12,000,000'],
    ['than any file', ' '.repeat(MAX_FILE_LENGTH + 1), '16,777,217'],
  ])('more %s has is refused before it is looked at', (_, text, size) => {
    mustRefuse(text, `The file has ${size} characters; no map has more than`)
  })
})
