import { describe, expect, it } from 'vitest'
import { dismiss, tell, tellOfMap, workProgressed } from '../../../src/app/state/messages'
import { withMark } from '../../../src/app/state/setup'
import { cellAskedAbout, isSettled, type State, visiblePlan } from '../../../src/app/state/state'
import {
  attempt,
  cancel,
  change,
  changeMap,
  clearObstacles,
  commit,
  crowd,
  edit,
  hidePath,
  hover,
  layOut,
  look,
  moveCursor,
  planArrived,
  planCancelled,
  planFailed,
  planIsSlow,
  planStarted,
  prefer,
  redo,
  undo,
} from '../../../src/app/state/transitions'
import { planned, setupFrom, stateFrom } from '../setups'

const begin = stateFrom('S...\n....\n...G')
const moved = (state: State, goal: number) => withMark(state.setup, 'goal', goal)

describe('edits', () => {
  it('become one step to undo when they are committed', () => {
    let state = begin
    for (const goal of [10, 9, 8]) state = edit(state, moved(state, goal))
    expect(state.history.past.length).toBe(0)
    state = commit(state, 'Moved.')
    expect(state.history.past.length).toBe(1)
    state = undo(state)
    expect(state.setup.problem.goal).toBe(11)
    state = redo(state)
    expect(state.setup.problem.goal).toBe(8)
    expect(state.committed).toBe(state.setup)
  })

  it('can be cancelled, which is no step', () => {
    const state = cancel(edit(begin, moved(begin, 9)))
    expect(state.setup).toBe(begin.setup)
    expect(commit(state, 'Moved.').history.past.length).toBe(0)
  })

  it('to a map of another size leave no cell of the one before on show', () => {
    const pointed = hover(moveCursor(begin, 9), 9)
    const other = { ...begin.setup, problem: setupFrom('..\nSG').problem }
    expect(edit(pointed, other)).toMatchObject({ cursor: 2, cursorShown: false, hovered: -1 })
    const same = { cursor: 9, cursorShown: true, hovered: 9 }
    expect(edit(pointed, moved(pointed, 10))).toMatchObject(same)
  })

  it('that lead back to where they began are no step', () => {
    const away = edit(begin, moved(begin, 9))
    const back = commit(edit(away, moved(away, 11)), 'Moved.')
    expect(back.setup).toBe(begin.setup)
    expect(back.history.past.length).toBe(0)
  })

  it('under way are what undo takes back first', () => {
    let state = change(begin, moved(begin, 10), 'Moved.')
    state = edit(state, moved(state, 9))
    state = undo(state)
    expect(state.setup.problem.goal).toBe(10)
    expect(state.history.past.length).toBe(1)
  })

  it('that change nothing are no step', () => {
    expect(change(begin, begin.setup, 'Nothing.')).toBe(begin)
  })

  it('do not get mixed with an edit that was still under way', () => {
    let state = edit(begin, moved(begin, 10))
    state = change(state, moved(state, 9), 'Moved.')
    expect(state.history.past.length).toBe(2)
    expect(undo(state).setup.problem.goal).toBe(10)
  })

  it('have nothing to undo at the beginning', () => {
    expect(undo(begin).setup).toBe(begin.setup)
    expect(undo(begin).said.text).toBe('Nothing to undo.')
    expect(redo(begin).said.text).toBe('Nothing to redo.')
  })
})

describe('a change that refuses what it is given', () => {
  it('changes nothing and says why', () => {
    const state = attempt(begin, () => {
      throw new Error('No cell is free.')
    })
    expect(state.setup).toBe(begin.setup)
    expect(state.messages[0]).toMatchObject({ kind: 'error', text: 'No cell is free.' })
  })
})

it('clearing obstacles is a step to undo, and none if there are none', () => {
  const drawn = stateFrom('S.#\n#.G')
  const cleared = clearObstacles(drawn)
  expect(cleared.setup.problem.grid.walls.includes(1)).toBe(false)
  expect(undo(cleared).setup.problem.grid.walls).toEqual(drawn.setup.problem.grid.walls)
  expect(clearObstacles(cleared).history).toBe(cleared.history)
})

