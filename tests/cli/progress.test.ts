import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { Progress } from '../../src/cli/progress'

let told: string[]
const wasTerminal = process.stderr.isTTY

beforeEach(() => {
  vi.useFakeTimers()
  told = []
  vi.spyOn(process.stderr, 'write').mockImplementation((text) => told.push(String(text)) > 0)
})

afterEach(() => {
  process.stderr.isTTY = wasTerminal
  vi.restoreAllMocks()
  vi.useRealTimers()
})

/** One more map is done, after so many milliseconds. */
function add(progress: Progress, milliseconds: number): void {
  vi.advanceTimersByTime(milliseconds)
  progress.add()
}

describe('how far the work is', () => {
  test('is told to a file every ten seconds, and at its end', () => {
    process.stderr.isTTY = false
    const progress = new Progress(2000, 0)
    for (let i = 0; i < 1999; i++) add(progress, 10)
    expect(told).toEqual(['1,000 of 2,000 maps, 50 %, 10 s left\n'])
    add(progress, 10)
    expect(told.slice(1)).toEqual(['2,000 of 2,000 maps, 100 %\n'])
    progress.end()
    expect(told).toHaveLength(2)
    expect(progress.done).toBe(2000)
  })

  test('is told on a terminal in one line, which changes five times a second', () => {
    process.stderr.isTTY = true
    const progress = new Progress(100, 0)
    for (let i = 0; i < 8; i++) add(progress, 100)
    expect(told.map((line) => line.slice(0, 4))).toEqual(Array(4).fill('\r\x1b[K'))
    expect(told[0].slice(4)).toBe('2 of 100 maps, 2 %, 10 s left')
    progress.end()
    expect(told.at(-1)).toBe('\n')
  })

  test('leaves an empty terminal as it is', () => {
    process.stderr.isTTY = true
    new Progress(100, 0).end()
    expect(told).toEqual([])
  })

  test('goes on from the maps that were there, at the pace of those that were not', () => {
    process.stderr.isTTY = false
    const progress = new Progress(100, 50)
    add(progress, 10_000)
    expect(told).toEqual(['51 of 100 maps, 51 %, 8 min 10 s left\n'])
  })
})
