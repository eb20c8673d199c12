import { describe, expect, test, vi } from 'vitest'
import { maps } from '../../src/app/scenarios/scenario-maps'
import { EVENT, InputError, planners, problemFromText, Tape } from '../../src/index'
import { posthocTrace } from '../../src/trace/posthoc'
import { PosthocLines } from '../../src/trace/posthoc-lines'
import { checkedTrace } from './posthoc-checks'
import { infoOf, type Trace, traceText, wayTo } from './posthoc-trace'

const info = infoOf(planners[0], problemFromText('S..\n.#G'))

const between = (text: string, before: string, after: string): string =>
  text.slice(text.indexOf(before) + before.length, text.lastIndexOf(after))

describe('a tape that is too long', () => {
  const tape = new Tape()
  tape.begin(3, 2)
  for (let i = 0; i < 300_000; i++) tape.write(EVENT.open, i % 6, (i + 1) % 6, i)

  test('is refused in words', () => {
    const save = () => traceText(tape, info, 2_000_000)
    expect(save).toThrow(InputError)
    expect(save).toThrow('too long for a file: more than 2 million characters')
    expect(() => traceText(new Tape(), info, 10)).toThrow(InputError)
  })

  test('is refused before it is written, if that can be told from its events', () => {
    const closing = new Tape()
    closing.begin(3, 2)
    for (let i = 0; i < 20_000; i++) closing.write(EVENT.close, i % 6, 0, 0)
    const begin = vi.spyOn(PosthocLines.prototype, 'begin')
    expect(() => traceText(closing, info, 2_000_000)).toThrow('more than 2 million characters')
    expect(begin).not.toHaveBeenCalled()
    traceText(closing, info, 4_000_000)
    expect(begin).toHaveBeenCalled()
    begin.mockRestore()
  })

  test('else all of it is in the trace, in parts that are soon made', () => {
    const told: number[] = []
    const parts = [...posthocTrace(tape, info, { progress: (done) => told.push(done) })]
    const { events }: Trace = JSON.parse(parts.join(''))
    expect(events).toHaveLength(300_002)
    expect(Math.max(...parts.map(({ length }) => length))).toBeLessThan(150_000)
    expect(told.length).toBeGreaterThan(200)
    expect(told).toEqual(told.toSorted((a, b) => a - b))
    expect(told.every((done) => done > 0 && done < 1)).toBe(true)
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
  const { events, views }: Trace = JSON.parse(traceText(tape, info))
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
    const trace = traceText(tape, infoOf(planner, problem))
    const { length } = between(trace, '"events":[\n', '\n],\n"views":')
    expect(traceText(tape, infoOf(planner, problem), length)).toBe(trace)
    expect(() => traceText(tape, infoOf(planner, problem), length - 1)).toThrow(InputError)
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
    expect(traceText(tape, infoOf(decomposition, map))).toMatch(/^\{\n"version":"1\.4\.0",\n/)
  })
})
