import { countWork, type ExperimentSettings } from '../../experiments/settings'
import { checkSettings } from '../../experiments/settings-check'
import { InputError } from '../../grid/errors'
import { numberInWords } from '../words/numbers'
import { capitalised } from '../words/sentences'
import { type Draft, valueIn } from './draft'

/** What is wrong with the settings, and where: "planners[2].params.samples[0]". */
export interface Fault {
  readonly field: string
  readonly text: string
}

export type Checked =
  | { readonly kind: 'settings'; readonly settings: ExperimentSettings }
  | { readonly kind: 'fault'; readonly fault: Fault }

/** All rows are kept in the memory of the page. */
export const MOST_RUNS_HERE = 500_000

/** What the form holds: settings that can be run, or the first thing that is wrong with it. */
export function checkDraft(draft: Draft): Checked {
  try {
    const settings = checkSettings(valueIn(draft))
    const { runs } = countWork(settings)
    if (runs <= MOST_RUNS_HERE) return { kind: 'settings', settings }
    const [asked, most] = [runs, MOST_RUNS_HERE].map(numberInWords)
    const text = `These settings ask for ${asked} runs; this page keeps at most ${most}. Save them, and run them with "npm run experiment".`
    return { kind: 'fault', fault: { field: 'mapsPerCombination', text } }
  } catch (error) {
    if (error instanceof InputError) return { kind: 'fault', fault: faultIn(error.message) }
    throw error
  }
}

/** Messages of the check begin with the field that they are about. */
function faultIn(message: string): Fault {
  const [, field, text] = /^([a-z]+(?:\.\w+|\[\d+\])*): (.*)$/is.exec(message) ?? []
  if (field === undefined) return { field: '', text: message }
  return { field, text: capitalised(text.replace(SIZE_IN_FILES, SIZE_HERE)) }
}

/** A size as settings files have it, and as it is typed. */
const SIZE_IN_FILES = '[width, height]'
const SIZE_HERE = 'a size such as 40×30'

/** The one of the fields that a fault is shown at: its own, or the nearest that it lies within. */
export function fieldFor(fault: Fault, fields: Iterable<string>): string | null {
  let nearest: string | null = null
  for (const field of fields) {
    const isWithin = fault.field === field || /^[.[]/.test(fault.field.slice(field.length))
    if (!fault.field.startsWith(field) || !isWithin) continue
    if (nearest === null || field.length > nearest.length) nearest = field
  }
  return nearest
}
