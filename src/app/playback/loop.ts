import { EVENT } from '../../trace/events'
import { isAtEnd, type Moment } from './moment'
import { stepAt, timelineOf } from './timeline'

/**
 * Where a loop began: the number of the step that brought the rover to the place and into the state
 * that the present step finds again; `null` if this step is not about a loop. The planner counts
 * steps of its rover, the page counts all that happens.
 */
export function loopBegan(moment: Moment): number | null {
  const { shown, frame } = moment
  const { tape } = shown
  const latest = isAtEnd(moment) ? tape.length - 2 : frame.time - 1
  if (latest < 0 || tape.kind(latest) !== EVENT.loop) return null
  let walked = -1
  for (let i = 0; i < latest; i++) {
    if (tape.kind(i) === EVENT.step) walked++
    if (walked === tape.value(latest)) return stepAt(timelineOf(tape), i + 1)
  }
  return null
}
