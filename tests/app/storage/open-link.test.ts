import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { State } from '../../../src/app/state/state'
import { createStore, type Store } from '../../../src/app/state/store'
import { change } from '../../../src/app/state/transitions'
import { linkTo } from '../../../src/app/storage/link'
import { bindLink } from '../../../src/app/storage/open-link'
import { setupFrom, stateFrom } from '../setups'

const setup = setupFrom('S.#\n.#G', 'bug2')
let store: Store<State>
let page: EventTarget & { location: { hash: string; pathname: string; search: string } }

/** An address with this last part, in a page that has nothing else. */
function openAt(hash: string): void {
  const location = { hash, pathname: '/a/', search: '?b' }
  const history = {
    replaceState(_: unknown, __: string, address: string) {
      location.hash = ''
      expect(address).toBe('/a/?b')
    },
  }
  page = Object.assign(new EventTarget(), { location, history })
  vi.stubGlobal('window', page)
}

function follow(hash: string): void {
  page.location.hash = hash
  page.dispatchEvent(new Event('hashchange'))
}

const edit = (seed: number) =>
  store.update((state) => change(state, { ...state.setup, seed }, 'Changed.'))

beforeEach(() => {
  store = createStore(stateFrom('S..\n..G'))
})

afterEach(() => vi.unstubAllGlobals())

describe('a page that is opened by a link', () => {
  it('shows its setup, and knows it as the link’s until it is changed', () => {
    openAt(linkTo(setup))
    const isLinked = bindLink(store)
    const opened = store.state.setup
    expect(opened).toEqual(setup)
    expect(isLinked(opened)).toBe(true)
    expect(isLinked({ ...opened })).toBe(false)
    // A reload would open it again.
    expect(page.location.hash).not.toBe('')
    expect(store.state.messages).toHaveLength(1)
    edit(2)
    // Undo does not bring back any more what was here before the link.
    expect(store.state.messages).toEqual([])
    expect(isLinked(opened)).toBe(false)
    expect(page.location.hash).toBe('')
  })

  it('opens another link that is followed later', () => {
    openAt(linkTo(setup))
    const isLinked = bindLink(store)
    const first = store.state.setup
    follow(linkTo({ ...setup, seed: 3 }))
    expect(store.state.setup.seed).toBe(3)
    expect([isLinked(first), isLinked(store.state.setup)]).toEqual([false, true])
    expect(page.location.hash).not.toBe('')
  })

  it('says to whoever hears of the new setup that it is the link’s', () => {
    openAt('')
    const isLinked = bindLink(store)
    const heard: boolean[] = []
    store.subscribe(({ setup: now }) => heard.push(isLinked(now)))
    follow(linkTo(setup))
    expect(heard).toEqual([true])
  })

  it('takes a link that is broken out of its address, and stays as it is', () => {
    openAt('#setup=nonsense')
    const before = store.state.setup
    const isLinked = bindLink(store)
    expect(store.state.setup).toBe(before)
    expect(isLinked(before)).toBe(false)
    expect(page.location.hash).toBe('')
    expect(store.state.messages).toHaveLength(1)
  })

  it('leaves an address without a last part alone', () => {
    openAt('')
    const replaced = vi.spyOn(window.history, 'replaceState')
    const isLinked = bindLink(store)
    edit(2)
    expect(replaced).not.toHaveBeenCalled()
    expect(store.state.messages).toEqual([])
    expect(isLinked(store.state.setup)).toBe(false)
  })
})
