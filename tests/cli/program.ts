import { spawn, spawnSync } from 'node:child_process'
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { build } from 'vite'
import { afterAll, beforeAll, vi } from 'vitest'
import { SMALL } from '../experiments/settings'

/** A folder for the program, built as `npm run build` does it, and for the files of the tests. */
const folder = mkdtempSync(join(tmpdir(), 'path-planner-'))
export const pathOf = (name: string): string => join(folder, name)

/** Programs take their time to start on a busy machine. */
const PATIENCE_MS = 5 * 60_000

export function useProgram(): void {
  vi.setConfig({ testTimeout: PATIENCE_MS, hookTimeout: PATIENCE_MS })
  beforeAll(async () => {
    const outDir = pathOf('dist-lib')
    await build({ configFile: 'vite.lib.config.ts', logLevel: 'error', build: { outDir } })
  })
  afterAll(() => rmSync(folder, { recursive: true }))
}

/** Writes a settings file: the small experiment with some fields replaced. */
export function settingsFile(name: string, fields: object = {}): string {
  writeFileSync(pathOf(name), JSON.stringify({ ...SMALL, ...fields }))
  return name
}

const start = (args: readonly string[]) => [pathOf('dist-lib/experiment.js'), ...args]

/** Runs the program in the folder until it ends. */
export function run(...args: string[]) {
  const { status, stdout, stderr } = spawnSync(process.execPath, start(args), {
    cwd: folder,
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
  return { status, stdout, stderr }
}

/** Runs the program with its output going into another one. */
export function runInto(reader: string, ...args: string[]) {
  const pipe = `"$0" "$@" | ${reader}`
  const { stdout, stderr } = spawnSync('sh', ['-c', pipe, process.execPath, ...start(args)], {
    cwd: folder,
    encoding: 'utf8',
  })
  return { stdout, stderr }
}

/** Runs the program with its output going to a file or a device. */
export function runOnto(path: string, ...args: string[]) {
  const file = openSync(path, 'w')
  const { status, stderr } = spawnSync(process.execPath, start(args), {
    cwd: folder,
    encoding: 'utf8',
    stdio: ['ignore', file, 'pipe'],
  })
  closeSync(file)
  return { status, stderr }
}

/** Starts the program and sends it a signal as soon as its output file has so many bytes. */
export async function runUntil(bytes: number, signal: NodeJS.Signals, out: string, args: string[]) {
  const child = spawn(process.execPath, start([...args, '--out', out]), { cwd: folder })
  let stderr = ''
  child.stderr.on('data', (text) => {
    stderr += text
  })
  const ended = new Promise<number | null>((resolve) => child.on('exit', resolve))
  let over = false
  void ended.then(() => {
    over = true
  })
  while (!over && sizeOf(out) < bytes) await new Promise((resolve) => setTimeout(resolve, 2))
  child.kill(signal)
  return { status: await ended, stderr }
}

function sizeOf(name: string): number {
  try {
    return readFileSync(pathOf(name)).length
  } catch {
    return 0
  }
}

/** The text of a rows file, without what another run may change. */
export const timelessText = (text: string): string =>
  text.replaceAll(/"milliseconds":[^}]*/g, '"milliseconds":0')

export const textOf = (name: string): string => readFileSync(pathOf(name), 'utf8')
