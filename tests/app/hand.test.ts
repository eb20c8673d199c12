import { beforeEach, describe, expect, it } from 'vitest'
import type { State } from '../../src/app/state/state'
import { createStore, type Store } from '../../src/app/state/store'
import { change, changeMap, look, undo } from '../../src/app/state/transitions'
import { Hand, type Press } from '../../src/app/tools/hand'
import { emptyGrid, type Point } from '../../src/grid/grid'
import { obstaclesOf, setupFrom, stateFrom } from './setups'

let store: Store<State>
let hand: Hand

/** The middle of a cell on the screen. */
const at = (x: number, y: number): Point => ({ x: x * 40 + 20, y: y * 40 + 20 })

function press(place: Point, some: Partial<Press> = {}): void {
  hand.press({ id: 1, place, button: 'main', isTouch: false, ...some })
}

const move = (...places: Point[]) => hand.move(1, places)
const release = () => hand.release(1, true)
const cells = (...places: readonly (readonly [number, number])[]) =>
  places.map(([x, y]) => y * 6 + x)
const obstacles = () => obstaclesOf(store.state.setup)

beforeEach(() => {
  store = createStore(
    stateFrom(`
      S.....
      ......
      ..##..
      .....G
    `),
  )
  hand = new Hand(store)
})

describe('the main button', () => {
  it('draws from a free cell on, without holes, and that is one step to undo', () => {
    press(at(0, 1))
    move(at(3, 1))
    move(at(5, 1), at(5, 2))
    release()
    expect(obstacles()).toEqual(
      cells([0, 1], [1, 1], [2, 1], [3, 1], [4, 1], [5, 1], [2, 2], [3, 2], [5, 2]),
    )
    expect(store.state.said.text).toBe('7 cells are now obstacles.')
    store.update(undo)
    expect(obstacles()).toEqual(cells([2, 2], [3, 2]))
    expect(store.state.history.past).toEqual([])
  })

  it('makes no new map where it changes nothing', () => {
    press(at(0, 1))
    move(at(3, 1))
    const { setup } = store.state
    move(at(1, 1), at(0, 0))
    expect(store.state.setup).toBe(setup)
  })

  it('draws a single cell with a click', () => {
    press(at(4, 1))
    release()
    expect(store.state.said.text).toBe('(4, 1) is now an obstacle.')
  })

  it('erases from an obstacle on', () => {
    press(at(2, 2))
    move(at(5, 2))
    release()
    expect(obstacles()).toEqual([])
    expect(store.state.said.text).toBe('2 cells are now free.')
  })

  it('says of many cells how many, as all numbers are written', () => {
    const problem = { ...store.state.setup.problem, start: 0, goal: 1, grid: emptyGrid(2048, 4) }
    store.update((state) => change(state, { ...state.setup, problem }, 'Made.'))
    store.update((state) => look(state, { scale: 40, left: 0, top: 0 }))
    press(at(0, 1))
    move(at(2047, 1))
    release()
    expect(store.state.said.text).toBe('2,048 cells are now obstacles.')
  })

  it('goes around start and goal, and goes on after having left the map', () => {
    press(at(5, 0))
    move(at(0, 0))
    move(at(-3, 0))
    move(at(-3, 3))
    move(at(1, 3))
    release()
    expect(obstacles()).toEqual(
      cells([1, 0], [2, 0], [3, 0], [4, 0], [5, 0], [2, 2], [3, 2], [0, 3], [1, 3]),
    )
  })

  it('drags the goal, which stays at the last free cell', () => {
    press(at(5, 3))
    move(at(4, 3), at(4, 2), at(3, 2))
    expect(store.state.setup.problem.goal).toBe(cells([4, 2])[0])
    move(at(3, 1))
    expect(store.state.setup.problem.goal).toBe(cells([3, 1])[0])
    move(at(3, -5))
    release()
    expect(store.state.setup.problem.goal).toBe(cells([3, 0])[0])
    expect(store.state.history.past.length).toBe(1)
    expect(obstacles()).toEqual(cells([2, 2], [3, 2]))
  })

  it('drags the map from outside it', () => {
    press({ x: 300, y: 300 })
    move({ x: 310, y: 340 })
    release()
    expect(store.state.view).toEqual({ scale: 40, left: 10, top: 40 })
    expect(store.state.fitted).toBe(false)
  })

  it('takes everything back when it is broken off', () => {
    const { setup } = store.state
    press(at(0, 1))
    move(at(5, 1))
    expect(hand.cancel()).toBe(true)
    expect(store.state.setup).toBe(setup)
    move(at(5, 3))
    release()
    expect(store.state.setup).toBe(setup)
    expect(store.state.history.past).toEqual([])
    expect(hand.cancel()).toBe(false)
  })
})

