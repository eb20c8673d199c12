import { spawnSync } from 'node:child_process'
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, expect, test } from 'vitest'
import { whileLocked } from '../../src/cli/lock'
import { InputError } from '../../src/grid/errors'

const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
afterAll(() => rmSync(folder, { recursive: true }))

const path = join(folder, 'rows.jsonl')
const never = () => Promise.reject(new Error('this must not be done'))
const isTaken = async () => {
  const error = await whileLocked(path, never).catch((thrown: unknown) => thrown)
  return error instanceof InputError && error.message.includes(`process ${process.pid}, writes to`)
}

test('a file is written to by one at a time, and free again also if that fails', async () => {
  await whileLocked(path, async () => {
    expect(await isTaken()).toBe(true)
    expect(await isTaken()).toBe(true)
    await whileLocked(`${path}.other`, async () => {})
  })
  await expect(whileLocked(path, never)).rejects.toThrow('this must not be done')
  expect(readdirSync(folder)).toEqual([])
})

const { pid } = spawnSync(process.execPath, ['--version'])

test.each([
  ['one that was killed', String(pid)],
  ['a lock that a power cut left empty', ''],
  ['a lock that names no process', '-1'],
])('%s keeps nobody from the file', async (_, left) => {
  writeFileSync(`${path}.lock`, left)
  await whileLocked(path, async () => expect(await isTaken()).toBe(true))
  expect(readdirSync(folder)).toEqual([])
})
