import type { Pen } from '../pen'

/** Adds a line through points around (x, y), turned clockwise by `angle`, to the current path. */
export function traceTurned(
  pen: Pen,
  x: number,
  y: number,
  angle: number,
  points: readonly (readonly [number, number])[],
): void {
  const cos = Math.cos(angle)
  const sin = Math.sin(angle)
  points.forEach(([px, py], i) => {
    const at = [x + cos * px - sin * py, y + sin * px + cos * py] as const
    if (i === 0) pen.moveTo(...at)
    else pen.lineTo(...at)
  })
}
