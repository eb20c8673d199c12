import type { AskedWorker } from '../../src/app/planning/asked-worker'

/** A worker that notes what it is asked, and answers what a test has it say. */
export class FakeWorker<Question, Answer> implements AskedWorker<Question, Answer> {
  onmessage: AskedWorker<Question, Answer>['onmessage'] = null
  onerror: AskedWorker<Question, Answer>['onerror'] = null
  readonly questions: Question[] = []
  isTerminated = false

  postMessage(question: Question): void {
    this.questions.push(question)
  }

  terminate(): void {
    this.isTerminated = true
  }

  say(answer: Answer): void {
    this.onmessage?.({ data: answer })
  }
}
