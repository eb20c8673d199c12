/** A frame has as much time again for all else. */
const SLICE_MS = 6

/**
 * A file of a text that comes in parts. They are asked for in slices, between which the page goes on.
 * @throws what the signal was aborted with
 */
export async function blobInSlices(parts: Iterable<string>, signal: AbortSignal): Promise<Blob> {
  const slices: Blob[] = []
  let slice: string[] = []
  let end = performance.now() + SLICE_MS
  for (const part of parts) {
    slice.push(part)
    if (performance.now() < end) continue
    // The browser need not keep it as a text.
    slices.push(new Blob(slice))
    slice = []
    await nextTask()
    signal.throwIfAborted()
    end = performance.now() + SLICE_MS
  }
  return new Blob([...slices, ...slice])
}

/** Not by a timer: while the page is in the background those come once a second. */
const nextTask = () =>
  new Promise<void>((resolve) => {
    const { port1, port2 } = new MessageChannel()
    port1.onmessage = () => {
      port1.close()
      resolve()
    }
    port2.postMessage(null)
  })
