import { faultOf, type IntegerParam, type NumberParam } from '../../algorithms/params'

export type NumberRule = Pick<IntegerParam | NumberParam, 'kind' | 'min' | 'max'>

export type ParsedNumber =
  | { readonly kind: 'number'; readonly value: number }
  | { readonly kind: 'empty' }
  | { readonly kind: 'fault'; readonly text: string }

/** What a number field holds. Whether it may be empty is up to the field. */
export function parseNumber(text: string, rule: NumberRule): ParsedNumber {
  if (text.trim() === '') return { kind: 'empty' }
  const value = Number(text)
  if (Number.isNaN(value)) return { kind: 'fault', text: boundsInWords(rule) }
  const fault = faultOf({ ...rule, name: '', label: '', help: '', unit: '', default: 0 }, value)
  return fault ? { kind: 'fault', text: `${fault}.` } : { kind: 'number', value }
}

/** What has to be entered; also shown at an empty field that must not be empty. */
export function boundsInWords({ kind, min, max }: NumberRule): string {
  const number = kind === 'integer' ? 'a whole number' : 'a number'
  return `Enter ${number} from ${min} to ${max}.`
}
