/** What is needed of a `Worker`: it is asked, and answers as often as it likes. */
export interface AskedWorker<Question, Answer> {
  onmessage: ((event: { readonly data: Answer }) => void) | null
  onerror: ((event: { readonly message?: string; preventDefault?(): void }) => void) | null
  postMessage(question: Question): void
  terminate(): void
}

/** A worker of the browser, with the types of what it is asked and of what it answers. */
export function askedWorker<Question, Answer>(worker: Worker): AskedWorker<Question, Answer> {
  const asked: AskedWorker<Question, Answer> = {
    onmessage: null,
    onerror: null,
    postMessage: (question) => worker.postMessage(question),
    terminate: () => worker.terminate(),
  }
  worker.onmessage = (event) => asked.onmessage?.(event)
  worker.onerror = (event) => asked.onerror?.(event)
  return asked
}

/**
 * @param broke called when the worker could not be started or has thrown an error; what the browser
 * says of it may be empty
 */
export function listen<Answer>(
  worker: AskedWorker<never, Answer>,
  answered: (answer: Answer) => void,
  broke: (message: string) => void,
): void {
  worker.onmessage = ({ data }) => answered(data)
  worker.onerror = (event) => {
    event.preventDefault?.()
    broke(event.message ?? '')
  }
}

/** Ends the worker; nothing is heard of it any more. */
export function dismiss(worker: AskedWorker<never, never>): void {
  worker.onmessage = null
  worker.onerror = null
  worker.terminate()
}

/** Answers from within a worker, and hands over the buffers. */
export function send<Answer>(message: Answer, buffers: ArrayBufferLike[] = []): void {
  self.postMessage(message, { transfer: buffers as ArrayBuffer[] })
}
