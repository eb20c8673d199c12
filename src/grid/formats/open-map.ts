import { InputError } from '../errors'
import { describe, excerpt } from '../excerpt'
import { fileText } from '../file-text'
import { MAX_SIDE } from '../grid'
import { problemFromText } from '../text-map'
import { parseJson } from './json'
import { readMovingAiMap } from './movingai'
import { type OpenedMap, openedWithoutEnds } from './opened-map'
import { readOriginal } from './original-file'
import { FORMAT, readProject } from './project-file'

/** More characters than the largest map needs in any of the formats. */
export const MAX_FILE_LENGTH = 2 ** 24
const MAX_TEXT_MAP_LENGTH = 2 * MAX_SIDE * MAX_SIDE

/**
 * Opens a map file: this project's own JSON, the JSON of the original Path Planner, a MovingAI map
 * (whose problems do not allow steps past a corner), or a text map.
 * @throws InputError that says what is wrong with the file, and where.
 */
export function openMap(text: string): OpenedMap {
  const content = fileText(text)
  checkLength(content, MAX_FILE_LENGTH)
  const beginning = content.trimStart().slice(0, 100)
  if (beginning === '') throw new InputError('The file is empty.')
  if (beginning.startsWith('{')) return openJson(Object(parseJson(content)))
  if (beginning.startsWith('type ')) {
    return openedWithoutEnds(readMovingAiMap(content.trimStart()), 'only-when-no-obstacles')
  }
  if (/^[#.SG]{2}/.test(beginning)) {
    checkLength(content, MAX_TEXT_MAP_LENGTH)
    return { problem: problemFromText(content), notes: [] }
  }
  if (/^version \d/.test(beginning)) {
    throw new InputError(
      'These are scenarios of a MovingAI map, which is a file of its own: open that, its name ends in ".map".',
    )
  }
  throw new InputError(
    `This file is no map. It begins with ${excerpt(beginning)}, but a map is a JSON object ({…}), ` +
      'a MovingAI map ("type octile") or rows of "#" obstacle, "." free, "S" start and "G" goal.',
  )
}

function openJson(value: object): OpenedMap {
  if ('format' in value) {
    if (value.format === FORMAT) return readProject(value)
    throw new InputError(`The "format" of this file is ${describe(value.format)}, not "${FORMAT}".`)
  }
  if ('wall_map' in value) return readOriginal(value)
  throw new InputError(
    `This JSON file is no map of Path Planner: it has neither "format": "${FORMAT}" nor a "wall_map".`,
  )
}

function checkLength(text: string, most: number): void {
  if (text.length <= most) return
  const [has, may] = [text.length, most].map((length) => length.toLocaleString('en'))
  throw new InputError(`The file has ${has} characters; no map has more than ${may}.`)
}