describe('a map that is opened meanwhile', () => {
  const open = () =>
    store.update((state) => changeMap(state, setupFrom('S###\n.###\n.###\n...G'), 'Opened.'))

  it.each([
    ['a stroke', at(1, 0)],
    ['a mark that is dragged', at(0, 0)],
    ['a map that is dragged', { x: 300, y: 300 }],
  ])('ends %s', (_, from) => {
    press(from)
    move(at(2, 1))
    open()
    const { setup, view } = store.state
    // From corner to corner of the screen.
    move({ x: 800, y: 0 }, { x: 0, y: 600 })
    release()
    expect(store.state.setup).toBe(setup)
    expect(store.state.view).toBe(view)
    expect(hand.isBusy).toBe(false)
  })

  it('ends what two fingers do', () => {
    hand.press({ id: 1, place: at(1, 1), button: 'main', isTouch: true })
    hand.press({ id: 2, place: at(3, 1), button: 'main', isTouch: true })
    hand.move(2, [at(4, 1)])
    open()
    const { view } = store.state
    hand.move(2, [at(2, 1)])
    expect(store.state.view).toBe(view)
    expect(hand.isBusy).toBe(false)
  })

  it('leaves the stroke before it as a step to undo', () => {
    press(at(1, 0))
    move(at(2, 0))
    open()
    release()
    store.update(undo)
    expect(obstacles()).toEqual(cells([1, 0], [2, 0], [2, 2], [3, 2]))
    store.update(undo)
    expect(obstacles()).toEqual(cells([2, 2], [3, 2]))
  })
})

describe('the other buttons and Space', () => {
  it.each([
    ['the middle button', () => press(at(1, 1), { button: 'middle' })],
    [
      'Space',
      () => {
        hand.spaceHeld = true
        press(at(1, 1))
      },
    ],
  ])('%s drags the map', (_, begin) => {
    begin()
    move(at(3, 2))
    release()
    expect(store.state.view).toEqual({ scale: 40, left: 80, top: 40 })
    expect(obstacles()).toEqual(cells([2, 2], [3, 2]))
  })

  it('Space has been used once the map was dragged with it, and does nothing else then', () => {
    press(at(1, 1), { button: 'middle' })
    release()
    expect(hand.spaceUsed).toBe(false)
    hand.spaceHeld = true
    press(at(1, 1))
    expect(hand.spaceUsed).toBe(true)
  })

  it('the right button sets the start, then the goal, and so on', () => {
    const click = (x: number, y: number) => {
      press(at(x, y), { button: 'right' })
      release()
    }
    click(1, 1)
    click(0, 0)
    click(0, 3)
    expect(store.state.setup.problem).toMatchObject({
      start: cells([0, 3])[0],
      goal: cells([0, 0])[0],
    })
    expect(store.state.history.past.length).toBe(3)
  })

  it('the right button is refused on an obstacle, in words, and asks again', () => {
    press(at(2, 2), { button: 'right' })
    release()
    const [message] = store.state.messages
    expect(message.text).toBe('The start cannot be set at (2, 2): an obstacle is there.')
    press(at(1, 1), { button: 'right' })
    expect(store.state.setup.problem.start).toBe(cells([1, 1])[0])
  })
})

describe('two fingers', () => {
  const finger = (id: number, place: Point) =>
    hand.press({ id, place, button: 'main', isTouch: true })

  it('zoom and move the map, and take back what the first one has drawn', () => {
    const { setup } = store.state
    finger(1, at(1, 1))
    hand.move(1, [at(1, 0)])
    expect(store.state.setup).not.toBe(setup)
    finger(2, at(3, 0))
    expect(store.state.setup).toBe(setup)
    hand.move(1, [at(1, 0)])
    hand.move(2, [at(4, 0)])
    // What lay under each finger lies there still.
    expect(store.state.view).toEqual({ scale: 60, left: -30, top: -10 })
    const { view } = store.state
    hand.release(2, true)
    hand.move(1, [at(5, 3)])
    hand.release(1, true)
    expect(store.state.view).toEqual(view)
    expect(store.state.setup).toBe(setup)
  })

  it('at the largest scale move the map and leave its scale alone, though they move one by one', () => {
    finger(1, at(1, 1))
    finger(2, at(1, 2))
    hand.move(2, [at(1, 9)])
    hand.release(1, true)
    hand.release(2, true)
    const { scale, left, top } = store.state.view
    finger(1, at(1, 6))
    finger(2, at(1, 9))
    hand.move(1, [at(1, 4)])
    hand.move(2, [at(1, 7)])
    expect(store.state.view).toEqual({ scale, left, top: top - 80 })
  })

  it('take back what they have zoomed when they come back, beyond the limits too', () => {
    const { view } = store.state
    finger(1, at(1, 1))
    finger(2, at(1, 2))
    hand.move(2, [at(1, 12)])
    hand.move(2, [at(1, 2)])
    expect(store.state.view).toEqual(view)
  })

  it('may begin at one place', () => {
    finger(1, at(1, 1))
    finger(2, at(1, 1))
    hand.move(2, [at(1, 1)])
    expect(store.state.view).toEqual({ scale: 40, left: 0, top: 0 })
    hand.move(2, [at(2, 1)])
    expect(store.state.view.scale).toBeGreaterThan(40)
  })

  it('are forgotten when they are lifted: one finger draws again', () => {
    finger(1, at(1, 1))
    finger(2, at(4, 1))
    hand.release(1, true)
    hand.release(2, true)
    finger(3, at(0, 1))
    hand.release(3, true)
    expect(store.state.said.text).toBe('(0, 1) is now an obstacle.')
  })
})
