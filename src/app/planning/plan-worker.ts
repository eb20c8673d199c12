import { plan } from '../../algorithms/plan'
import { messageOf } from '../../grid/errors'
import { foldWhole } from '../../trace/checkpoints'
import { type Frame, packed } from '../../trace/frame'
import { Tape } from '../../trace/tape'
import { timelineOf } from '../playback/timeline'
import { send } from './asked-worker'
import type { WorkerAnswer, WorkerQuestion } from './worker-protocol'

const BETWEEN_REPORTS_MS = 50

self.onmessage = ({ data }: MessageEvent<WorkerQuestion>) => {
  try {
    answer(data)
  } catch (error) {
    send<WorkerAnswer>({ kind: 'refused', id: data.id, message: messageOf(error) })
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
    send<WorkerAnswer>({ kind: 'progress', id, done })
  }
  const outcome = plan(problem, plannerId, { params, seed, tape, progress })
  const milliseconds = performance.now() - began
  const folded = foldWhole(tape)
  const last = packed(folded.last)
  const checkpoints = folded.checkpoints.map(packed)
  const timeline = timelineOf(tape)
  const data = tape.release()
  send<WorkerAnswer>(
    { kind: 'planned', id, outcome, tape: data, last, checkpoints, timeline, milliseconds },
    [
      ...data.buffers,
      // Frames share what they have in common.
      ...new Set([last, ...checkpoints].flatMap(frameBuffers)),
      timeline.steps.buffer,
      timeline.landmarks.buffer,
    ],
  )
}

/** All arrays in a frame: those of its cells, its fields and its lists. */
function frameBuffers({ fields, ...frame }: Frame): ArrayBufferLike[] {
  return [...Object.values(frame), ...Object.values(fields)]
    .filter((value) => ArrayBuffer.isView(value))
    .map(({ buffer }) => buffer)
}