describe('the view', () => {
  const screen = { width: 400, height: 300 }
  const larger = {
    ...begin.setup,
    problem: setupFrom(`S${'.'.repeat(39)}\n${'.'.repeat(39)}G`).problem,
  }

  it('is fitted anew when the window changes, until it is moved by hand', () => {
    const fitted = layOut(begin, screen, [], true)
    expect(fitted.view).not.toEqual(begin.view)
    const byHand = look(fitted, { scale: 20, left: 5, top: 5 })
    expect(layOut(byHand, { width: 500, height: 300 }, [], true).view).toEqual(byHand.view)
  })

  it('stays when a card grows by itself', () => {
    const fitted = layOut(begin, screen, [], true)
    const card = { left: 0, top: 0, width: 100, height: 300 }
    expect(layOut(fitted, screen, [card], false).view).toEqual(fitted.view)
    expect(layOut(fitted, screen, [card], true).view.left).toBeGreaterThanOrEqual(100)
  })

  it('is fitted when undo brings a map of another size', () => {
    let state = layOut(begin, screen, [], true)
    const { view } = state
    state = changeMap(state, larger, 'New.')
    expect(state.view.scale).toBeLessThan(view.scale)
    expect(undo(state).view).toEqual(view)
  })
})

describe('a plan', () => {
  const shown = planned(begin.setup)
  const running = planStarted(begin)

  it('settles what it answers', () => {
    const state = planArrived(running, shown)
    expect(isSettled(state)).toBe(true)
    expect(visiblePlan(state)).toBe(shown)
  })

  it('that was overtaken is shown, but settles nothing', () => {
    const state = planArrived(planStarted(edit(begin, moved(begin, 9))), shown)
    expect(isSettled(state)).toBe(false)
    expect(state.run.kind).toBe('running')
    expect(visiblePlan(state)).toBe(shown)
  })

  it('for a map of another size is not shown', () => {
    const other = { ...begin.setup, problem: setupFrom('S.\n.G').problem }
    expect(visiblePlan(edit(planArrived(running, shown), other))).toBeNull()
  })

  it('makes place for one that takes long, is cancelled or fails', () => {
    const again = planStarted(planArrived(running, shown))
    expect(visiblePlan(again)).toBe(shown)
    expect(visiblePlan(planIsSlow(again))).toBeNull()
    // One that takes the place of a slow one does not bring the old plan back for a moment.
    expect(visiblePlan(planStarted(planIsSlow(again)))).toBeNull()
    expect(visiblePlan(planCancelled(again))).toBeNull()
    const failed = planFailed(again, begin.setup, 'No.')
    expect(failed.run).toEqual({ kind: 'failed', message: 'No.' })
    expect(visiblePlan(failed)).toBeNull()
  })

  it('that failed for an older setup is of no interest', () => {
    const edited = planStarted(edit(begin, moved(begin, 9)))
    expect(planFailed(edited, begin.setup, 'No.')).toBe(edited)
  })

  it('is hidden by "clear path" until the next edit', () => {
    const hidden = hidePath(planArrived(running, shown))
    expect(visiblePlan(hidden)).toBeNull()
    expect(visiblePlan(edit(hidden, moved(hidden, 9)))).toBe(shown)
  })

  it('is shown again by undo, which takes back nothing else', () => {
    const drawn = change(begin, moved(begin, 9), 'Drawn.')
    const back = undo(hidePath({ ...drawn, shown }))
    expect(visiblePlan(back)).toBe(shown)
    expect(back).toMatchObject({ setup: drawn.setup, history: drawn.history })
    expect(undo(back).setup).toEqual(begin.setup)
  })

  it('is hidden again by redo, unless there was an edit since', () => {
    const shownAgain = undo(hidePath(planArrived(running, shown)))
    const hidden = redo(shownAgain)
    expect(visiblePlan(hidden)).toBeNull()
    expect(visiblePlan(undo(hidden))).toBe(shown)
    const edited = change(shownAgain, moved(shownAgain, 9), 'Moved.')
    expect(redo(edited).clearPath).toBe('no')
  })
})

