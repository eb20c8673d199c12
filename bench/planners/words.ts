import type { Case, Target } from './case'
import { aDoubling, type Growth, isGrowthMet, MOST_A_DOUBLING } from './growth'
import type { Figures } from './timing'

/** Three digits that count: "0.0512", "14.3", "1,520". */
export const digits = (value: number): string =>
  value.toLocaleString('en', { maximumSignificantDigits: 3 })

/** "×" is hard to type: cases are chosen by names in small letters with an x. */
export const plainName = (name: string): string => name.toLowerCase().replaceAll('×', 'x')

function targetInWords(target: Target): string {
  if (target === null) return '–'
  return 'atMost' in target ? `≤ ${target.atMost}` : `≥ ${target.atLeast}`
}

function metInWords(target: Target, met: boolean): string {
  if (target === null) return ''
  return met ? 'met' : 'MISSED'
}

/** What a case came to, column by column, as `COLUMNS` has them. */
export function columnsOf(one: Case, figures: Figures): string[] {
  const time = (ms: number) => (one.unit === 'cell' ? `${digits(1e6 * ms)} ns` : `${digits(ms)} ms`)
  const { ours, peer, ratio, lower, upper, met } = figures
  return [
    one.name,
    time(ours),
    time(peer),
    one.against,
    `${digits(ratio)}×`,
    `${digits(lower)}–${digits(upper)}`,
    targetInWords(one.target),
    metInWords(one.target, met),
  ]
}

/** "0.21 ms at 64×64, 152 ms at 2048×2048: cells^0.98, a doubling takes ×1.97". */
export function growthInWords(growth: Growth): string {
  const { grower, points, exponent } = growth
  const ends = [points[0], points[points.length - 1]].map(
    ({ side, median }) => `${digits(median)} ms at ${side}×${side}`,
  )
  const target = grower.isLinear
    ? ` (≤ ${MOST_A_DOUBLING}: ${isGrowthMet(growth) ? 'met' : 'MISSED'})`
    : ''
  const power = `cells^${exponent.toFixed(2)}, a doubling takes ×${digits(aDoubling(growth))}`
  return `growth of ${grower.name}: ${ends.join(', ')}: ${power}${target}`
}

export const COLUMNS = [
  'case',
  'ours',
  'peer',
  'which peer',
  'ratio',
  'quartiles',
  'target',
  '',
] as const

const WIDTHS = [64, 10, 10, 38, 8, 15, 7, 6]
/** Words stand at the left of their column, numbers at the right. */
const IS_WORDS = [true, false, false, true, false, false, false, true]

export function lineOf(columns: readonly string[]): string {
  return columns
    .map((text, i) => (IS_WORDS[i] ? text.padEnd(WIDTHS[i]) : text.padStart(WIDTHS[i])))
    .join('  ')
    .trimEnd()
}

export function say(line: string): void {
  process.stdout.write(`${line}\n`)
}
