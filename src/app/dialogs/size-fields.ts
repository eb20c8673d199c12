import { MAX_SIDE, MIN_SIDE, type Size } from '../../grid/grid'
import { type NumberField, numberField } from '../panels/fields'

export interface SizeFields {
  readonly elements: readonly HTMLElement[]
  show(size: Size): void
  /** `null`, and a message at the field that is wrong, if there is no such size. */
  check(): Size | null
}

/** The two fields of a map's size. */
export function sizeFields(prefix: string): SizeFields {
  const side = (name: string, label: string): NumberField =>
    numberField({
      id: `${prefix}-${name}`,
      kind: 'integer',
      label,
      unit: 'cells',
      min: MIN_SIDE,
      max: MAX_SIDE,
      help: '',
    })
  const width = side('width', 'Width')
  const height = side('height', 'Height')
  return {
    elements: [width.element, height.element],
    show(size) {
      width.showAnew(size.width)
      height.showAnew(size.height)
    },
    check() {
      const size = { width: width.check(), height: height.check() }
      if (size.width !== undefined && size.height !== undefined) {
        return { width: size.width, height: size.height }
      }
      if (size.width === undefined) width.focus()
      else height.focus()
      return null
    },
  }
}
