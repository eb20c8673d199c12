// One line for each figure, and whether it meets its target.

/** @typedef {{ name: string, value: number, unit: string, most?: number }} Figure */

/** What a list of numbers comes down to. @param {readonly number[]} values */
export function spread(values) {
  const rising = values.toSorted((a, b) => a - b)
  const at = (/** @type {number} */ share) =>
    rising[Math.min(rising.length - 1, Math.floor(share * rising.length))] ?? Number.NaN
  return { median: at(0.5), p95: at(0.95), worst: rising.at(-1) ?? Number.NaN }
}

/** Prints figures as they come, and counts those that miss their target. */
export class Report {
  missed = 0

  /** @param {string} title */
  section(title) {
    console.log(`\n${title}`)
  }

  /**
   * @param {string} name
   * @param {number} value
   * @param {string} unit
   * @param {number} [most] the target, if there is one
   */
  figure(name, value, unit, most) {
    const isMissed = most !== undefined && !(value <= most)
    if (isMissed) this.missed++
    const target =
      most === undefined ? '' : `  at most ${rounded(most)}${isMissed ? '  MISSED' : ''}`
    console.log(`  ${name.padEnd(64)}${rounded(value).padStart(8)} ${unit.padEnd(6)}${target}`)
  }

  /**
   * Median, 95th percentile and worst of a list.
   * @param {string} name
   * @param {readonly number[]} values
   * @param {string} unit
   * @param {{ median?: number, p95?: number, worst?: number }} [most] targets
   */
  figures(name, values, unit, most = {}) {
    const { median, p95, worst } = spread(values)
    this.figure(`${name}, median`, median, unit, most.median)
    this.figure(`${name}, 95th percentile`, p95, unit, most.p95)
    this.figure(`${name}, worst of ${values.length}`, worst, unit, most.worst)
  }
}

/** @param {number} value */
function rounded(value) {
  return Number.isFinite(value) ? String(Math.round(value * 10) / 10) : 'none'
}
