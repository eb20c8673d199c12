import { describe, expect, it } from 'vitest'
import type { State } from '../../src/app/state/state'
import { type KeyPress, mapKey, pageKey, reveal } from '../../src/app/tools/keys'
import { cellInWords } from '../../src/app/words/cell-line'
import { emptyGrid } from '../../src/grid/grid'
import { obstaclesOf, stateFrom } from './setups'

const begin = { ...stateFrom('S..#\n....\n...G'), cursorShown: true }
const hidden = { ...begin, cursorShown: false }

const keyPress = (key: string): KeyPress => {
  const parts = key.split('+')
  const name = parts[parts.length - 1] || '+'
  return { key: name, command: parts.includes('Ctrl'), shift: parts.includes('Shift') }
}

/** The state after these keys on the map. */
function type(state: State, ...keys: string[]): State {
  return keys.reduce((now, key) => {
    const press = keyPress(key)
    const transition = mapKey(press, now.cursorShown) ?? pageKey(press)
    if (!transition) throw new Error(`${key} does nothing`)
    return transition(now)
  }, state)
}

describe('the keyboard on the map', () => {
  it('moves the cursor cell by cell and says what is there', () => {
    let state = type(begin, 'ArrowRight')
    expect(state).toMatchObject({ cursor: 1, cursorShown: true })
    expect(state.said.text).toBe('(1, 0), free.')
    state = type(state, 'ArrowRight', 'ArrowRight')
    expect(state.said.text).toBe('(3, 0), obstacle.')
    state = type(state, 'ArrowRight')
    expect(state.cursor).toBe(3)
    expect(state.said.text).toBe('Edge of the map. (3, 0), obstacle.')
    expect(type(state, 'ArrowDown', 'ArrowDown').said.text).toBe('(3, 2), goal.')
  })

  it.each([' ', 'Enter'])('draws and erases with "%s"', (key) => {
    let state = type(begin, 'ArrowDown', key)
    expect(obstaclesOf(state.setup)).toEqual([3, 4])
    expect(state.said).toMatchObject({ text: '(0, 1) is now an obstacle.', followedBy: 'outcome' })
    state = type(state, key)
    expect(obstaclesOf(state.setup)).toEqual([3])
    expect(state.said.text).toBe('(0, 1) is now free.')
  })

  it('shows a hidden cursor before it changes anything there', () => {
    const state = type({ ...hidden, cursor: 5 }, 'Enter')
    expect(state.setup).toBe(begin.setup)
    expect(state).toMatchObject({ cursor: 5, cursorShown: true })
    expect(obstaclesOf(type(state, 'Enter').setup)).toEqual([3, 5])
    for (const key of ['s', 'g']) {
      const shown = type({ ...hidden, cursor: 5 }, key)
      expect(shown.setup).toBe(begin.setup)
      expect(shown).toMatchObject({ cursor: 5, cursorShown: true })
    }
  })

  it('sets start and goal, but not on obstacles', () => {
    const state = type(begin, 'ArrowDown', 's', 'ArrowRight', 'G')
    expect(state.setup.problem).toMatchObject({ start: 4, goal: 5 })
    const refused = type(begin, 'ArrowRight', 'ArrowRight', 'ArrowRight', 's')
    expect(refused.setup).toBe(begin.setup)
    expect(refused.messages[0].text).toBe('(3, 0) is an obstacle: the start cannot be there.')
  })

  it('draws nothing on start and goal, and says why', () => {
    const state = type(begin, 'ArrowRight', 'ArrowLeft', ' ')
    expect(state.setup).toBe(begin.setup)
    expect(state.messages[0].text).toBe('(0, 0) is the start: no obstacle can be there.')
    // Which is not so any more once the start is elsewhere.
    expect(type(state, 'ArrowRight', 's').messages).toEqual([])
  })

  it('undoes and redoes with the usual keys', () => {
    const drawn = type(begin, 'ArrowRight', ' ', 'ArrowDown', ' ')
    const undone = type(drawn, 'Ctrl+z', 'Ctrl+z')
    expect(obstaclesOf(undone.setup)).toEqual([3])
    expect(obstaclesOf(type(undone, 'Ctrl+Shift+Z', 'Ctrl+y').setup)).toEqual([1, 3, 5])
  })

  it('zooms at the cursor, and fits the map again', () => {
    const state = type({ ...begin, cursor: 5, cursorShown: true }, '+')
    expect(state.view.scale).toBeCloseTo(50)
    const { scale, left, top } = state.view
    expect([left + 1.5 * scale, top + 1.5 * scale]).toEqual([60, 60])
    expect(state.said.text).toBe('Zoomed in.')
    const out = type(state, '-')
    expect(out.view.scale).toBeCloseTo(40)
    expect(out.said.text).toBe('Zoomed out.')
    expect(type(state, '0')).toMatchObject({
      fitted: true,
      said: { text: 'The whole map is shown.' },
    })
  })

  it('leaves Space and the sideways arrows to the playback while no cursor is on show', () => {
    for (const key of [' ', 'ArrowLeft', 'ArrowRight']) {
      expect(mapKey(keyPress(key), false)).toBeNull()
      expect(mapKey(keyPress(key), true)).not.toBeNull()
    }
    expect(mapKey(keyPress('Shift+ArrowLeft'), true)).toBeNull()
    expect(type(hidden, 'ArrowDown')).toMatchObject({ cursor: 4, cursorShown: true })
    const escaped = type(begin, 'ArrowDown', 'Escape')
    expect(escaped).toMatchObject({ cursorShown: false, said: { text: 'The cursor is hidden.' } })
    expect(type(escaped, 'Escape')).toBe(escaped)
  })

  it('leaves all other keys alone', () => {
    for (const key of ['a', 'Tab', 'F5', 'Ctrl+s', 'Ctrl+ArrowLeft']) {
      expect(mapKey(keyPress(key), true)).toBeNull()
      expect(pageKey(keyPress(key))).toBeNull()
    }
    expect(pageKey(keyPress('z'))).toBeNull()
  })
})

describe('the view follows the cursor', () => {
  const grid = emptyGrid(50, 50)
  const screen = { width: 200, height: 200 }
  const room = { left: 50, top: 0, width: 150, height: 200 }
  const view = { scale: 10, left: 50, top: 0 }
  const cellFrom = (x: number, y: number) => y * 50 + x

  it('and stays where it is while the cursor can be seen', () => {
    expect(reveal(view, grid, cellFrom(0, 0), room, screen)).toBe(view)
    expect(reveal(view, grid, cellFrom(14, 19), room, screen)).toBe(view)
  })

  it('and moves by as little as shows the cursor and a bit of what is around it', () => {
    expect(reveal(view, grid, cellFrom(15, 5), room, screen)).toEqual({ ...view, left: 20 })
    expect(reveal(view, grid, cellFrom(3, 20), room, screen)).toEqual({ ...view, top: -30 })
    const further = { ...view, left: -100 }
    expect(reveal(further, grid, cellFrom(14, 5), room, screen)).toEqual({ ...view, left: -70 })
  })
})

it('a cell is called by its place and by what is there', () => {
  const { problem } = begin.setup
  const words = [0, 1, 3, 11].map((cell) => cellInWords(problem, cell))
  expect(words).toEqual(['(0, 0), start', '(1, 0), free', '(3, 0), obstacle', '(3, 2), goal'])
  expect(cellInWords({ ...problem, goal: 0 }, 0)).toBe('(0, 0), start and goal')
})
