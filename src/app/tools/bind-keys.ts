import type { State } from '../state/state'
import type { Store } from '../state/store'
import type { Hand } from './hand'
import { type KeyPress, mapKey, pageKey } from './keys'
import { type KeyPlace, playbackKey } from './playback-keys'

/** Binds the keys of the map, of the playback and of the whole page. */
export function bindKeys(
  host: HTMLElement,
  store: Store<State>,
  hand: Hand,
  openHelp: () => void,
): void {
  const placeOfKey = (target: EventTarget | null): KeyPlace | null =>
    target === host && store.state.cursorShown ? 'cursor' : keyPlaceOf(target)
  const isOverlaid = () => document.querySelector('dialog[open], :popover-open') !== null

  host.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && hand.cancel()) return
    if (event.key === ' ') return
    const transition = mapKey(keyPressOf(event), store.state.cursorShown)
    if (!transition || (event.key === 'Enter' && event.repeat)) return
    event.preventDefault()
    store.update(transition)
  })

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
  window.addEventListener('blur', letGoOfSpace)
}

const keyPressOf = ({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): KeyPress => ({
  key,
  command: ctrlKey || metaKey,
  shift: shiftKey,
})

/** Such a key would switch on and off again and again while it is held down. */
const isSwitch = ({ key }: KeyPress): boolean => key.toLowerCase() === 'k'

const isTextField = (target: EventTarget | null): boolean =>
  target instanceof Element &&
  target.matches('input:not([type=checkbox], [type=radio], [type=range])')

/** `null` where keys have other uses than the playback. */
function keyPlaceOf(target: EventTarget | null): KeyPlace | null {
  if (!(target instanceof Element)) return 'elsewhere'
  if (isTextField(target) || target.matches('select')) return null
  if (target.matches('[type=range]')) return 'scrubber'
  return target.matches('button, input, a') ? 'button' : 'elsewhere'
}
