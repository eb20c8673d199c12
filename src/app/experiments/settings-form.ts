import { DIAGONAL_RULES } from '../../grid/steps'
import { byId, create } from '../element'
import type { Store } from '../state/store'
import { DIAGONAL_RULE_WORDS } from '../words/diagonal-rules'
import type { Draft } from './draft'
import { entryGroup } from './entry-group'
import { type Fault, fieldFor } from './faults'
import { type FaultyField, textField } from './list-fields'
import { presets } from './presets'
import type { PageState } from './state'
import { edit, openSettings } from './transitions'

const NUMBERS = [
  {
    name: 'sizes',
    label: 'Sizes (cells)',
    help: 'Width × height, such as 40×40, 80×60; one number is a square.',
  },
  {
    name: 'mapsPerCombination',
    label: 'Maps of each kind',
    help: 'Of each family, combination of its values, and size.',
  },
  {
    name: 'leastDistance',
    label: 'Least distance (steps)',
    help: 'From start to goal, which are drawn by lot.',
  },
  { name: 'seed', label: 'Seed', help: 'The same seed gives the same maps.' },
] as const

export interface SettingsForm {
  show(state: PageState): void
  /** Moves the focus to what is wrong, if anything is. */
  focusFault(state: PageState): void
}

/** Binds the form of the settings. */
export function settingsForm(store: Store<PageState>, openMaps: () => void): SettingsForm {
  const form = byId('form', HTMLFormElement)
  form.addEventListener('submit', (event) => event.preventDefault())
  bindPresets(store)
  let made: { readonly number: number; readonly parts: Parts } | null = null

  return {
    show(state) {
      if (made?.number !== state.formMade) {
        const opened = openEntries(form)
        const focused = form.contains(document.activeElement) ? document.activeElement?.id : ''
        made = { number: state.formMade, parts: buildParts(store, openMaps) }
        form.replaceChildren(...made.parts.elements)
        for (const details of form.querySelectorAll('details')) {
          if (opened.has(details.id)) details.open = true
        }
        if (focused) document.getElementById(focused)?.focus()
      }
      made.parts.show(state)
    },
    focusFault({ checked }) {
      if (checked.kind !== 'fault' || !made) return
      fieldOf(checked.fault, made.parts.fields)?.focus()
    },
  }
}

function bindPresets(store: Store<PageState>): void {
  const group = byId('presets', HTMLFieldSetElement)
  for (const { title, settings } of presets) {
    const button = create('button', { type: 'button', class: 'btn tonal' }, title)
    button.addEventListener('click', () => store.update((state) => openSettings(state, settings)))
    group.append(button)
  }
}

/** What was open stays open when an entry comes or goes. */
const openEntries = (form: HTMLElement): Set<string> =>
  new Set([...form.querySelectorAll<HTMLDetailsElement>('details[open]')].map(({ id }) => id))

interface Parts {
  readonly elements: readonly HTMLElement[]
  readonly fields: ReadonlyMap<string, FaultyField>
  show(state: PageState): void
}

function buildParts(store: Store<PageState>, openMaps: () => void): Parts {
  const { draft } = store.state
  const fields = new Map<string, FaultyField>()
  const families = entryGroup(store, 'families', openMaps)
  const runners = entryGroup(store, 'planners', openMaps)
  const numbers = NUMBERS.map(({ name, label, help }) => {
    const field = textField({ id: `field-${name}`, label, help }, draft[name], '', (text) =>
      store.update((state) => edit(state, { [name]: text })),
    )
    fields.set(name, field)
    return field.element
  })
  for (const [path, field] of [...families.fields, ...runners.fields]) fields.set(path, field)
  return {
    elements: [
      families.element,
      create('div', { class: 'pair' }, ...numbers),
      diagonalField(store, draft),
      runners.element,
    ],
    fields,
    show({ checked, draft }) {
      families.show(draft)
      runners.show(draft)
      const faulty = checked.kind === 'fault' ? fieldOf(checked.fault, fields) : null
      for (const field of fields.values()) {
        field.showFault(field === faulty && checked.kind === 'fault' ? checked.fault.text : '')
      }
    },
  }
}

function fieldOf(fault: Fault, fields: ReadonlyMap<string, FaultyField>): FaultyField | null {
  const path = fieldFor(fault, fields.keys())
  return path === null ? null : (fields.get(path) ?? null)
}

function diagonalField(store: Store<PageState>, { diagonal }: Draft): HTMLElement {
  const select = create('select', { id: 'diagonal', class: 'browser-default' })
  for (const rule of DIAGONAL_RULES) {
    select.append(create('option', { value: rule }, DIAGONAL_RULE_WORDS[rule].title))
  }
  select.value = diagonal
  select.addEventListener('change', () =>
    store.update((state) => edit(state, { diagonal: select.value })),
  )
  return create(
    'div',
    { class: 'field' },
    create('label', { for: 'diagonal' }, 'Diagonal steps'),
    select,
  )
}
