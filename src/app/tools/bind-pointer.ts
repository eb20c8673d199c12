import type { Point } from '../../grid/grid'
import { cellAt, zoomAt } from '../../render/view'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { hover, look } from '../state/transitions'
import type { Hand, Press } from './hand'
import { gripAt } from './stroke'

const BUTTONS: Readonly<Record<number, Press['button']>> = { 0: 'main', 1: 'middle', 2: 'right' }

const ZOOM_PER_PIXEL = 0.0015
/** Two fingers on a touchpad report small distances, with Ctrl. */
const ZOOM_PER_PINCHED_PIXEL = 0.01
const PIXELS_PER_LINE = 24

/** Binds the pointers and the wheel to the map. A press gives it the focus with `focus`. */
export function bindPointer(
  host: HTMLElement,
  store: Store<State>,
  hand: Hand,
  focus: () => void,
): void {
  const on = <Type extends keyof HTMLElementEventMap>(
    type: Type,
    listener: (event: HTMLElementEventMap[Type]) => void,
  ) => host.addEventListener(type, listener, { passive: false })

  on('pointerdown', (event) => {
    const button = BUTTONS[event.button]
    // A press beside an open menu only closes it.
    if (button === undefined || document.querySelector(':popover-open')) return
    // Without this the middle button scrolls and a press selects text.
    event.preventDefault()
    focus()
    host.setPointerCapture(event.pointerId)
    const isTouch = event.pointerType === 'touch'
    store.update((state) => hover(state, -1))
    hand.press({ id: event.pointerId, place: placeOf(event), button, isTouch })
  })
  on('pointermove', (event) => {
    // Not every browser has it.
    const events = event.getCoalescedEvents?.() ?? []
    hand.move(event.pointerId, (events.length > 0 ? events : [event]).map(placeOf))
    if (hand.isBusy) return
    const { view, setup } = store.state
    const { x, y } = placeOf(event)
    const cell = cellAt(view, setup.problem.grid, x, y)
    host.dataset.grip = gripAt(setup.problem, cell)
    if (event.pointerType === 'mouse') store.update((state) => hover(state, cell))
  })
  on('pointerleave', () => store.update((state) => hover(state, -1)))
  on('pointerup', (event) => hand.release(event.pointerId, true))
  on('pointercancel', (event) => hand.release(event.pointerId, false))
  on('lostpointercapture', (event) => hand.release(event.pointerId, true))
  on('contextmenu', (event) => event.preventDefault())
  on('wheel', (event) => {
    event.preventDefault()
    const perPixel = event.ctrlKey ? ZOOM_PER_PINCHED_PIXEL : ZOOM_PER_PIXEL
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : PIXELS_PER_LINE
    const factor = Math.exp(-event.deltaY * unit * perPixel)
    const { x, y } = placeOf(event)
    store.update((state) => look(state, zoomAt(state.view, factor, x, y, state.setup.problem.grid)))
  })
}

const placeOf = ({ clientX, clientY }: MouseEvent): Point => ({ x: clientX, y: clientY })
