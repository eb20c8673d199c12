/** A frame has as much time again for all else. */
const SLICE_MS = 6

/**
 * Does work that rests now and then, in slices, between which the page goes on.
 * @param took is given what came out at the rests of one slice
 * @throws what the signal was aborted with
 */
export async function inSlices<Part, Result>(
  work: Generator<Part, Result, void>,
  took: (parts: Part[]) => void,
  signal: AbortSignal,
): Promise<Result> {
  for (;;) {
    const parts: Part[] = []
    const end = performance.now() + SLICE_MS
    do {
      const step = work.next()
      if (step.done) {
        took(parts)
        return step.value
      }
      parts.push(step.value)
    } while (performance.now() < end)
    took(parts)
    await nextTask()
    signal.throwIfAborted()
  }
}

/** A file of a text that comes in parts, in slices as well. */
export async function blobInSlices(
  parts: Generator<string, void, void>,
  signal: AbortSignal,
): Promise<Blob> {
  const slices: Blob[] = []
  // The browser need not keep them as texts.
  await inSlices(parts, (texts) => slices.push(new Blob(texts)), signal)
  return new Blob(slices)
}

/** Lets the page go on. Not by a timer: while the page is in the background those come once a second. */
const nextTask = () =>
  new Promise<void>((resolve) => {
    const { port1, port2 } = new MessageChannel()
    port1.onmessage = () => {
      port1.close()
      resolve()
    }
    port2.postMessage(null)
  })
