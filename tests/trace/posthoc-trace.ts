import type { Planner, Problem, Tape } from '../../src/index'
import { type PosthocInfo, posthocTrace } from '../../src/trace/posthoc'

/** An event of a trace, as Posthoc reads it. */
export interface PosthocEvent {
  readonly type: string
  readonly id: string
  readonly pId?: string
  readonly x?: number
  readonly y?: number
  readonly [more: string]: unknown
}

/** What a view draws, or which view it calls. */
export type Component = Readonly<Record<string, unknown>>

export interface Trace {
  readonly version: string
  readonly views: Readonly<Record<string, readonly Component[]>>
  readonly pivot: Readonly<Record<string, unknown>>
  readonly events: readonly PosthocEvent[]
}

export const infoOf = ({ id, title, phases, variables }: Planner, problem: Problem) => ({
  plannerId: id,
  title,
  phases,
  variables,
  problem,
  mapFile: 'some.map',
})

export const traceText = (tape: Tape, info: PosthocInfo, most = 2e8): string =>
  [...posthocTrace(tape, info, { most })].join('')

/** From an event back to the root: the latest parent of its `id`, then the latest event of that. */
export function wayTo({ events }: Trace, index: number): PosthocEvent[] {
  const way = [events[index]]
  for (let i = index; ; ) {
    const { id } = events[i]
    const child = events.findLastIndex((e, at) => at <= i && e.id === id && e.pId !== undefined)
    if (child < 0) return way
    i = events.findLastIndex((e, at) => at <= i && e.id === events[child].pId)
    way.push(events[i])
  }
}
