import { describe, expect, it } from 'vitest'
import {
  stepBack,
  stepForward,
  toFirst,
  togglePlay,
  toLandmarkBefore,
  toLast,
  toNextLandmark,
} from '../../src/app/playback/transport'
import { type KeyPlace, playbackKey } from '../../src/app/tools/playback-keys'

const PLACES: readonly KeyPlace[] = ['cursor', 'scrubber', 'button', 'elsewhere']

/** What a key does, in each of the places. */
function inPlaces(key: string, more: { shift?: boolean; command?: boolean } = {}) {
  const press = { key, shift: false, command: false, ...more }
  return PLACES.map((place) => playbackKey(press, place))
}

const everywhere = (transition: unknown) => PLACES.map(() => transition)

describe('the keys of the playback', () => {
  it('play and step everywhere, as in video players', () => {
    expect(inPlaces('k')).toEqual(everywhere(togglePlay))
    expect(inPlaces('K', { shift: true })).toEqual(everywhere(togglePlay))
    expect(inPlaces(',')).toEqual(everywhere(stepBack))
    expect(inPlaces('.')).toEqual(everywhere(stepForward))
  })

  it('go to landmarks and to both ends everywhere', () => {
    expect(inPlaces('ArrowLeft', { shift: true })).toEqual(everywhere(toLandmarkBefore))
    expect(inPlaces('ArrowRight', { shift: true })).toEqual(everywhere(toNextLandmark))
    expect(inPlaces('PageUp')).toEqual(everywhere(toLandmarkBefore))
    expect(inPlaces('PageDown')).toEqual(everywhere(toNextLandmark))
    expect(inPlaces('Home')).toEqual(everywhere(toFirst))
    expect(inPlaces('End')).toEqual(everywhere(toLast))
  })

  it('step with arrows where these move neither the cursor nor the scrubber', () => {
    expect(inPlaces('ArrowLeft')).toEqual([null, null, stepBack, stepBack])
    expect(inPlaces('ArrowRight')).toEqual([null, null, stepForward, stepForward])
  })

  it('play with Space where it presses no button and draws no obstacle', () => {
    expect(inPlaces(' ')).toEqual([null, togglePlay, null, togglePlay])
  })

  it('are no others', () => {
    for (const key of ['a', 'Enter', 'ArrowUp', 'ArrowDown', 'Tab', 'F5', 'toString']) {
      expect(inPlaces(key)).toEqual(everywhere(null))
    }
    for (const key of ['k', ',', 'ArrowLeft', 'Home', ' ']) {
      expect(inPlaces(key, { command: true })).toEqual(everywhere(null))
    }
  })
})
