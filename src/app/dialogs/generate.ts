import { type Generator, generators } from '../../grid/generators'
import { MAX_SEED } from '../../grid/random'
import { byId, create, setText } from '../element'
import { generatingFor } from '../generating/generating'
import { type NumberField, numberField } from '../panels/fields'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { formOf, newDialog } from './dialog'
import markup from './generate.html?raw'
import { sizeFields } from './size-fields'

/** Makes the dialog of the map generators; returns what opens it. */
export function generateDialog(store: Store<State>): () => void {
  const element = newDialog('generate-dialog', markup)
  const form = formOf(element)
  const generate = generatingFor(store)
  const kind = byId('generate-kind', HTMLSelectElement)
  const help = byId('generate-help', HTMLParagraphElement)
  const params = byId('generate-params', HTMLDivElement)
  const size = sizeFields('generate')
  byId('generate-size', HTMLDivElement).append(...size.elements)
  for (const { id, title } of generators) kind.append(create('option', { value: id }, title))

  const seed = numberField({
    id: 'generate-seed-value',
    kind: 'integer',
    label: 'Seed',
    unit: '',
    min: 0,
    max: MAX_SEED,
    help: 'The same seed gives the same map.',
  })
  byId('generate-seed', HTMLDivElement).prepend(seed.element)
  const throwDice = () => {
    const [number] = crypto.getRandomValues(new Uint32Array(1))
    seed.show(number % 10_000)
  }
  byId('generate-dice', HTMLButtonElement).addEventListener('click', throwDice)

  let fields = new Map<string, NumberField>()
  const chosen = (): Generator =>
    generators.find((generator) => generator.id === kind.value) ?? generators[0]
  const showParams = () => {
    const generator = chosen()
    setText(help, generator.help)
    fields = new Map(
      generator.params.map((param) => {
        const field = numberField({ ...param, id: `generate-${param.name}` })
        field.show(param.default)
        return [param.name, field]
      }),
    )
    params.replaceChildren(...[...fields.values()].map((field) => field.element))
  }
  kind.addEventListener('change', showParams)
  showParams()

  form.addEventListener('submit', (event) => {
    const generator = chosen()
    const values: Record<string, number> = {}
    let isValid = true
    for (const [name, field] of fields) {
      const value = field.check()
      if (value !== undefined) values[name] = value
      else if (isValid) {
        isValid = false
        field.focus()
      }
    }
    const chosenSize = isValid ? size.check() : null
    const chosenSeed = seed.check()
    if (!chosenSize || chosenSeed === undefined) return event.preventDefault()
    const { width, height } = chosenSize
    const text = `${generator.title}, ${width} × ${height} cells, seed ${chosenSeed}.`
    generate(
      { generatorId: generator.id, size: chosenSize, params: values, seed: chosenSeed },
      text,
    )
  })

  return () => {
    size.show(store.state.setup.problem.grid)
    throwDice()
    element.showModal()
  }
}
