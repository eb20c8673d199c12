import type { CompareWorker } from './comparer'

/** A new worker that compares. */
export function comparingWorker(): CompareWorker {
  const worker = new Worker(new URL('./compare-worker.ts', import.meta.url), { type: 'module' })
  const like: CompareWorker = {
    onmessage: null,
    onerror: null,
    postMessage: (question) => worker.postMessage(question),
    terminate: () => worker.terminate(),
  }
  worker.onmessage = (event) => like.onmessage?.(event)
  worker.onerror = (event) => like.onerror?.(event)
  return like
}
