import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { blobInSlices } from '../../../src/app/files/in-slices'
import { type ShownWork, showWork } from '../../../src/app/files/shown-work'
import { dismiss, type WithMessages } from '../../../src/app/state/messages'
import { createStore } from '../../../src/app/state/store'

let now = 0

beforeEach(() => {
  now = 0
  vi.spyOn(performance, 'now').mockImplementation(() => now)
})
afterEach(() => {
  vi.restoreAllMocks()
  vi.useRealTimers()
})

const begin = () => createStore<WithMessages>({ messages: [], messagesTold: 0 })

describe('work that is shown', () => {
  test('has a message once it lasts, with its progress, and none when it is done', async () => {
    const store = begin()
    const shown: unknown[] = []
    const work = async ({ progress }: ShownWork) => {
      for (const [time, done] of [
        [200, 0.1],
        [201, 0.2],
        [400, 0.204],
        [900, 0.9],
      ]) {
        now = time
        progress(done)
        shown.push(store.state.messages.map(({ kind, text, done }) => [kind, text, done]))
      }
      return 'result'
    }
    expect(await showWork(store, 'Working…', work)).toBe('result')
    const message = (done: number) => [['work', 'Working…', done]]
    expect(shown).toEqual([[], message(0.2), message(0.2), message(0.9)])
    expect(store.state.messages).toEqual([])
  })

  test('is cancelled by closing its message, in slices between which the page goes on', async () => {
    const store = begin()
    let written = 0
    function* parts({ progress }: ShownWork): Generator<string, void, void> {
      for (;;) {
        now += 5
        written++
        progress(0.5)
        yield 'part'
      }
    }
    const unsubscribe = store.subscribe(({ messages }) => {
      // Not at once: another task has to get its turn.
      if (messages.some(({ kind }) => kind === 'work'))
        setTimeout(() => store.update((state) => dismiss(state, 1)))
    })
    const work = (shown: ShownWork) => blobInSlices(parts(shown), shown.signal)
    expect(await showWork(store, 'Working…', work)).toBeNull()
    unsubscribe()
    const before = written
    await new Promise((resolve) => setTimeout(resolve))
    expect(written).toBe(before)
    expect(store.state.messages.map(({ text }) => text)).toEqual(['Cancelled.'])
  })

  test('has a message though it does not say how far it is, and ends cancelled', async () => {
    const store = begin()
    vi.useFakeTimers()
    const working = showWork(store, 'Working…', async () => {
      await new Promise((resolve) => setTimeout(resolve, 1000))
      return 'result'
    })
    const texts = () => store.state.messages.map(({ text }) => text)
    vi.advanceTimersByTime(199)
    expect(texts()).toEqual([])
    vi.advanceTimersByTime(1)
    expect(texts()).toEqual(['Working…'])
    store.update((state) => dismiss(state, 1))
    vi.advanceTimersByTime(1000)
    expect(await working).toBeNull()
    expect(texts()).toEqual(['Cancelled.'])
  })

  test('that fails does so, and its message goes', async () => {
    const store = begin()
    const work = async ({ progress }: ShownWork) => {
      now = 300
      progress(0.5)
      throw new Error('full')
    }
    await expect(showWork(store, 'Working…', work)).rejects.toThrow('full')
    expect(store.state.messages).toEqual([])
  })
})

test('parts of a text come together whole, over many slices', async () => {
  function* parts(): Generator<string, void, void> {
    for (let i = 0; i < 100; i++) {
      now += i % 7
      yield `${i}é,`
    }
  }
  const blob = await blobInSlices(parts(), new AbortController().signal)
  expect(await blob.text()).toBe(Array.from({ length: 100 }, (_, i) => `${i}é,`).join(''))
})
