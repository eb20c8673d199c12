import { test } from 'vitest'
import { EVENT, Tape } from '../../src/index'
import { isClose, LONG, must, onEveryMap } from '../reference/cases'
import { descend, type Field, potentialAt } from '../reference/potential'
import { mustBeModest, mustNotExceed, mustWalkAlike, run } from '../reference/run'
import { freeCells, isWall, placesOf, type World } from '../reference/world'

/** Another field for each map, the report's among them. */
function fieldNumber(index: number): Field {
  return {
    influence: [1, 0, 2, 1, 3, 5, 9, 1, 30, 2, 4][index % 11],
    // With 2 and 6 many neighbours are equally low.
    repulsiveValue: [30, 2, 200, 0, 7.5, 6][index % 6],
    repulsionDistance: index % 5 < 2 ? 'manhattan' : 'euclidean',
  }
}

function mustHavePotentials(name: string, world: World, field: Field, tape: Tape): void {
  let found = 0
  for (let i = 0; i < tape.length; i++) {
    if (tape.kind(i) !== EVENT.potential) continue
    const [cell] = placesOf(world, [tape.cell(i)])
    const wall = isWall(world, cell[0], cell[1])
    const expected = wall ? Number.POSITIVE_INFINITY : potentialAt(world, field, cell)
    must(
      isClose(tape.value(i), expected),
      () => `${name}: potential ${tape.value(i)} at ${cell} instead of ${expected}`,
    )
    if (!wall) found++
  }
  const free = freeCells(world).length
  must(found === free, () => `${name}: potential of ${found} of ${free} free cells`)
}

test('both potential fields and the walks down them', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const field = fieldNumber(index)
    for (const id of ['potential-field', 'potential-field-memory']) {
      const tape = new Tape()
      const found = run(world, id, { ...field }, tape)
      const { name, outcome, path } = found
      mustHavePotentials(name, world, field, tape)
      const expected = descend(world, field, id === 'potential-field-memory')
      must(outcome.status === expected.status, () => `${name}: ${outcome.status}`)
      mustWalkAlike(name, path, expected.path)
      mustBeModest(world, found)
      // Downhill all the way, or remembering: no cell comes twice.
      mustNotExceed(freeCells(world).length - 1, found)
    }
  })
})
