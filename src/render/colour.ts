/** Red, green and blue, each from 0 to 255. */
export type Rgb = readonly [red: number, green: number, blue: number]

export function rgbOf(hex: string): Rgb {
  const number = Number.parseInt(hex.slice(1), 16)
  return [number >> 16, (number >> 8) & 255, number & 255]
}

/** A colour as one pixel of a `Uint32Array` over image data: opaque, red in the lowest byte. */
export function pixelOf([red, green, blue]: Rgb): number {
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0
}

/** The `#rrggbb` of an opaque pixel. */
export function hexOf(pixel: number): string {
  const [red, green, blue] = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255]
  return `#${((red << 16) | (green << 8) | blue).toString(16).padStart(6, '0')}`
}

/** The colour `part` of the way from `a` to `b`. */
export function mix(a: Rgb, b: Rgb, part: number): Rgb {
  const between = (i: 0 | 1 | 2) => Math.round(a[i] + (b[i] - a[i]) * part)
  return [between(0), between(1), between(2)]
}

function luminance(rgb: Rgb): number {
  const [red, green, blue] = rgb.map((channel) => {
    const part = channel / 255
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
  })
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/** Contrast of two colours, from 1 (the same) to 21 (WCAG 2.2, "contrast ratio"). */
export function contrast(a: Rgb, b: Rgb): number {
  const [darker, lighter] = [luminance(a), luminance(b)].sort((p, q) => p - q)
  return (lighter + 0.05) / (darker + 0.05)
}
