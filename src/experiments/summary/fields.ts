import { plannerById } from '../../algorithms/plan'
import type { Row } from '../row'
import { groupBy } from './groups'
import { type Success, successOf } from './success'

/** Success over two parameters, for a heat map. */
export interface FieldMap {
  readonly planner: string
  /** "Potential field, euclidean". */
  readonly name: string
  /** By increasing value. */
  readonly influences: readonly number[]
  readonly repulsiveValues: readonly number[]
  /** `cells[i][k]` is for influence i and repulsive value k; `null` where nothing was run. */
  readonly cells: readonly (readonly (Success | null)[])[]
}

/** A map for each of the potential field planners and ways to measure the distance of obstacles. */
export function fieldMaps(rows: readonly Row[]): FieldMap[] {
  const fields = rows.filter(({ params }) => 'influence' in params)
  const nameOf = ({ planner, params }: Row) =>
    `${plannerById(planner).title}, ${params.repulsionDistance}`
  return [...groupBy(fields, nameOf)].map(([name, own]) => {
    const influences = valuesOf(own, 'influence')
    const repulsiveValues = valuesOf(own, 'repulsiveValue')
    const groups = groupBy(own, ({ params }) => `${params.influence} ${params.repulsiveValue}`)
    const successAt = (influence: number, repulsiveValue: number) => {
      const group = groups.get(`${influence} ${repulsiveValue}`)
      return group ? successOf(group) : null
    }
    const cells = influences.map((influence) =>
      repulsiveValues.map((value) => successAt(influence, value)),
    )
    return { planner: own[0].planner, name, influences, repulsiveValues, cells }
  })
}

function valuesOf(rows: readonly Row[], param: string): number[] {
  return [...new Set(rows.map(({ params }) => Number(params[param])))].sort((a, b) => a - b)
}
