import { describe, expect, it } from 'vitest'
import type { Setup } from '../../../src/app/state/setup'
import { undo } from '../../../src/app/state/transitions'
import { linkTo, setupInLink } from '../../../src/app/storage/link'
import { openLink } from '../../../src/app/storage/open-link'
import { setupToText } from '../../../src/app/storage/storage'
import { generators } from '../../../src/grid/generators'
import { setupFrom, stateFrom } from '../setups'

const setup: Setup = {
  ...setupFrom('S.#\n.#G', 'bug2'),
  params: { bug2: { leave: 'closer', turn: 'right' } },
  seed: 42,
}

/** The link to the setup with another value for a key of its text. */
const linkWith = (key: string, value: unknown) =>
  `#setup=${encodeURIComponent(JSON.stringify({ ...JSON.parse(setupToText(setup)), [key]: value }))}`

describe('a link to a setup', () => {
  it('opens the same map, planner, parameters and seed', () => {
    expect(setupInLink(linkTo(setup))).toEqual(setup)
  })

  it('is short enough to be sent: a map of 40 × 40 cells in less than 800 characters', () => {
    const problem = generators[0].generate(
      { width: 40, height: 40 },
      { density: 30 },
      7,
      'if-at-most-one-obstacle',
    )
    const link = linkTo({ ...setup, problem })
    expect(link.length).toBeLessThan(800)
    expect(setupInLink(link)?.problem).toEqual(problem)
  })

  it('survives in an address of its own', () => {
    const { hash } = new URL(`https://example.org/index.html${linkTo(setup)}`)
    expect(setupInLink(hash)).toEqual(setup)
  })

  it.each(['', '#', '#map', '#setu=x'])('is not in %j', (hash) => {
    expect(setupInLink(hash)).toBeNull()
  })

  it.each([
    ['#setup=', /damaged/],
    ['#setup=%', /damaged/],
    ['#setup={"version":1', /damaged/],
    [linkTo(setup).slice(0, -20), /damaged/],
    ['#setup=3', /^"version" is missing: it must be 1\.$/],
    ['#setup=[]', /^"version" is missing: it must be 1\.$/],
    [
      linkWith('plannerId', 'teleport'),
      /^"plannerId" must be one of .*bug2.*, but is "teleport"\.$/,
    ],
    [
      linkWith('width', 1e9),
      /^"width" must be a whole number from 2 to 2048, but is 1000000000\.$/,
    ],
    [linkWith('diagonal', 'never'), /^"diagonal" must be if-at-most-.*, but is "never"\.$/],
    [linkWith('params', { bug2: { leave: [] } }), /^"params" must be values of parameters/],
    [linkWith('walls', 'AAAA'), /too few or too many/],
    [linkWith('start', 2), /The start \(2, 0\) is an obstacle/],
    [linkWith('goal', -1), /The goal is cell -1/],
    [linkWith('goal', 1e300), /The goal is cell 1e\+300/],
    [linkWith('params', { bug2: { leave: 'never' } }), /"leave" of planner bug2/],
    [linkWith('params', { bug2: { speed: 1 } }), /no parameter "speed"/],
    [linkWith('params', { teleport: {} }), /no planner "teleport"/],
    [`#setup=${'x'.repeat(3_000_000)}`, /longer than any map/],
  ])('that is broken is refused: %.60s', (hash, message) => {
    expect(() => setupInLink(hash)).toThrow(message)
  })
})

describe('opening a link', () => {
  const before = stateFrom('S..\n..G')

  it('shows its setup, and undo brings back what was drawn', () => {
    const opened = openLink(before, linkTo(setup))
    expect(opened.setup).toEqual(setup)
    expect(opened.committed).toBe(opened.setup)
    expect(opened.messages.map(({ kind }) => kind)).toEqual(['note'])
    expect(undo(opened).setup).toEqual(before.setup)
  })

  it('keeps the parameters of planners that the link does not name', () => {
    const own = { ...before.setup, params: { 'tangent-bug': { range: 5 }, bug2: { turn: 'left' } } }
    const opened = openLink({ ...before, setup: own, committed: own }, linkTo(setup))
    expect(opened.setup.params).toEqual({ ...own.params, ...setup.params })
  })

  it('that is broken leaves everything as it is, and says why', () => {
    const { messages, messagesTold, ...rest } = openLink(before, '#setup=nonsense')
    const { messages: _, messagesTold: __, ...restBefore } = before
    expect(rest).toEqual(restBefore)
    expect(messages).toEqual([
      {
        id: messagesTold,
        kind: 'error',
        text: 'The link was not opened. It is damaged or was not copied to its end.',
      },
    ])
  })
})
