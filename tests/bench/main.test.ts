import { afterEach, expect, test, vi } from 'vitest'

afterEach(() => vi.restoreAllMocks())

test('a reader that has seen enough ends the bench, and nothing is said of it', async () => {
  vi.spyOn(process, 'argv', 'get').mockReturnValue(['node', 'bench', '--help'])
  vi.spyOn(process.stdout, 'write').mockReturnValue(true)
  const said = vi.spyOn(process.stderr, 'write').mockReturnValue(true)
  const before = process.stdout.listeners('error')
  await import('../../bench/planners/main')
  const [ends] = process.stdout.listeners('error').filter((one) => !before.includes(one))
  const exit = vi.spyOn(process, 'exit').mockImplementation((code) => {
    throw new Error(`ended with ${code}`)
  })
  expect(() => ends(Object.assign(new Error('write EPIPE'), { code: 'EPIPE' }))).toThrow(
    'ended with 0',
  )
  expect(exit).toHaveBeenCalledTimes(1)
  expect(said).not.toHaveBeenCalled()
})
