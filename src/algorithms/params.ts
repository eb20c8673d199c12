import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import type { Problem } from '../grid/problem'

interface Named<Name extends string> {
  readonly name: Name
  /** What the form calls it. */
  readonly label: string
  /** One line of explanation. */
  readonly help: string
}

interface Numeric<Name extends string> extends Named<Name> {
  readonly min: number
  readonly max: number
  /** What it counts: "cells", "samples"; empty for a bare number. */
  readonly unit: string
  /** A function where the default depends on the map. */
  readonly default: number | ((problem: Problem) => number)
}

export interface IntegerParam<Name extends string = string> extends Numeric<Name> {
  readonly kind: 'integer'
}

export interface NumberParam<Name extends string = string> extends Numeric<Name> {
  readonly kind: 'number'
}

export interface ChoiceParam<Name extends string = string, Choice extends string = string>
  extends Named<Name> {
  readonly kind: 'choice'
  readonly choices: readonly Choice[]
  readonly default: Choice
}

export interface BooleanParam<Name extends string = string> extends Named<Name> {
  readonly kind: 'boolean'
  readonly default: boolean
}

/** A parameter as a planner declares it: form, checks and experiments follow from this. */
export type Param = IntegerParam | NumberParam | ChoiceParam | BooleanParam
/** Of an integer or a number, a choice, a switch. */
export type ParamValue = number | string | boolean
/** Values by parameter name. A name that is missing stands for the default. */
export type ParamSettings = Readonly<Record<string, ParamValue>>

type ValueOf<P extends Param> = P extends { kind: 'choice' }
  ? P['choices'][number]
  : P extends { kind: 'boolean' }
    ? boolean
    : number

/** The typed values of a list of declared parameters. */
export type ValuesOf<Params extends readonly Param[]> = {
  readonly [P in Params[number] as P['name']]: ValueOf<P>
}

export function defaultOf(param: Param, problem: Problem): ParamValue {
  return typeof param.default === 'function' ? param.default(problem) : param.default
}

/** Why a value does not fit its parameter, in words; empty if it does. */
export function faultOf(param: Param, value: unknown): string {
  switch (param.kind) {
    case 'boolean':
      return typeof value === 'boolean' ? '' : `${describe(value)} is not true or false`
    case 'choice':
      return typeof value === 'string' && param.choices.includes(value)
        ? ''
        : `${describe(value)} is not one of ${param.choices.join(', ')}`
    default: {
      if (typeof value !== 'number' || !Number.isFinite(value))
        return `${describe(value)} is no number`
      if (param.kind === 'integer' && !Number.isInteger(value)) {
        return `${value} is not a whole number`
      }
      return value < param.min || value > param.max
        ? `${value} is not from ${param.min} to ${param.max}`
        : ''
    }
  }
}

/**
 * All values of a planner's parameters: those given, checked, and defaults for the rest.
 * @throws InputError that names the parameter that is unknown or whose value does not fit.
 */
export function completeParams(
  owner: { readonly id: string; readonly params: readonly Param[] },
  given: ParamSettings,
  problem: Problem,
): Record<string, ParamValue> {
  for (const name of Object.keys(given)) {
    if (!owner.params.some((param) => param.name === name)) {
      const known = owner.params.map((param) => param.name).join(', ') || 'none'
      throw new InputError(`Planner ${owner.id} has no parameter "${name}" (it has: ${known}).`)
    }
  }
  const values: Record<string, ParamValue> = {}
  for (const param of owner.params) {
    const value = given[param.name] ?? defaultOf(param, problem)
    const fault = faultOf(param, value)
    if (fault) throw new InputError(`Parameter "${param.name}" of planner ${owner.id}: ${fault}.`)
    values[param.name] = value
  }
  return values
}
