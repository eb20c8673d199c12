import { fileURLToPath } from 'node:url'
import { build, type Rolldown } from 'vite'
import { expect, test } from 'vitest'
import { withoutTape, withoutTapeGiven } from '../../bench/planners/without-tape.mjs'

const FOLDER = new URL('../../src/algorithms/grid-search/', import.meta.url)

async function built(name: string, plugins: ReturnType<typeof withoutTape>[]): Promise<string> {
  const entry = fileURLToPath(new URL(name, FOLDER))
  const [{ output }] = (await build({
    configFile: false,
    logLevel: 'silent',
    plugins,
    build: { write: false, target: 'es2022', lib: { entry, formats: ['es'] } },
  })) as Rolldown.RolldownOutput[]
  return output[0].code
}

test.each(['dijkstra.ts', 'a-star.ts', 'jump-point.ts'])(
  'nothing of the tape is left in %s',
  async (name) => {
    expect(await built(name, [])).toMatch(/tape/)
    const code = await built(name, [withoutTape()])
    expect(code).not.toMatch(/tape|\.write\(/)
  },
)

test('what gives no tape to a search stays as it is', () => {
  const source = 'export const aStar = (task: SearchTask): Found => search(task, false)'
  expect(withoutTapeGiven(source)).toBe(source)
})

test('a search that is given its tape in another way is refused', () => {
  const source =
    'function search(task: SearchTask): Found {\n  const { tape } = task\n  tape?.at(1)\n}'
  expect(() => withoutTapeGiven(source)).toThrow('out of date')
})
