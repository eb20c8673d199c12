import { create, setText } from '../element'
import { boundsInWords, type NumberRule, parseNumber } from '../words/parse-number'
import { choiceInWords } from '../words/sentences'

/** What every field says of itself. */
export interface Described {
  readonly id: string
  readonly label: string
  /** One line of explanation; may be empty. */
  readonly help: string
}

/** A labelled control of a form. */
export interface Field<Value> {
  readonly element: HTMLElement
  /** Shows the value, unless the field shows it already. */
  show(value: Value): void
}

function labelled({ id, label, help }: Described, control: HTMLElement, ...more: HTMLElement[]) {
  const helpLines = help ? [create('p', { class: 'help', id: `${id}-help` }, help)] : []
  const described = [...helpLines, ...more].map((line) => line.id)
  control.setAttribute('aria-describedby', described.join(' '))
  const name = create('label', { for: id }, label)
  return create('div', { class: 'field' }, name, control, ...more, ...helpLines)
}

export interface NumberFieldSettings extends Described, NumberRule {
  readonly unit: string
  /** What stands for an empty field; without it the field must not be empty. */
  readonly automatic?: string
}

export interface NumberFieldEvents {
  /** With every keystroke that leaves something valid; `undefined` for an empty field. */
  edited(value: number | undefined): void
  /** When the value is left as it is. */
  done(): void
}

export interface NumberField extends Field<number | undefined> {
  /** Shows the value in place of whatever was typed. */
  showAnew(value: number | undefined): void
  /** The number that the field holds; `undefined` and a message if it is not valid. */
  check(): number | undefined
  focus(): void
  /** What stands for an empty field from now on. */
  setAutomatic(text: string): void
}

export function numberField(
  settings: NumberFieldSettings,
  events: Partial<NumberFieldEvents> = {},
): NumberField {
  const { id, kind, min, max, unit, label } = settings
  const isOptional = settings.automatic !== undefined
  const input = create('input', {
    id,
    type: 'number',
    min,
    max,
    step: kind === 'integer' ? 1 : 'any',
    inputmode: kind === 'integer' ? 'numeric' : 'decimal',
    placeholder: settings.automatic ?? '',
    autocomplete: 'off',
  })
  const fault = create('p', { class: 'fault', id: `${id}-fault` })
  const described = { ...settings, label: unit ? `${label} (${unit})` : label }
  const element = labelled(described, input, fault)
  let shown: number | undefined | null = null

  const read = (): { readonly value: number | undefined; readonly fault: string } => {
    // A browser hands out '' for what is no number at all.
    const parsed = parseNumber(input.validity.badInput ? 'no number' : input.value, settings)
    if (parsed.kind === 'number') return { value: parsed.value, fault: '' }
    if (parsed.kind === 'fault') return { value: undefined, fault: parsed.text }
    return { value: undefined, fault: isOptional ? '' : boundsInWords(settings) }
  }
  const showFault = (text: string): void => {
    setText(fault, text)
    if (text) input.setAttribute('aria-invalid', 'true')
    else input.removeAttribute('aria-invalid')
  }

  input.addEventListener('input', () => {
    const { value, fault } = read()
    showFault(fault)
    if (fault) return
    shown = value
    events.edited?.(value)
  })
  input.addEventListener('change', () => events.done?.())

  const showAnew = (value: number | undefined): void => {
    shown = value
    input.value = value === undefined ? '' : String(value)
    showFault('')
  }

  return {
    element,
    show(value) {
      // What is being typed stays, valid or not, until the value changes elsewhere.
      if (value !== shown) showAnew(value)
    },
    showAnew,
    check() {
      const { value, fault } = read()
      showFault(fault)
      return value
    },
    focus: () => input.focus(),
    setAutomatic: (text) => input.setAttribute('placeholder', text),
  }
}

export interface ChoiceFieldSettings extends Described {
  readonly choices: readonly string[]
}

export function choiceField(
  settings: ChoiceFieldSettings,
  chosen: (value: string) => void,
): Field<string> {
  const select = create('select', { id: settings.id, class: 'browser-default' })
  for (const choice of settings.choices) {
    select.append(create('option', { value: choice }, choiceInWords(choice)))
  }
  select.addEventListener('change', () => chosen(select.value))
  return {
    element: labelled(settings, select),
    show(value) {
      select.value = value
    },
  }
}

export function switchField(settings: Described, switched: (on: boolean) => void): Field<boolean> {
  const { id, label, help } = settings
  const input = create('input', { id, type: 'checkbox', role: 'switch' })
  const helpLine = create('p', { class: 'help', id: `${id}-help` }, help)
  input.setAttribute('aria-describedby', helpLine.id)
  input.addEventListener('change', () => switched(input.checked))
  const name = create('label', {}, label, input, create('span', { class: 'lever' }))
  const element = create('div', { class: 'field' }, create('div', { class: 'switch' }, name))
  if (help) element.append(helpLine)
  return {
    element,
    show(on) {
      input.checked = on
    },
  }
}
