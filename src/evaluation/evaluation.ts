import { groupBy } from '../experiments/summary/groups'
import { boundsSection, bug1Section, bug2Section, tangentBugSection } from './bugs'
import { decompositionSection, visibilityGraphSection } from './complete'
import { densityFigure } from './density'
import type { Evidence, Section } from './evidence'
import { influenceSection, localMinimaSection, memorySection } from './fields'
import { roadmapSection } from './roadmap'
import type { Figure } from './svg'
import { count, list } from './words'

/** A document and the drawings that it shows, by the names of their files. */
export interface Evaluation {
  readonly markdown: string
  readonly figures: readonly Figure[]
}

/**
 * Section V of the report, claim by claim, with what an experiment says to it.
 * @param machine what the times were measured on, in words
 * @param folder where the drawings will be, as seen from the document
 */
export function evaluate(evidence: Evidence, machine: string, folder: string): Evaluation {
  const first = densityFigure(evidence)
  const sections = [
    decompositionSection(evidence),
    visibilityGraphSection(evidence),
    roadmapSection(evidence),
    localMinimaSection(evidence),
    memorySection(evidence),
    influenceSection(evidence),
    bug1Section(evidence),
    bug2Section(evidence),
    tangentBugSection(evidence),
    boundsSection(evidence),
  ]
  const shown = (figure: Figure) => `![${figure.alt}](${folder}/${figure.name}.svg)`
  const write = ({ title, claim, body, figures }: Section) =>
    [`## ${title}`, ...(claim ? [`> ${claim}`] : []), body, ...figures.map(shown)].join('\n\n')
  const parts = [introduction(evidence, machine), shown(first), ...sections.map(write)]
  return {
    markdown: `${parts.join('\n\n')}\n`,
    figures: [first, ...sections.flatMap(({ figures }) => figures)],
  }
}

function introduction({ settings, rows }: Evidence, machine: string): string {
  const maps = [...groupBy(rows, ({ map }) => map).values()].map(([row]) => row)
  const families = [...groupBy(maps, ({ family }) => family)].map(
    ([family, own]) => `${count(own.length)} of the family \`${family}\``,
  )
  const sizes = [...groupBy(maps, ({ width, height }) => `${width} × ${height}`)].map(
    ([size, own]) => `${count(own.length)} of ${size} cells`,
  )
  const reachable = maps.filter((row) => row.reachable).length
  return `# Section V, answered

Section V of the report compares the planners in words. Here each of its claims is held against figures.
This page is written by \`npm run evaluation\` out of [settings/section-v.json](../settings/section-v.json):
who runs it again gets the same figures, but for the times.

- **Maps**: ${count(maps.length)}; ${list(families)}; ${list(sizes)}. Seed ${settings.seed}, diagonal rule \`${settings.diagonal}\`.
- **Start and goal**: random free cells, at least ${settings.leastDistance} steps apart. On ${count(reachable)} maps the goal can be reached; shares of success are of these.
- **Runs**: ${count(rows.length)}. Intervals are 95 % confidence intervals after Wilson.
- **Ratio**: steps of a path divided by the least number of steps there is; for the Bugs, the competitive ratio.
- **Times**: ${machine}. They compare planners with each other, not this machine with yours.`
}
