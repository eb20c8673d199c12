import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { defaultPreferences } from '../../../src/app/state/preferences'
import type { Setup } from '../../../src/app/state/setup'
import {
  loadPreferences,
  loadSetup,
  type Shelf,
  savePreferences,
  saveSetup,
  setupToText,
} from '../../../src/app/storage/storage'
import { setupFrom } from '../setups'

function shelf(content: Record<string, string> = {}): Shelf & { content: Record<string, string> } {
  return {
    content,
    getItem: (key) => content[key] ?? null,
    setItem(key, value) {
      content[key] = value
    },
  }
}

const forbidden: Shelf = {
  getItem() {
    throw new Error('denied')
  },
  setItem() {
    throw new Error('full')
  },
}

const setup: Setup = {
  ...setupFrom('S.#\n.#G', 'bug2'),
  params: { bug2: { leave: 'closer' } },
  seed: 42,
}

const KEY = 'path-planner.setup'
const withEntry = (change: (entry: Record<string, unknown>) => void): Shelf => {
  const entry = JSON.parse(setupToText(setup))
  change(entry)
  return shelf({ [KEY]: JSON.stringify(entry) })
}

describe('what is kept for the next visit', () => {
  it('comes back as it was', () => {
    const kept = shelf()
    expect(saveSetup(kept, setup)).toBe(true)
    const loaded = loadSetup(kept)
    expect(loaded.kind === 'setup' && setupToText(loaded.setup)).toBe(setupToText(setup))
  })

  it('comes back with any obstacles', () => {
    const walls = fc.uint8Array({ min: 0, max: 1, minLength: 63, maxLength: 63 })
    fc.assert(
      fc.property(walls, (drawn) => {
        const free = Uint8Array.from(drawn)
        free[0] = free[62] = 0
        const problem = {
          grid: { width: 9, height: 7, walls: free },
          start: 0,
          goal: 62,
          diagonal: 'only-when-no-obstacles' as const,
        }
        const kept = shelf()
        saveSetup(kept, { ...setup, problem })
        const loaded = loadSetup(kept)
        expect(loaded.kind === 'setup' ? loaded.setup.problem : null).toEqual(problem)
      }),
    )
  })

  it('is nothing on a first visit and where storage is forbidden', () => {
    expect(loadSetup(shelf())).toEqual({ kind: 'nothing' })
    expect(loadSetup(forbidden)).toEqual({ kind: 'nothing' })
    expect(loadSetup(null)).toEqual({ kind: 'nothing' })
  })

  it('is known to be lost where storage is full or forbidden', () => {
    expect(saveSetup(forbidden, setup)).toBe(false)
    expect(saveSetup(null, setup)).toBe(false)
  })

  it.each([
    ['no JSON', shelf({ [KEY]: '{"version":1,' })],
    ['another version', withEntry((entry) => Object.assign(entry, { version: 2 }))],
    ['a side that is too long', withEntry((entry) => Object.assign(entry, { width: 1e9 }))],
    ['too few obstacles', withEntry((entry) => Object.assign(entry, { walls: '' }))],
    ['obstacles that are no Base64', withEntry((entry) => Object.assign(entry, { walls: '§§§§' }))],
    ['a start on an obstacle', withEntry((entry) => Object.assign(entry, { start: 2 }))],
    ['a goal outside the map', withEntry((entry) => Object.assign(entry, { goal: 6 }))],
    ['an unknown rule', withEntry((entry) => Object.assign(entry, { diagonal: 'never' }))],
    ['an unknown planner', withEntry((entry) => Object.assign(entry, { plannerId: 'teleport' }))],
    ['a seed that is a text', withEntry((entry) => Object.assign(entry, { seed: '1' }))],
    ['nothing but null', shelf({ [KEY]: 'null' })],
  ])('is seen to be broken: %s', (_, broken) => {
    expect(loadSetup(broken).kind).toBe('broken')
  })

  it('loses parameters that are not declared any more, and values that do not fit any more', () => {
    const old = withEntry((entry) => {
      entry.params = { bug2: { leave: 'closer', speed: 3, turn: 'up' }, gone: { a: 1 } }
    })
    const loaded = loadSetup(old)
    const params = loaded.kind === 'setup' ? loaded.setup.params : {}
    expect(params).toEqual({ bug2: { leave: 'closer' } })
  })
})

describe('preferences', () => {
  it('come back as they were', () => {
    const kept = shelf()
    const preferences = {
      theme: 'light',
      showPotential: false,
      hint: false,
      speed: 'moment',
      sight: 'known',
    } as const
    savePreferences(kept, preferences)
    expect(loadPreferences(kept)).toEqual(preferences)
  })

  it('that were not kept yet are the usual ones', () => {
    const kept = { theme: 'light', showPotential: false, hint: false } as const
    const old = shelf({ 'path-planner.preferences': JSON.stringify(kept) })
    expect(loadPreferences(old)).toEqual({ ...defaultPreferences, ...kept })
  })

  it('are the usual ones where nothing can be read', () => {
    const broken = shelf({ 'path-planner.preferences': '{"theme":"pink"}' })
    for (const from of [null, forbidden, shelf(), broken]) {
      expect(loadPreferences(from)).toEqual(defaultPreferences)
    }
  })
})
