import { InputError } from '../errors'
import type { Cell, Size } from '../grid'
import { checkSize, type Problem } from '../problem'
import { randomNumbers } from '../random'
import type { DiagonalRule } from '../steps'

export interface GeneratorParam {
  readonly name: string
  /** What the form calls it. */
  readonly label: string
  readonly kind: 'integer'
  readonly min: number
  readonly max: number
  readonly default: number
  /** What it counts; empty for a bare number. */
  readonly unit: string
  /** One line of explanation. */
  readonly help: string
}

export interface Generator {
  readonly id: string
  readonly title: string
  /** What kind of map it makes, in one sentence. */
  readonly help: string
  readonly params: readonly GeneratorParam[]
  /**
   * A new map; the same size, parameters and seed give the same one on every machine. Parameters
   * that are missing stand for their defaults.
   * @throws InputError that names the size, the parameter or the seed that does not fit.
   */
  generate(
    size: Size,
    params: Readonly<Record<string, number>>,
    seed: number,
    diagonal: DiagonalRule,
  ): Problem
}

/** What a generator makes: the obstacles (1) and two free cells. */
export interface GeneratedMap {
  readonly walls: Uint8Array
  readonly start: Cell
  readonly goal: Cell
}

interface Recipe<Param extends GeneratorParam> {
  readonly id: string
  readonly title: string
  readonly help: string
  readonly params: readonly Param[]
  build(
    size: Size,
    params: Readonly<Record<Param['name'], number>>,
    random: () => number,
  ): GeneratedMap
}

/** Declares a generator; the checks that all of them share are made here. */
export function generator<const Param extends GeneratorParam>(recipe: Recipe<Param>): Generator {
  const { id, title, help, params, build } = recipe
  return {
    id,
    title,
    help,
    params,
    generate({ width, height }, given, seed, diagonal) {
      checkSize(width, height)
      if (!Number.isSafeInteger(seed))
        throw new InputError(`The seed ${seed} is not a whole number.`)
      const values = completeParams(title, params, given)
      const { walls, start, goal } = build({ width, height }, values, randomNumbers(seed))
      return { grid: { width, height, walls }, start, goal, diagonal }
    },
  }
}

function completeParams<Param extends GeneratorParam>(
  title: string,
  params: readonly Param[],
  given: Readonly<Record<string, number>>,
): Record<Param['name'], number> {
  for (const name of Object.keys(given)) {
    if (!params.some((param) => param.name === name)) {
      throw new InputError(`"${title}" has no parameter "${name}".`)
    }
  }
  const values = params.map((param) => [param.name, checkedValue(param, given[param.name])])
  return Object.fromEntries(values) as Record<Param['name'], number>
}

function checkedValue({ label, min, max, default: usual }: GeneratorParam, given?: number): number {
  const value = given ?? usual
  if (Number.isInteger(value) && value >= min && value <= max) return value
  throw new InputError(`${label} is ${value}: it must be a whole number from ${min} to ${max}.`)
}
