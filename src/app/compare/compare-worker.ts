import { planners } from '../../algorithms/planners'
import { optimumOf } from '../../experiments/run-map'
import { messageOf } from '../../grid/errors'
import { comparedPlan, runPlanner } from './compared'
import { MOST_MS, medianTime } from './median-time'
import type { CompareAnswer, CompareQuestion } from './protocol'

/** Times are taken once edits have been over for so long. */
const SETTLED_AFTER_MS = 300

let latest = 0

self.onmessage = ({ data }: MessageEvent<CompareQuestion>) => {
  latest = data.id
  answer(data).catch((error: unknown) => {
    send({ kind: 'failed', id: data.id, message: messageOf(error) })
  })
}

async function answer({ id, subject }: CompareQuestion): Promise<void> {
  const optimum = optimumOf(subject.problem)
  const quick = []
  for (const planner of planners) {
    const plan = comparedPlan(subject, planner, optimum)
    send({ kind: 'planned', id, plan })
    if (plan.status === 'refused') continue
    const { plannerId, milliseconds } = plan
    if (milliseconds > MOST_MS) send({ kind: 'timed', id, plannerId, milliseconds })
    else quick.push(planner)
  }
  send({ kind: 'compared', id })
  await pause(SETTLED_AFTER_MS)
  for (const planner of quick) {
    if (latest !== id) return
    const now = () => performance.now()
    const milliseconds = medianTime(() => runPlanner(subject, planner), now)
    send({ kind: 'timed', id, plannerId: planner.id, milliseconds })
    // The next question may have come.
    await pause(0)
  }
  if (latest === id) send({ kind: 'finished', id })
}

const pause = (milliseconds: number) =>
  new Promise<void>((resolve) => setTimeout(resolve, milliseconds))

function send(message: CompareAnswer): void {
  self.postMessage(message)
}
