import { planners } from '../../algorithms/planners'
import { GIVEN_MAPS } from '../../experiments/settings'
import { generators } from '../../grid/generators'
import { create } from '../element'
import type { Store } from '../state/store'
import type { Draft } from './draft'
import { type EntryEvents, type EntryForm, entryForm } from './entries'
import type { FaultyField } from './list-fields'
import type { PageState } from './state'
import { addEntry, editList, removeEntry } from './transitions'

const GROUPS = {
  families: {
    title: 'Families of maps',
    add: 'Add a family…',
    choices: [
      ...generators.map(({ id, title }) => ({ id, title })),
      { id: GIVEN_MAPS, title: 'Maps from files…' },
    ],
  },
  planners: {
    title: 'Planners',
    add: 'Add a planner…',
    choices: planners.map(({ id, title }) => ({ id, title })),
  },
} as const

export interface EntryGroup {
  readonly element: HTMLElement
  /** By the path of what they hold. */
  readonly fields: ReadonlyMap<string, FaultyField>
  show(draft: Draft): void
}

/** The families or the planners, and the select that adds one. */
export function entryGroup(
  store: Store<PageState>,
  group: keyof typeof GROUPS,
  openMaps: () => void,
): EntryGroup {
  const { title, add, choices } = GROUPS[group]
  const fields = new Map<string, FaultyField>()
  const list = create('ul', { class: 'entries' })
  const fault = create('p', { class: 'fault' })
  const select = create(
    'select',
    { id: `add-${group}`, class: 'browser-default', 'aria-label': add.replace('…', '') },
    create('option', { value: '' }, add),
  )
  for (const choice of choices) select.append(create('option', { value: choice.id }, choice.title))
  select.addEventListener('change', () => {
    const { value } = select
    select.value = ''
    if (value === GIVEN_MAPS) openMaps()
    else if (value) store.update((state) => addEntry(state, group, value))
  })
  const events: EntryEvents = {
    removed: (key) => {
      store.update((state) => removeEntry(state, group, key))
      document.getElementById(select.id)?.focus()
    },
    listChanged: (key, name, values) =>
      store.update((state) => editList(state, group, key, name, values)),
    mapsWanted: openMaps,
  }
  const forms = new Map<number, EntryForm>()
  store.state.draft[group].forEach((entry, i) => {
    const one = entryForm(entry, `${group}[${i}]`, events)
    forms.set(entry.key, one)
    list.append(one.element)
    for (const [path, field] of one.fields) fields.set(path, field)
  })
  fields.set(group, {
    element: fault,
    showFault: (text) => {
      fault.textContent = text
    },
    focus: () => select.focus(),
  })
  const element = create(
    'fieldset',
    { class: 'group' },
    create('legend', {}, title),
    list,
    create('div', { class: 'field' }, select),
    fault,
  )
  const show = (draft: Draft) => {
    for (const entry of draft[group]) forms.get(entry.key)?.show(entry)
  }
  return { element, fields, show }
}
