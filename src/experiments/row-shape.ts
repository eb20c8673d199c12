import * as v from 'valibot'
import { InputError } from '../grid/errors'
import { describe } from '../grid/excerpt'
import { STATUSES } from '../trace/events'
import type { Row } from './row'

const whole = v.pipe(v.number(), v.integer(), v.minValue(0))
const amount = v.pipe(v.number(), v.finite(), v.minValue(0))
const place = v.strictTuple([whole, whole])

const shape: v.GenericSchema<unknown, Row> = v.strictObject({
  map: whole,
  family: v.string(),
  mapParams: v.record(v.string(), v.number()),
  width: whole,
  height: whole,
  density: amount,
  mapSeed: whole,
  start: place,
  goal: place,
  distance: whole,
  tooNear: v.boolean(),
  reachable: v.boolean(),
  optimumCells: v.nullable(whole),
  optimumLength: v.nullable(amount),
  setting: whole,
  planner: v.string(),
  params: v.record(v.string(), v.union([v.number(), v.string(), v.boolean()])),
  seed: whole,
  status: v.picklist(STATUSES),
  cells: whole,
  length: amount,
  turns: whole,
  steps: whole,
  ratio: v.nullable(amount),
  expanded: whole,
  sensed: whole,
  bound: v.nullable(amount),
  milliseconds: amount,
})

/**
 * A row in a JSON value.
 * @param name of the place, for the message: "Line 7"
 * @throws InputError that names the place and the field that is missing, unknown or wrong
 */
export function readRow(value: unknown, name: string): Row {
  const result = v.safeParse(shape, value, { abortEarly: true })
  if (result.success) return result.output
  const fault = (what: string) => new InputError(`${name} is no row of results: ${what}.`)
  const [issue] = result.issues
  const field = v.getDotPath(issue)
  if (field === null || Array.isArray(value)) throw fault(describe(value))
  if (issue.expected === 'never') throw fault(`there is no field "${field}"`)
  throw fault(`"${field}" is ${issue.input === undefined ? 'missing' : describe(issue.input)}`)
}
