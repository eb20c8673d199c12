import type { Param, ParamValue } from '../../algorithms/params'
import type { GeneratorParam } from '../../grid/generators'
import { create, setText } from '../element'
import type { Described } from '../panels/fields'
import { choiceInWords } from '../words/sentences'
import type { List } from './draft'

/** A field of the form that can say what is wrong with it. */
export interface FaultyField {
  readonly element: HTMLElement
  /** An empty text takes the fault away. */
  showFault(text: string): void
  focus(): void
}

/** A line of text: one number, or several with commas. */
export function textField(
  { id, label, help }: Described,
  value: string,
  placeholder: string,
  typed: (text: string) => void,
): FaultyField {
  const input = create('input', {
    id,
    type: 'text',
    value,
    placeholder,
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-describedby': `${id}-fault ${id}-help`,
  })
  const fault = faultLine(id)
  input.addEventListener('input', () => typed(input.value))
  const element = create(
    'div',
    { class: 'field' },
    create('label', { for: id }, label),
    input,
    fault,
  )
  if (help) element.append(create('p', { class: 'help', id: `${id}-help` }, help))
  return {
    element,
    showFault(text) {
      setText(fault, text)
      if (text) input.setAttribute('aria-invalid', 'true')
      else input.removeAttribute('aria-invalid')
    },
    focus: () => input.focus(),
  }
}

/** Choices to be ticked; with none ticked the default holds. */
function ticksField(
  { id, label, help }: Described,
  choices: readonly { readonly value: ParamValue; readonly name: string }[],
  ticked: readonly ParamValue[],
  changed: (ticked: ParamValue[]) => void,
): FaultyField {
  const fault = faultLine(id)
  const boxes = choices.map(({ value, name }) => {
    const box = create('input', {
      type: 'checkbox',
      class: 'filled-in',
      'aria-describedby': fault.id,
    })
    box.checked = ticked.includes(value)
    box.addEventListener('change', () => {
      changed(choices.filter((_, i) => boxes[i].box.checked).map((choice) => choice.value))
    })
    return { box, label: create('label', { class: 'tick' }, box, create('span', {}, name)) }
  })
  const element = create(
    'fieldset',
    { class: 'field ticks' },
    create('legend', {}, label),
    ...boxes.map((one) => one.label),
    fault,
  )
  if (help) element.append(create('p', { class: 'help' }, help))
  return {
    element,
    showFault: (text) => setText(fault, text),
    focus: () => boxes[0]?.box.focus(),
  }
}

const faultLine = (id: string): HTMLParagraphElement =>
  create('p', { class: 'fault', id: `${id}-fault` })

/** The field for the values of a parameter, as the planner or the generator declares it. */
export function paramField(
  param: Param | GeneratorParam,
  id: string,
  list: List | undefined,
  changed: (list: List) => void,
): FaultyField {
  const ticked = Array.isArray(list) ? list : []
  switch (param.kind) {
    case 'choice': {
      const help = `${param.help} Without a tick: ${param.default}.`
      const choices = param.choices.map((value) => ({ value, name: choiceInWords(value) }))
      return ticksField({ ...param, id, help }, choices, ticked, changed)
    }
    case 'boolean': {
      const help = `${param.help} Without a tick: ${param.default ? 'on' : 'off'}.`
      const choices = [false, true].map((value) => ({ value, name: value ? 'On' : 'Off' }))
      return ticksField({ ...param, id, help }, choices, ticked, changed)
    }
    default: {
      const label = param.unit ? `${param.label} (${param.unit})` : param.label
      const usual = typeof param.default === 'function' ? 'automatic' : param.default
      const text = typeof list === 'string' ? list : ''
      return textField({ id, label, help: param.help }, text, `${usual}`, changed)
    }
  }
}
