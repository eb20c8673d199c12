import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { draftOf, newEntry, valueIn } from '../../../src/app/experiments/draft'
import { checkDraft, fieldFor, MOST_RUNS_HERE } from '../../../src/app/experiments/faults'
import { presets } from '../../../src/app/experiments/presets'
import { countWork, type ExperimentSettings } from '../../../src/experiments/settings'

const [quick] = presets
const draft = draftOf(quick.settings)

/** The field and the text of what is wrong with the quick settings after a change to their form. */
const faultOf = (change: Partial<typeof draft>) => {
  const checked = checkDraft({ ...draft, ...change })
  return checked.kind === 'fault' ? checked.fault : null
}

describe('the form of settings', () => {
  it.each(presets.map((preset) => [preset.title, preset.settings] as const))(
    'shows the settings "%s" and gives them back as they are',
    (_, settings) => {
      expect(checkDraft(draftOf(settings))).toEqual({ kind: 'settings', settings })
    },
  )

  it('gives back choices, switches, opened maps and sizes that are no squares', () => {
    const settings: ExperimentSettings = {
      ...quick.settings,
      families: [{ family: 'maps', params: {}, maps: [{ name: 'a', rows: ['...', '.#.'] }] }],
      sizes: [[30, 20]],
      leastDistance: 1,
      planners: [
        {
          planner: 'tangent-bug',
          params: { variant: ['classic', 'report'], lineOfSight: [true, false], range: [1, 3] },
        },
      ],
    }
    expect(checkDraft(draftOf(settings))).toEqual({ kind: 'settings', settings })
  })

  it('reads numbers with any blanks, and sizes in any of the usual ways', () => {
    const value = valueIn({
      ...draft,
      sizes: '40, 30x20;  10 × 12',
      families: [newEntry('random', { density: ' 10,20 ;30' })],
    })
    expect(value).toMatchObject({
      sizes: [
        [40, 40],
        [30, 20],
        [10, 12],
      ],
      families: [{ params: { density: [10, 20, 30] } }],
    })
  })

  it('takes the default where a list is empty', () => {
    const planners = [newEntry('bug2', { leave: [] }), newEntry('tangent-bug', { range: ' ' })]
    expect(valueIn({ ...draft, planners })).toHaveProperty('planners', [
      { planner: 'bug2', params: {} },
      { planner: 'tangent-bug', params: {} },
    ])
  })

  it('never throws, whatever is typed, and says where the fault is', () => {
    const text = fc.oneof(fc.string(), fc.constantFrom('1', '-1', '1e9', '40,', '4 0', '∞', '40x'))
    const lists = fc.dictionary(fc.constantFrom('density', 'samples', 'leave', '__proto__'), text)
    const entries = fc.array(
      fc.record({ id: fc.constantFrom('random', 'bug2', 'maps', 'nobody'), lists }),
      { maxLength: 3 },
    )
    const drafts = fc.record({
      seed: text,
      diagonal: text,
      families: entries,
      sizes: text,
      mapsPerCombination: text,
      leastDistance: text,
      planners: entries,
    })
    fc.assert(
      fc.property(drafts, ({ families, planners, ...rest }) => {
        const made = (list: typeof families) => list.map(({ id, lists }) => newEntry(id, lists))
        const checked = checkDraft({ ...rest, families: made(families), planners: made(planners) })
        if (checked.kind === 'fault') {
          expect(checked.fault.text).not.toBe('')
          expect(Object.keys(draft)).toContain(checked.fault.field.split(/[.[]/)[0])
        } else expect(countWork(checked.settings).runs).toBeLessThanOrEqual(MOST_RUNS_HERE)
      }),
    )
  })
})

describe('what is wrong with the form', () => {
  it.each([
    [{ seed: 'x' }, 'seed', /whole number.*"x"/],
    [{ seed: '' }, 'seed', /whole number/],
    [{ seed: '-1' }, 'seed', /whole number.*-1/],
    [{ sizes: '40, 1' }, 'sizes[1][0]', /from 2 to 2048/],
    [{ sizes: 'wide' }, 'sizes[0]', /^Must be a size such as 40×30, but is "wide"/],
    [{ sizes: '' }, 'sizes', /at least one size/],
    [{ mapsPerCombination: '1.5' }, 'mapsPerCombination', /whole number/],
    [{ leastDistance: '40' }, 'leastDistance', /no two cells are more than 39 apart/],
    [{ families: [] }, 'families', /at least one family/],
    [{ planners: [] }, 'planners', /at least one planner/],
    [
      { planners: [newEntry('probabilistic-roadmap', { samples: '10, many' })] },
      'planners[0].params.samples[1]',
      /many/,
    ],
    [
      { planners: [newEntry('bug1'), newEntry('tangent-bug', { range: '0' })] },
      'planners[1].params.range[0]',
      /0 is not from/,
    ],
    [
      { families: [newEntry('random', { density: '10, 10' })] },
      'families[0].params.density[1]',
      /twice/,
    ],
    [{ planners: [newEntry('bug1'), newEntry('bug1')] }, 'planners', /twice/],
    [{ families: [newEntry('maps')] }, 'families[0].maps', /at least one map/],
    [{ mapsPerCombination: '4000' }, 'mapsPerCombination', /this page keeps at most 500,000/],
  ] as const)('is named with its field: %j', (change, field, text) => {
    const fault = faultOf(change)
    expect(fault?.field).toBe(field)
    expect(fault?.text).toMatch(text)
  })

  it('is that of one run too many, and not of as many as the page keeps', () => {
    const one = { families: [newEntry('maze')], planners: [newEntry('bug1')] }
    expect(faultOf({ ...one, mapsPerCombination: String(MOST_RUNS_HERE) })).toBeNull()
    expect(faultOf({ ...one, mapsPerCombination: String(MOST_RUNS_HERE + 1) })).not.toBeNull()
  })

  it('is shown at the nearest field that there is', () => {
    const fields = ['sizes', 'planners', 'planners[1]', 'planners[1].params.range', 'planners[10]']
    const at = (field: string) => fieldFor({ field, text: '' }, fields)
    expect(at('planners[1].params.range[0]')).toBe('planners[1].params.range')
    expect(at('planners[1].planner')).toBe('planners[1]')
    expect(at('planners[10].planner')).toBe('planners[10]')
    expect(at('planners[2]')).toBe('planners')
    expect(at('sizes[0][1]')).toBe('sizes')
    expect(at('size')).toBeNull()
    expect(at('')).toBeNull()
  })
})
