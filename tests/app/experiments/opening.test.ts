import { expect, it } from 'vitest'
import { openingText } from '../../../src/app/experiments/open-files'
import { saveSettings } from '../../../src/experiments/settings-check'
import { settings } from './small-experiment'

it('opening settings rests once they are read, before they are checked', () => {
  const opening = openingText(saveSettings(settings))
  expect(opening.next().done).toBe(false)
  expect(opening.next().done).toBe(true)
  const wrong = openingText(saveSettings({ ...settings, seed: -1 }))
  expect(wrong.next().done).toBe(false)
  expect(() => wrong.next()).toThrow('seed: must be')
})
