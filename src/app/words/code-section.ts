import type { AnyPlanner, Values } from '../../algorithms/planner'

export interface CodeLine {
  /** As events on the tape name it, counted from 0. */
  readonly line: number
  readonly text: string
}

const HEADER = /^variant (\S+)/

/**
 * The pseudocode that is in use: of a planner whose pseudocode has sections for its variants, only
 * that of the chosen one, and the lines that are common to all, which are not indented.
 */
export function codeSection({ pseudocode }: Pick<AnyPlanner, 'pseudocode'>, values: Values) {
  let section: string | null = null
  const shown: CodeLine[] = []
  pseudocode.forEach((text, line) => {
    const header = HEADER.exec(text)
    if (header) section = header[1]
    else if (!text.startsWith(' ')) section = null
    if (section === null || section === values.variant) shown.push({ line, text })
  })
  return shown
}