it('what stays as it was makes no new state: nothing would be drawn anew but in vain', () => {
  expect(hover(begin, begin.hovered)).toBe(begin)
  expect(crowd(begin, begin.crowded)).toBe(begin)
  expect(prefer(begin, { ...begin.preferences })).toBe(begin)
  expect(hover(begin, 3).hovered).toBe(3)
  expect(crowd(begin, true).crowded).toBe(true)
  expect(prefer(begin, { hint: false }).preferences.hint).toBe(false)
})

it('the cell that is asked about is that under the mouse, else that of the cursor', () => {
  const asked = (hovered: number, cursorShown: boolean) =>
    cellAskedAbout({ ...begin, hovered, cursorShown, cursor: 5 })
  expect([asked(3, false), asked(3, true), asked(0, true)]).toEqual([3, 3, 0])
  expect([asked(-1, false), asked(-1, true)]).toEqual([-1, 5])
})

describe('messages', () => {
  it('are the latest three, each once, and can be dismissed', () => {
    const told = (...texts: string[]) =>
      texts.reduce((state, text) => tell(state, 'error', text), begin)
    expect(told('a', 'b', 'a').messages.map((message) => message.text)).toEqual(['b', 'a'])
    const state = told('a', 'b', 'a', 'c', 'd')
    expect(state.messages.map((message) => message.text)).toEqual(['a', 'c', 'd'])
    const ids = state.messages.map((message) => message.id)
    expect(new Set(ids).size).toBe(3)
    expect(dismiss(state, ids[1]).messages.map((message) => message.text)).toEqual(['a', 'd'])
  })

  it('of work stay as long as it lasts, however many come', () => {
    const working = tell(begin, 'work', 'Saving…')
    const state = ['a', 'b', 'c', 'd'].reduce((state, text) => tell(state, 'note', text), working)
    expect(state.messages.map((message) => message.text)).toEqual(['Saving…', 'c', 'd'])
  })

  it('of work say how much of it is done, by the hundredth', () => {
    const working = tell(tell(begin, 'note', 'a'), 'work', 'Saving…')
    const [, { id }] = working.messages
    const state = workProgressed(working, id, 0.2549)
    expect(state.messages.map(({ done }) => done)).toEqual([undefined, 0.25])
    expect(workProgressed(state, id, 0.2451)).toBe(state)
    expect(workProgressed(state, id, 0.26).messages[1].done).toBe(0.26)
    const closed = dismiss(state, id)
    expect(workProgressed(closed, id, 0.5)).toBe(closed)
  })

  it('never have the id of one that is gone', () => {
    const first = tell(begin, 'note', 'a')
    const [{ id }] = first.messages
    const second = tell(dismiss(first, id), 'note', 'b')
    expect(second.messages[0].id).not.toBe(id)
  })

  it('about maps that could not be had go when one is there', () => {
    let state = tell(tell(begin, 'error', 'broken'), 'note', 'by the way')
    state = changeMap(state, { ...state.setup, problem: setupFrom('S.\n.G').problem }, 'New.')
    expect(state.messages.map((message) => message.text)).toEqual(['by the way'])
  })

  it('about the map as it was go with the next change, and others stay', () => {
    const told = tellOfMap(tell(begin, 'note', 'by the way'), 'note', 'Undo brings it back.')
    const texts = (state: State) => state.messages.map(({ text }) => text)
    expect(texts(hover(told, 2))).toEqual(['by the way', 'Undo brings it back.'])
    const changed = change(told, moved(told, 9), 'Moved.')
    expect(texts(changed)).toEqual(['by the way'])
    expect(texts(undo(tellOfMap(changed, 'note', 'Here is the goal.')))).toEqual(['by the way'])
  })
})
