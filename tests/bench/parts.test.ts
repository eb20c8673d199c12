import { spawnSync } from 'node:child_process'
import { expect, test } from 'vitest'
import { readCommand } from '../../bench/planners/command'
import { benchGenerated } from '../../bench/planners/run'

test('a name that no case has is told, instead of timing nothing', () => {
  const command = readCommand(['--quick', '--only', 'a-stir'])
  expect(() => benchGenerated(command)).toThrow('No case has "a-stir" in its name.')
})

test('a part that the bench of the page does not have is told, instead of measuring nothing', () => {
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    ['bench/page/run.mjs', 'memory', 'drawing'],
    { encoding: 'utf8' },
  )
  expect(stderr).toContain('There is no part "drawing" (there are: opening, ')
  expect([status, stdout]).toEqual([1, ''])
})
