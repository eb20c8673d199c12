import { GIVEN_MAPS } from '../../experiments/settings'
import { create } from '../element'
import { icon } from '../icons'
import { countInWords } from '../words/numbers'
import { type Entry, type List, paramsOf, titleOf } from './draft'
import { type FaultyField, paramField } from './list-fields'

export interface EntryEvents {
  removed(key: number): void
  listChanged(key: number, name: string, list: List): void
  /** More maps are wanted. */
  mapsWanted(): void
}

export interface EntryForm {
  readonly element: HTMLElement
  /** By the path of what they hold: "families[0].params.density". */
  readonly fields: ReadonlyMap<string, FaultyField>
  /** Shows in the headline what the entry holds. */
  show(entry: Entry): void
}

/** A family of maps or a planner: its name and values in one line, opened to its fields. */
export function entryForm(entry: Entry, path: string, events: EntryEvents): EntryForm {
  const id = `entry-${entry.key}`
  const fields = new Map<string, FaultyField>()
  const values = create('span', { class: 'entry-values' })
  const title = titleOf(entry.id)
  const remove = create('button', {
    type: 'button',
    class: 'icon-button',
    'aria-label': `Remove ${title}`,
    title: 'Remove',
  })
  remove.append(icon('close'))
  remove.addEventListener('click', () => events.removed(entry.key))

  const params = paramsOf(entry.id)
  const body = create('div', { class: 'entry-body' })
  for (const param of params) {
    const field = paramField(param, `${id}-${param.name}`, entry.lists[param.name], (list) =>
      events.listChanged(entry.key, param.name, list),
    )
    fields.set(`${path}.params.${param.name}`, field)
    body.append(field.element)
  }
  if (entry.id === GIVEN_MAPS) body.append(...openedMaps(entry, events))
  else if (params.length === 0) body.append(create('p', { class: 'help' }, 'It has no parameters.'))

  const details = create(
    'details',
    { id: `${id}-details`, open: entry.id === GIVEN_MAPS },
    create('summary', {}, create('span', { class: 'entry-title' }, title), values),
    body,
  )
  const fault = create('p', { class: 'fault' })
  fields.set(path, {
    element: details,
    showFault: (text) => {
      fault.textContent = text
    },
    focus: () => remove.focus(),
  })
  // A fault inside must be seen.
  for (const [field, one] of fields) {
    if (field === path) continue
    fields.set(field, {
      ...one,
      showFault(text) {
        if (text) details.open = true
        one.showFault(text)
      },
    })
  }
  const show = ({ lists, maps }: Entry) => {
    values.textContent = maps.length > 0 ? countInWords(maps.length, 'map') : listsInWords(lists)
  }
  show(entry)
  return { element: create('li', { class: 'entry' }, details, remove, fault), fields, show }
}

function openedMaps({ key, maps }: Entry, { mapsWanted }: EntryEvents): HTMLElement[] {
  const list = create('ul', { class: 'map-names' })
  for (const { name, rows } of maps) {
    list.append(create('li', {}, `${name}, ${rows[0].length} × ${rows.length}`))
  }
  const more = create(
    'button',
    { type: 'button', class: 'btn tonal', id: `entry-${key}-more` },
    'Add maps from files…',
  )
  more.addEventListener('click', mapsWanted)
  const help = 'Files of this page, MovingAI maps and text maps. Start and goal are drawn by lot.'
  return [list, more, create('p', { class: 'help' }, help)]
}

function listsInWords(lists: Entry['lists']): string {
  return Object.entries(lists)
    .map(([name, list]) => [name, typeof list === 'string' ? list : list.join(', ')] as const)
    .filter(([, values]) => values.trim() !== '')
    .map(([name, values]) => `${name} ${values}`)
    .join(' · ')
}
