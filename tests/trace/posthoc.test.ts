import { describe, expect, test, vi } from 'vitest'
import { maps } from '../../src/app/scenarios/scenario-maps'
import { EVENT, InputError, planners, problemFromText, Tape } from '../../src/index'
import { posthocTrace } from '../../src/trace/posthoc'
import { leastLength } from '../../src/trace/posthoc-length'
import { PosthocLines } from '../../src/trace/posthoc-lines'
import { checkedTrace } from './posthoc-checks'
import { infoOf, type Trace, wayTo } from './posthoc-trace'

const info = infoOf(planners[0], problemFromText('S..\n.#G'))

describe('a tape that is too long', () => {
  const tape = new Tape()
  tape.begin(3, 2)
  for (let i = 0; i < 300_000; i++) tape.write(EVENT.open, i % 6, (i + 1) % 6, i)

  test('is refused in words', () => {
    const save = () => posthocTrace(tape, info, 2_000_000)
    expect(save).toThrow(InputError)
    expect(save).toThrow('too long for a file: more than 2 million characters')
    expect(() => posthocTrace(new Tape(), info, 10)).toThrow(InputError)
  })

  test('is refused before it is written, if that can be told from its events', () => {
    const closing = new Tape()
    closing.begin(3, 2)
    for (let i = 0; i < 20_000; i++) closing.write(EVENT.close, i % 6, 0, 0)
    const begin = vi.spyOn(PosthocLines.prototype, 'begin')
    expect(() => posthocTrace(closing, info, 2_000_000)).toThrow('more than 2 million characters')
    expect(begin).not.toHaveBeenCalled()
    posthocTrace(closing, info, 4_000_000)
    expect(begin).toHaveBeenCalled()
    begin.mockRestore()
  })

  test('else all of it is in the trace', () => {
    const { events }: Trace = JSON.parse(posthocTrace(tape, info))
    expect(events).toHaveLength(300_002)
  })
})

test('numbers stay what they are, however large; potentials are coloured up to the highest', () => {
  const values = [1e308, -1e308, 3e9 + 0.123456789, 700.5, Number.POSITIVE_INFINITY]
  const tape = new Tape()
  tape.begin(3, 2)
  values.forEach((value, cell) => {
    tape.write(EVENT.attraction, cell, -1, value)
  })
  tape.write(EVENT.potential, 3, -1, 700.5)
  tape.write(EVENT.potential, 4, -1, Number.POSITIVE_INFINITY)
  const { events, views }: Trace = JSON.parse(posthocTrace(tape, info))
  const told = events.filter(({ type }) => type === 'attraction').map(({ value }) => value)
  expect(told).toEqual([...values.slice(0, -1), 'infinite'])
  expect(JSON.stringify(views)).toContain('$.value / 700.5)')
})

describe('figures of the report', () => {
  const cases = Object.entries(maps).flatMap(([name, text]) =>
    planners.map((planner) => [`${planner.id} on ${name}`, text, planner] as const),
  )

  test.each(cases)('%s', (_, text, planner) => {
    const tape = new Tape()
    const problem = problemFromText(text)
    checkedTrace(problem, planner, tape)
    const trace = posthocTrace(tape, infoOf(planner, problem))
    const events = trace.slice(trace.indexOf('"events":'))
    expect(leastLength(tape)).toBeLessThanOrEqual(events.length)
  })

  test('the way back to the start of a search is its path', () => {
    const tape = new Tape()
    const map = problemFromText(maps.fig05)
    const decomposition = planners[0]
    const trace = checkedTrace(map, decomposition, tape)
    const path = trace.events.filter(({ type }) => type === 'path').map(({ x, y }) => [x, y])
    const back = wayTo(trace, trace.events.length - 1).map(({ x, y }) => [x, y])
    expect(path.length).toBeGreaterThan(10)
    expect(back.reverse()).toEqual(path)
    expect(posthocTrace(tape, infoOf(decomposition, map))).toMatch(/^\{\n"version":"1\.4\.0",\n/)
  })
})
