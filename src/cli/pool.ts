import { parentPort, Worker, workerData } from 'node:worker_threads'
import { InOrder } from '../experiments/in-order'
import { rowToLine } from '../experiments/results-json'
import { runMap } from '../experiments/run-map'
import type { ExperimentSettings } from '../experiments/settings'
import type { MapRange } from '../experiments/shards'
import { messageOf } from '../grid/errors'

/** The rows of a map as JSON lines, or what went wrong. */
type Answer =
  | { readonly map: number; readonly lines: string }
  | { readonly map: number; readonly error: string }

/** One map that takes long must not let the others pile up. */
const MOST_AHEAD = 1000

interface Job {
  readonly settings: ExperimentSettings
  readonly maps: MapRange
  readonly workers: number
  /** The program that the threads run; it has to call `serve` there. */
  readonly program: URL
  /** Ends the work early. */
  readonly signal: AbortSignal
}

/**
 * Runs maps in threads.
 * @param onMap is called with the JSON lines of one map after the other, in their order
 * @returns a promise that is kept when all are done, or when the signal came, and broken if a map or
 *   `onMap` fails
 */
export async function runMaps(job: Job, onMap: (lines: string) => void): Promise<void> {
  const { settings, maps, workers, program, signal } = job
  const count = Math.min(workers, maps.end - maps.first)
  const threads = Array.from({ length: count }, () => new Worker(program, { workerData: settings }))
  const idle = new Set<Worker>()
  const order = new InOrder(maps.first, onMap)
  let next = maps.first
  const ask = (thread: Worker) => {
    if (next < maps.end && next < order.next + MOST_AHEAD) thread.postMessage(next++)
    else idle.add(thread)
  }
  try {
    await new Promise<void>((resolve, reject) => {
      const answered = (thread: Worker, answer: Answer) => {
        if ('error' in answer) return reject(new Error(`Map ${answer.map}: ${answer.error}`))
        order.add(answer.map, answer.lines)
        if (order.next === maps.end) return resolve()
        ask(thread)
        const waiting = [...idle]
        idle.clear()
        waiting.forEach(ask)
      }
      signal.addEventListener('abort', () => resolve())
      if (signal.aborted || count === 0) resolve()
      for (const thread of threads) {
        thread.on('message', (answer: Answer) => {
          try {
            answered(thread, answer)
          } catch (error) {
            // Thrown by `onMap`: the disk is full, say.
            reject(error)
          }
        })
        thread.on('error', reject)
        thread.on('exit', (code) => reject(new Error(`A thread ended with code ${code}.`)))
        // Two each, so that no thread waits for its next one to be sent.
        ask(thread)
        ask(thread)
      }
    })
  } finally {
    await Promise.all(threads.map((thread) => thread.terminate()))
  }
}

/** What a thread does: runs each map whose number comes. */
export function serve(): void {
  const settings: ExperimentSettings = workerData
  parentPort?.on('message', (map: number) => {
    parentPort?.postMessage(answer(settings, map))
  })
}

function answer(settings: ExperimentSettings, map: number): Answer {
  try {
    const rows = runMap(settings, map, () => performance.now())
    return { map, lines: rows.map((row) => `${rowToLine(row)}\n`).join('') }
  } catch (error) {
    return { map, error: messageOf(error) }
  }
}
