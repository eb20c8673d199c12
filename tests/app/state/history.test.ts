import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { emptyHistory, redo, remember, undo } from '../../../src/app/state/history'
import { emptyProblem } from '../../../src/app/state/new-problem'
import { type Setup, withGrid, withParam } from '../../../src/app/state/setup'
import { setupToText } from '../../../src/app/storage/storage'
import { withCells } from '../../../src/grid/grid'

const first: Setup = {
  problem: emptyProblem(5, 4, 'if-at-most-one-obstacle'),
  plannerId: 'bug2',
  params: {},
  seed: 1,
}

const edits = fc.oneof(
  fc.nat(19).map((cell) => (setup: Setup) => {
    const { grid } = setup.problem
    const changed = withCells(grid, [cell % grid.walls.length], grid.walls[cell] === 0)
    return withGrid(setup, changed)
  }),
  fc
    .constantFrom('left', 'right')
    .map((turn) => (setup: Setup) => withParam(setup, 'bug2', 'turn', turn)),
  fc.nat(9).map((seed) => (setup: Setup) => ({ ...setup, seed })),
  fc.integer({ min: 5, max: 9 }).map((side) => (setup: Setup) => ({
    ...setup,
    problem: emptyProblem(side, side, 'only-when-no-obstacles'),
  })),
)

const actions = fc.array(fc.oneof(edits, fc.constantFrom('undo' as const, 'redo' as const)), {
  maxLength: 60,
})

describe('history', () => {
  it('goes back and forth through the same setups as a list of all of them', () => {
    fc.assert(
      fc.property(actions, (list) => {
        let history = emptyHistory
        let setup = first
        const all = [setupToText(first)]
        let here = 0
        for (const action of list) {
          if (typeof action === 'function') {
            history = remember(history, setup)
            setup = action(setup)
            all.splice(++here, all.length, setupToText(setup))
          } else {
            const travel = (action === 'undo' ? undo : redo)(history, setup)
            const there = here + (action === 'undo' ? -1 : 1)
            expect(travel !== null).toBe(there >= 0 && there < all.length)
            if (!travel) continue
            here = there
            history = travel.history
            setup = travel.setup
          }
          expect(setupToText(setup)).toBe(all[here])
          expect(history.past.length).toBe(here)
          expect(history.future.length).toBe(all.length - 1 - here)
        }
      }),
    )
  })

  it('keeps no map twice where only a parameter changed', () => {
    let history = emptyHistory
    for (let seed = 0; seed < 20; seed++) history = remember(history, { ...first, seed })
    expect(new Set(history.past.map((entry) => entry.bits)).size).toBe(1)
    // So it counts once.
    let small = emptyHistory
    for (let seed = 0; seed < 20; seed++) small = remember(small, { ...first, seed }, 3)
    expect(small.past.length).toBe(20)
    const travel = undo(history, { ...first, seed: 20 })
    expect(travel?.setup.problem.grid.walls).toBe(first.problem.grid.walls)
  })

  it('forgets the oldest steps when the maps take more bytes than it may keep', () => {
    let history = emptyHistory
    let setup = first
    for (let i = 0; i < 6; i++) {
      setup = withGrid(setup, withCells(setup.problem.grid, [i], true))
      history = remember(history, setup, 9)
    }
    // 20 cells are 3 bytes.
    expect(history.past.length).toBe(3)
    expect(undo(history, first)?.setup).toEqual(setup)
  })

  it('forgets the oldest of more than a thousand steps', () => {
    let history = emptyHistory
    for (let seed = 0; seed <= 1000; seed++) history = remember(history, { ...first, seed })
    expect(history.past.length).toBe(1000)
    expect(history.past[0].setup.seed).toBe(1)
  })
})
