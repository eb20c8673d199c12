import { beforeEach, describe, expect, it } from 'vitest'
import { MISSING_PART } from '../../../src/app/fetched-part'
import { openingFor } from '../../../src/app/files/files'
import type { MapAnswer } from '../../../src/app/files/map-worker'
import { readMap } from '../../../src/app/files/opening-worker'
import { withGrid } from '../../../src/app/state/setup'
import type { State } from '../../../src/app/state/state'
import { createStore, type Store } from '../../../src/app/state/store'
import { change, undo } from '../../../src/app/state/transitions'
import { openMap } from '../../../src/grid/formats/open-map'
import { withCells } from '../../../src/grid/grid'
import { FakeWorker } from '../fake-worker'
import { stateFrom } from '../setups'

const TEXT = 'S..\n.#.\n..G'
const FILE = new File([TEXT], 'small.txt')

let store: Store<State>
let workers: FakeWorker<Blob, MapAnswer>[]
let open: (file: File) => void

const settled = () => new Promise((resolve) => setTimeout(resolve))
const told = () => store.state.messages.map(({ kind, text }) => [kind, text])
const made = (text: string): MapAnswer => ({ kind: 'made', ...openMap(text) })

beforeEach(() => {
  workers = []
  store = createStore(stateFrom('S...\n....\n...G'))
  open = openingFor(store, (file, signal) =>
    readMap(file, signal, () => {
      const worker = new FakeWorker<Blob, MapAnswer>()
      workers.push(worker)
      return worker
    }),
  )
})

describe('opening a file', () => {
  it('is left to a worker, even of a small one; the map comes when that has read it', async () => {
    const before = store.state.setup
    open(FILE)
    await settled()
    expect(workers[0].questions).toEqual([FILE])
    expect(store.state.setup).toBe(before)
    workers[0].say(made(TEXT))
    await settled()
    expect(store.state.setup.problem).toEqual(openMap(TEXT).problem)
    expect(workers[0].isTerminated).toBe(true)
    expect(told()).toEqual([['note', 'Opened small.txt: 3 × 3 cells.']])
    store.update(undo)
    expect(store.state.setup).toEqual(before)
  })

  it('notes what the file left open', async () => {
    open(FILE)
    workers[0].say(made('type octile\nheight 2\nwidth 2\nmap\n..\n..\n'))
    await settled()
    expect(told()).toEqual([
      [
        'note',
        'Opened small.txt: 2 × 2 cells. ' +
          'The file has no start or goal: they were put at (0, 0) and (1, 0). ' +
          'Diagonal steps are now: Only when no obstacles.',
      ],
    ])
  })

  it('that fails says why, and the map stays', async () => {
    const before = store.state.setup
    open(FILE)
    workers[0].say({ kind: 'refused', message: 'The file is empty.' })
    await settled()
    open(FILE)
    workers[1].onerror?.({})
    await settled()
    expect(told()).toEqual([
      ['error', 'small.txt was not opened. The file is empty.'],
      ['error', `small.txt was not opened. ${MISSING_PART}`],
    ])
    expect(store.state.setup).toBe(before)
  })

  it('what is drawn meanwhile stays, and that is told', async () => {
    open(FILE)
    const { setup } = store.state
    const drawn = withGrid(setup, withCells(setup.problem.grid, [5], true))
    store.update((state) => change(state, drawn, ''))
    await settled()
    workers[0].say(made(TEXT))
    await settled()
    expect(store.state.setup).toBe(drawn)
    const words = 'small.txt was not opened, because the map on screen was changed meanwhile.'
    expect(told()).toEqual([['note', words]])
  })

  it('only the file that was asked for last is opened', async () => {
    open(FILE)
    open(new File([], 'last.txt'))
    await settled()
    expect(workers[0].isTerminated).toBe(true)
    workers[1].say(made('S.\n.G'))
    await settled()
    expect(told()).toEqual([['note', 'Opened last.txt: 2 × 2 cells.']])
  })
})
