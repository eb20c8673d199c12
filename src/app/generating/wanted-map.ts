import { generators } from '../../grid/generators'
import type { Size } from '../../grid/grid'
import type { Problem } from '../../grid/problem'
import { DIAGONAL_RULES } from '../../grid/steps'

/** All that decides what a generator makes, and what the page asks its generating worker. */
export interface WantedMap {
  readonly generatorId: string
  readonly size: Size
  readonly params: Readonly<Record<string, number>>
  readonly seed: number
}

/**
 * Its diagonal rule is any: a map that comes later is planned by the one chosen then.
 * @throws InputError if there is no such map
 */
export function makeMap({ generatorId, size, params, seed }: WantedMap): Problem {
  const generator = generators.find(({ id }) => id === generatorId)
  if (!generator) throw new Error(`There is no generator ${generatorId}.`)
  return generator.generate(size, params, seed, DIAGONAL_RULES[0])
}
