import { EVENT } from '../trace/events'
import type { Field } from '../trace/frame'
import type { Tape } from '../trace/tape'
import { contrast, mix, pixelOf, type Rgb, rgbOf } from './colour'
import type { Theme } from './theme'

/** Least and greatest finite value of a field of potentials. */
export interface FieldRange {
  readonly min: number
  readonly max: number
}

export const HEAT_LEVELS = 256

/** The range of a field over the whole tape; `null` if it has no finite value. */
export function fieldRange(tape: Tape, field: Field): FieldRange | null {
  let min = Number.POSITIVE_INFINITY
  let max = Number.NEGATIVE_INFINITY
  const kind = EVENT[field]
  for (let i = 0; i < tape.length; i++) {
    if (tape.kind(i) !== kind) continue
    const value = tape.value(i)
    if (!Number.isFinite(value)) continue
    if (value < min) min = value
    if (value > max) max = value
  }
  return min <= max ? { min, max } : null
}

/**
 * The colour level of a potential, from 0 to 255; -1 if it is not finite. It grows with the square
 * root of the potential, because potentials grow with the square of the distance.
 */
export function heatLevel({ min, max }: FieldRange, potential: number): number {
  if (!Number.isFinite(potential)) return -1
  if (max === min) return 0
  return Math.round(Math.sqrt((potential - min) / (max - min)) * (HEAT_LEVELS - 1))
}

/** A colour for each level, between those that the theme names. */
export function heatColours({ heat }: Theme): Rgb[] {
  const stops = heat.map(rgbOf)
  return Array.from({ length: HEAT_LEVELS }, (_, level) => {
    const place = (level / (HEAT_LEVELS - 1)) * (stops.length - 1)
    const stop = Math.min(Math.floor(place), stops.length - 2)
    return mix(stops[stop], stops[stop + 1], place - stop)
  })
}

/** Makes something of a theme once and keeps it: it is asked for in every frame. */
function oncePerTheme<Made>(make: (theme: Theme) => Made): (theme: Theme) => Made {
  const kept = new WeakMap<Theme, Made>()
  return (theme) => {
    const made = kept.get(theme) ?? make(theme)
    kept.set(theme, made)
    return made
  }
}

/** The pixel of each level. */
export const heatPixels = oncePerTheme((theme) => Uint32Array.from(heatColours(theme), pixelOf))

/** For each level the ink that is easier to read on it. */
export const heatInks = oncePerTheme((theme): readonly string[] => {
  const { dark, light } = theme.ink
  return heatColours(theme).map((colour) =>
    contrast(colour, rgbOf(dark)) > contrast(colour, rgbOf(light)) ? dark : light,
  )
})
