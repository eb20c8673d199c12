import { advance } from './fold'
import { copyOf, type Frame, firstFrame } from './frame'
import type { Tape } from './tape'

/** Events between two checkpoints: a page folds so many within about an animation frame. */
const SPACING = 3 << 17
/** The last checkpoint lies so many events before the end, because most steps back begin at the end. */
const BEFORE_END = 1 << 16
/** Bytes of all checkpoints together; on a tape of large frames there are fewer of them. */
const MOST_BYTES = 48 * 2 ** 20
/** Bytes of an entry in a list of cells. */
const ENTRY_BYTES = 4

/** A tape folded once from its beginning to its end. */
export interface Folded {
  /** The frame after the last event. */
  readonly last: Frame
  /** Frames on the way to it, their times rising. None on tapes that are folded in a moment. */
  readonly checkpoints: readonly Frame[]
}

/**
 * @param spacing events between two checkpoints
 * @param beforeEnd events between the last checkpoint and the end
 */
export function foldWhole(tape: Tape, spacing = SPACING, beforeEnd = BEFORE_END): Folded {
  const last = firstFrame(tape)
  const checkpoints: Frame[] = []
  let bytes = 0
  const times = checkpointTimes(tape.length, spacing, beforeEnd)
  for (const time of times) {
    advance(last, tape, time)
    bytes += sizeOf(last)
    if (bytes <= MOST_BYTES || time === times.at(-1)) checkpoints.push(copyOf(last))
  }
  advance(last, tape, tape.length)
  for (const frame of checkpoints) shareLists(frame, last)
  return { last, checkpoints }
}

/** The long lists of a frame begin as those at the end do, so they need no memory of their own. */
function shareLists(frame: Frame, { vertices, edges }: Frame): void {
  frame.vertices = vertices.subarray(0, frame.vertices.length)
  frame.edges = edges.subarray(0, frame.edges.length)
}

function checkpointTimes(length: number, spacing: number, beforeEnd: number): number[] {
  if (length <= spacing) return []
  const count = Math.ceil((length - beforeEnd) / spacing) - 1
  const times = Array.from({ length: count }, (_, i) => (i + 1) * spacing)
  return [...times, length - beforeEnd]
}

/** Bytes of what a frame does not share with the others. */
function sizeOf({ cells, fields, trail, path }: Frame): number {
  const { attraction, repulsion, potential } = fields
  const ofFields = [attraction, repulsion, potential].map((field) => field?.byteLength ?? 0)
  const ofLists = ENTRY_BYTES * (trail.length + path.length)
  return ofFields.reduce((sum, size) => sum + size, cells.byteLength + ofLists)
}
