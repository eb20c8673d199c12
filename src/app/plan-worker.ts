import { plan } from '../algorithms/plan'
import { type Frame, frameAt } from '../trace/frame'
import { Tape } from '../trace/tape'
import type { WorkerAnswer, WorkerQuestion } from './worker-protocol'

const BETWEEN_REPORTS_MS = 50

self.onmessage = ({ data }: MessageEvent<WorkerQuestion>) => {
  try {
    answer(data)
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error)
    send({ kind: 'refused', id: data.id, message })
  }
}

function answer({ id, problem, plannerId, params, seed }: WorkerQuestion): void {
  const tape = new Tape()
  const began = performance.now()
  let reported = began
  const progress = (done: number) => {
    const now = performance.now()
    if (now - reported < BETWEEN_REPORTS_MS) return
    reported = now
    send({ kind: 'progress', id, done })
  }
  const outcome = plan(problem, plannerId, { params, seed, tape, progress })
  const milliseconds = performance.now() - began
  const last = frameAt(tape, tape.length)
  const { columns, buffers } = tape.release()
  send({ kind: 'planned', id, outcome, tape: columns, last, milliseconds }, [
    ...buffers,
    ...frameBuffers(last),
  ])
}

function frameBuffers({ search, known, felt, fields }: Frame): ArrayBufferLike[] {
  const written = Object.values(fields).filter((field) => field !== null)
  return [search, known, felt, ...written].map((array) => array.buffer)
}

function send(message: WorkerAnswer, buffers: ArrayBufferLike[] = []): void {
  self.postMessage(message, { transfer: buffers as ArrayBuffer[] })
}
