import { InputError } from '../grid/errors'
import { type Cell, pointOf, type Size } from '../grid/grid'

/** So many events make a part of the text. */
const PART = 1024

/** A number as JSON, at most six decimals; what JSON cannot say becomes a text. */
function numberText(value: number): string {
  if (!Number.isFinite(value)) return value > 0 ? '"infinite"' : '"minus infinite"'
  // Where a double has no six decimals to spare, rounding would only spoil it.
  return String(Math.abs(value) < 1e9 ? Math.round(value * 1e6) / 1e6 : value)
}

/** The events of a search trace as lines of JSON: `begin` or `cell`, then `tell` for all the rest. */
export class PosthocLines {
  /** The types of the events that are in a place. */
  readonly types = new Set<string>()
  readonly #width: number
  readonly #most: number
  /** For each cell whether an event had its `id`: only then another event may name it as parent. */
  readonly #known: Uint8Array
  #lines: string[] = []
  /** Of the parts that were taken, in characters. */
  #length = 0
  #open = ''

  /** @param most characters that the events may have */
  constructor({ width, height }: Size, most: number) {
    this.#width = width
    this.#known = new Uint8Array(width * height)
    this.#most = most
  }

  /** Begins an event. Type, `id` and parent go into JSON as they are; a cell of -1 is no place. */
  begin(type: string, id: string, parent: string | null, cell: Cell): this {
    this.#close()
    let text = `{"type":"${type}","id":"${id}"`
    if (parent !== null) text += `,"pId":"${parent}"`
    if (cell >= 0) {
      const { x, y } = pointOf(this.#width, cell)
      text += `,"x":${x},"y":${y}`
      this.types.add(type)
    }
    this.#open = text
    return this
  }

  /** Begins an event of a cell for itself, so that the cell's `id` is the event's. */
  cell(type: string, cell: Cell, parent: string | null = null): this {
    this.begin(type, this.id(cell), parent, cell)
    this.#known[cell] = 1
    return this
  }

  id(cell: Cell): string {
    const { x, y } = pointOf(this.#width, cell)
    return `${x},${y}`
  }

  /** The `id` of a cell, if an event had it before. */
  idIfKnown(cell: Cell): string | null {
    return cell >= 0 && this.#known[cell] ? this.id(cell) : null
  }

  /** Tells more of the event that was begun: a name that goes into JSON as it is, and its value as JSON. */
  tell(name: string, json: string): this {
    this.#open += `,"${name}":${json}`
    return this
  }

  tellNumber(name: string, value: number): this {
    return this.tell(name, numberText(value))
  }

  /** Tells where another cell is; nothing if it is outside the map. */
  tellPlace(nameOfX: string, nameOfY: string, cell: Cell): this {
    if (cell < 0) return this
    const { x, y } = pointOf(this.#width, cell)
    return this.tell(nameOfX, String(x)).tell(nameOfY, String(y))
  }

  /** Whether there is enough for a part of the text. */
  get isFull(): boolean {
    return this.#lines.length >= PART
  }

  /**
   * The events since the last part, with commas between them and before them.
   * @throws InputError if all events have more characters than they may
   */
  take(): string {
    this.#close()
    if (this.#lines.length === 0) return ''
    const comma = this.#length > 0 ? ',\n' : ''
    const part = comma + this.#lines.join(',\n')
    this.#lines = []
    this.#length += part.length
    this.mustFit(this.#length)
    return part
  }

  /** @throws InputError if the events may not have so many characters. */
  mustFit(length: number): void {
    if (length <= this.#most) return
    throw new InputError(
      `The trace is too long for a file: more than ${this.#most / 1e6} million characters. Save one of a smaller map.`,
    )
  }

  #close(): void {
    if (this.#open !== '') this.#lines.push(`${this.#open}}`)
    this.#open = ''
  }
}
