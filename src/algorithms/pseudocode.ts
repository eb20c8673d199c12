/** Pseudocode whose lines have names, so that a planner can say where it is. */
export interface Pseudocode<Name extends string> {
  readonly text: readonly string[]
  /** The place of each named line, counted from 0. */
  readonly line: Readonly<Record<Name, number>>
}

export function pseudocode<Name extends string>(lines: Record<Name, string>): Pseudocode<Name> {
  const names = Object.keys(lines) as Name[]
  const line = Object.fromEntries(names.map((name, i) => [name, i])) as Record<Name, number>
  return { text: Object.values(lines), line }
}
