import {
  stepBack,
  stepForward,
  toFirst,
  togglePlay,
  toLandmarkBefore,
  toLast,
  toNextLandmark,
} from '../playback/transport'
import type { Transition } from '../state/state'
import type { KeyPress } from './keys'

/**
 * Where a key was pressed, as far as it matters: on the map while its cell cursor is on show, on the
 * scrubber, which steps with its own keys, on a button, which Space presses, or anywhere else, the
 * map without cursor included. In text fields and lists no key belongs to the playback.
 */
export type KeyPlace = 'cursor' | 'scrubber' | 'button' | 'elsewhere'

const EVERYWHERE: Readonly<Record<string, Transition>> = {
  k: togglePlay,
  ',': stepBack,
  '.': stepForward,
  'Shift+ArrowLeft': toLandmarkBefore,
  'Shift+ArrowRight': toNextLandmark,
  PageUp: toLandmarkBefore,
  PageDown: toNextLandmark,
  Home: toFirst,
  End: toLast,
}

/** Where arrows move nothing else. */
const ARROWS: Readonly<Record<string, Transition>> = {
  ArrowLeft: stepBack,
  ArrowRight: stepForward,
}

/**
 * What a key does to the playback; `null` if nothing. Space counts when it goes up, because it
 * takes hold of the map while it is held down.
 */
export function playbackKey({ key, command, shift }: KeyPress, place: KeyPlace): Transition | null {
  if (command) return null
  const name = key.length === 1 ? key.toLowerCase() : shift ? `Shift+${key}` : key
  if (name === ' ') return place === 'elsewhere' || place === 'scrubber' ? togglePlay : null
  if (Object.hasOwn(EVERYWHERE, name)) return EVERYWHERE[name]
  const stepsWithArrows = place === 'elsewhere' || place === 'button'
  return stepsWithArrows && Object.hasOwn(ARROWS, name) ? ARROWS[name] : null
}
