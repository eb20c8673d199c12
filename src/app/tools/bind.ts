import type { Point } from '../../grid/grid'
import { cellAt, zoomAt } from '../../render/view'
import type { State } from '../state/state'
import type { Store } from '../state/store'
import { hideCursor, hover, look, moveCursor } from '../state/transitions'
import { Hand, type Press } from './hand'
import { type KeyPress, mapKey, pageKey } from './keys'
import { type KeyPlace, playbackKey } from './playback-keys'
import { gripAt } from './stroke'

const BUTTONS: Readonly<Record<number, Press['button']>> = { 0: 'main', 1: 'middle', 2: 'right' }

const ZOOM_PER_PIXEL = 0.0015
/** Two fingers on a touchpad report small distances, with Ctrl. */
const ZOOM_PER_PINCHED_PIXEL = 0.01
const PIXELS_PER_LINE = 24

/** Binds pointers, wheel and keys to the map: all that listens to the map is here. */
export function bindInput(host: HTMLElement, store: Store<State>, openHelp: () => void): void {
  const hand = new Hand(store)
  let pressed = false
  let windowAway = false
  host.tabIndex = 0

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
    pressed = true
    host.focus({ preventScroll: true })
    pressed = false
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

  on('keydown', (event) => {
    if (event.key === 'Escape' && hand.cancel()) return
    if (event.key === ' ') return
    const transition = mapKey(keyPressOf(event), store.state.cursorShown)
    if (!transition || (event.key === 'Enter' && event.repeat)) return
    event.preventDefault()
    store.update(transition)
  })
  on('focus', () => {
    // With a pointer the cell is under it; only the keyboard needs a cursor. A window that comes
    // back gives the focus back to where it was, however that came.
    const byPointer = pressed || windowAway
    windowAway = false
    if (host.matches(':focus-visible') || !byPointer) {
      store.update((state) => moveCursor(state, state.cursor))
    }
  })
  on('blur', () => store.update((state) => hideCursor(state)))

  const placeOfKey = (target: EventTarget | null): KeyPlace | null =>
    target === host && store.state.cursorShown ? 'cursor' : keyPlaceOf(target)
  const isOverlaid = () => document.querySelector('dialog[open], :popover-open') !== null

  window.addEventListener('keydown', (event) => {
    const place = placeOfKey(event.target)
    // Other listeners that have dealt with a key have prevented its default.
    if (event.defaultPrevented || event.altKey || isOverlaid()) return
    if (event.key === ' ') {
      if (place === null || place === 'button') return
      event.preventDefault()
      if (event.repeat) return
      hand.spaceHeld = true
      hand.spaceUsed = false
      host.dataset.space = 'true'
      return
    }
    if (isTextField(event.target)) return
    if (event.key === '?') openHelp()
    const press = keyPressOf(event)
    const transition = pageKey(press) ?? (place && playbackKey(press, place))
    if (!transition || (event.repeat && isSwitch(press))) return
    event.preventDefault()
    store.update(transition)
  })
  const letGoOfSpace = () => {
    hand.spaceHeld = false
    delete host.dataset.space
  }
  window.addEventListener('keyup', (event) => {
    if (event.key !== ' ' || !hand.spaceHeld) return
    letGoOfSpace()
    const place = placeOfKey(event.target)
    if (hand.spaceUsed || place === null) return
    const press = keyPressOf(event)
    const transition = place === 'cursor' ? mapKey(press, true) : playbackKey(press, place)
    if (transition) store.update(transition)
  })
  window.addEventListener('blur', () => {
    letGoOfSpace()
    windowAway = document.activeElement === host
  })
}

const placeOf = ({ clientX, clientY }: MouseEvent): Point => ({ x: clientX, y: clientY })

const keyPressOf = ({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): KeyPress => ({
  key,
  command: ctrlKey || metaKey,
  shift: shiftKey,
})

/** Such a key would switch on and off again and again while it is held down. */
const isSwitch = ({ key }: KeyPress): boolean => key.toLowerCase() === 'k'

const TEXT_FIELDS = 'input:not([type=checkbox], [type=radio], [type=range])'

const isTextField = (target: EventTarget | null): boolean =>
  target instanceof Element && target.matches(TEXT_FIELDS)

/** `null` where keys have other uses than the playback. */
function keyPlaceOf(target: EventTarget | null): KeyPlace | null {
  if (!(target instanceof Element)) return 'elsewhere'
  if (isTextField(target) || target.matches('select')) return null
  if (target.matches('[type=range]')) return 'scrubber'
  return target.matches('button, input, a') ? 'button' : 'elsewhere'
}
