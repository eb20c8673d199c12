import { plan } from '../algorithms/plan'
import { foldWhole } from '../trace/checkpoints'
import type { Frame } from '../trace/frame'
import { Tape } from '../trace/tape'
import { scoreOf } from './score'
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
  const { columns, buffers } = tape.release()
  const { last, checkpoints } = foldWhole(columns)
  const score = scoreOf(columns)
  send({ kind: 'planned', id, outcome, tape: columns, last, checkpoints, score, milliseconds }, [
    ...buffers,
    ...[last, ...checkpoints].flatMap(frameBuffers),
    score.steps.buffer,
    score.landmarks.buffer,
  ])
}

function frameBuffers({ cells, fields }: Frame): ArrayBufferLike[] {
  const written = Object.values(fields).filter((field) => field !== null)
  return [cells, ...written].map((array) => array.buffer)
}

function send(message: WorkerAnswer, buffers: ArrayBufferLike[] = []): void {
  self.postMessage(message, { transfer: buffers as ArrayBuffer[] })
}
