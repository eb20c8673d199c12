/** A drawing for the documents: what it is called, what it shows in words, and its SVG. */
export interface Figure {
  /** Name of its file, without an extension. */
  readonly name: string
  readonly alt: string
  readonly svg: string
}

/** Colours that can be told apart without seeing red or green (Okabe and Ito), and line styles. */
export const STYLES = [
  { colour: '#0072b2', dash: '' },
  { colour: '#d55e00', dash: '6 3' },
  { colour: '#009e73', dash: '2 3' },
  { colour: '#cc79a7', dash: '9 3 2 3' },
  { colour: '#56b4e9', dash: '' },
  { colour: '#e69f00', dash: '4 2' },
  { colour: '#000000', dash: '1 2' },
] as const

const INK = '#333333'
export const FAINT = '#dddddd'

/** Coordinates to a tenth of a pixel, so that the files are short. */
export const px = (value: number): string => String(Math.round(value * 10) / 10)

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;')

type Attributes = Readonly<Record<string, string | number>>

export function element(name: string, attributes: Attributes, content = ''): string {
  const list = Object.entries(attributes)
    .map(([key, value]) => ` ${key}="${typeof value === 'number' ? px(value) : escaped(value)}"`)
    .join('')
  return content === '' ? `<${name}${list}/>` : `<${name}${list}>${content}</${name}>`
}

/** A line of text; `anchor` says which part of it is at (x, y). */
export function text(
  x: number,
  y: number,
  words: string,
  anchor: 'start' | 'middle' | 'end' = 'start',
  attributes: Attributes = {},
): string {
  return element('text', { x, y, 'text-anchor': anchor, ...attributes }, escaped(words))
}

export function line(
  x1: number,
  y1: number,
  x2: number,
  y2: number,
  attributes: Attributes,
): string {
  return element('line', { x1, y1, x2, y2, ...attributes })
}

/** A whole drawing on white, so that it can be read on dark pages too. */
export function document(width: number, height: number, title: string, parts: string[]): string {
  const head = { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}` }
  const style = { role: 'img', 'font-family': 'system-ui, sans-serif', 'font-size': 13, fill: INK }
  const ground = element('rect', { width, height, fill: '#ffffff' })
  const body = [element('title', {}, escaped(title)), ground, ...parts].join('\n')
  return `${element('svg', { ...head, width, height, ...style }, `\n${body}\n`)}\n`
}
