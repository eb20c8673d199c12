import { describe, expect, test } from 'vitest'
import { MAX_RUNS, mapKinds, settingName } from '../../src/experiments/settings'
import {
  checkSettings,
  countWork,
  InputError,
  plannerSettings,
  readSettings,
  saveSettings,
} from '../../src/index'
import { SMALL, settingsWith } from './settings'

test('what is saved is read again', () => {
  const settings = settingsWith()
  expect(readSettings(saveSettings(settings))).toEqual(settings)
  // Some editors begin a file with a byte order mark.
  expect(readSettings(`\uFEFF${saveSettings(settings)}`)).toEqual(settings)
})

test('lists of values make every combination once, the last list fastest', () => {
  const settings = settingsWith({
    planners: [
      { planner: 'bug1' },
      { planner: 'potential-field', params: { influence: [0, 2], repulsiveValue: [1, 5, 9] } },
    ],
  })
  const chosen = plannerSettings(settings)
  expect(chosen.map(({ params }) => Object.values(params))).toEqual([
    [],
    [0, 1],
    [0, 5],
    [0, 9],
    [2, 1],
    [2, 5],
    [2, 9],
  ])
  expect(settingName(chosen[0])).toBe('Bug1')
  expect(settingName(chosen[6])).toBe('Potential field (influence 2, repulsiveValue 9)')
})

test('the work is counted as it is listed', () => {
  const settings = settingsWith()
  const kinds = mapKinds(settings)
  // Two densities, blocks, one maze, in two sizes each, and two given maps.
  expect(kinds).toHaveLength(10)
  expect(countWork(settings)).toEqual({ maps: 30, settings: 12, runs: 360 })
  expect(plannerSettings(settings)).toHaveLength(12)
  expect(kinds.at(-1)).toMatchObject({ family: 'maps', params: { map: 1 }, size: { width: 7 } })
})

const random = (density: unknown) => ({
  families: [{ family: 'random', params: { density } }],
})
const maps = (...given: unknown[]) => ({ families: [{ family: 'maps', maps: given }] })
const planner = (name: string, params: unknown) => ({ planners: [{ planner: name, params }] })

const FAULTS: [object, string][] = [
  [{ format: undefined }, 'format: is missing'],
  [{ format: 'path-planner' }, 'format: must be "path-planner-experiment", but is "path-planner".'],
  [{ version: 2 }, 'version: must be 1'],
  [{ seed: undefined }, 'seed: is missing; it must be a whole number from 0 to 2147483647.'],
  [{ seed: 1.5 }, 'seed: must be a whole number from 0 to 2147483647, but is 1.5.'],
  [{ seed: '1' }, 'seed: must be a whole number from 0 to 2147483647, but is "1".'],
  [{ diagonal: 'never' }, 'diagonal: must be "if-at-most-one-obstacle" or'],
  [{ colour: 'red' }, 'colour: there is no such field.'],
  [{ families: [] }, 'families: must be a list of at least one family'],
  [{ families: [{ family: 'city' }] }, 'families[0].family: there is no family "city"'],
  [{ families: [{ famly: 'maze' }] }, 'families[0].family: is missing'],
  [random(20), 'families[0].params.density: must be a list of at least one value, but is 20.'],
  [random([]), 'families[0].params.density: must be a list of at least one value'],
  [random([20, 'a']), 'families[0].params.density[1]: must be a number, but is "a".'],
  [random([20, 91]), 'families[0].params.density[1]: 91 is not from 0 to 90.'],
  [random([20.5]), 'families[0].params.density[0]: 20.5 is not a whole number.'],
  [random([20, 20]), 'families[0].params.density[1]: 20 is there twice.'],
  [
    { families: [{ family: 'maze', params: { density: [1] } }] },
    'families[0].params.density: there is no such parameter (there are: loops).',
  ],
  [{ families: [{ family: 'maze', maps: [SMALL.families[3].maps[0]] }] }, 'families[0].maps: only'],
  [{ families: [{ family: 'maps' }] }, 'families[0].maps: is missing'],
  [{ families: [SMALL.families[3], SMALL.families[3]] }, 'families[1]: a second family "maps"'],
  [maps({ name: 'x', rows: ['..', '.'] }), 'families[0].maps[0].rows: Row 2 has 1 cell'],
  [maps({ name: 'x', rows: ['..', '.x'] }), 'families[0].maps[0].rows: "x" at (1, 1) is no cell'],
  [maps({ name: 'x', rows: ['##', '##'] }), 'families[0].maps[0].rows: must have a free cell for'],
  [maps({ name: 'x', rows: ['##', '#.'] }), 'families[0].maps[0].rows: must have a free cell for'],
  [maps({ name: 'x' }), 'families[0].maps[0].rows: is missing'],
  [{ sizes: [] }, 'sizes: must have at least one size'],
  [{ sizes: [[20]] }, 'sizes[0][1]: is missing'],
  [{ sizes: [[20, 1]] }, 'sizes[0][1]: must be a whole number from 2 to 2048, but is 1.'],
  [{ sizes: [[20, 20, 20]] }, 'sizes[0]'],
  [{ mapsPerCombination: 0 }, 'mapsPerCombination: must be a whole number from 1 to 10000000'],
  [{ leastDistance: 0 }, 'leastDistance: must be a whole number from 1 to 2047, but is 0.'],
  [{ leastDistance: 12 }, 'leastDistance: is 12, but on a 12 × 9 map no two cells are more'],
  [{ leastDistance: 7 }, 'leastDistance: is 7, but on a 7 × 4 map no two cells are more than 6'],
  [{ planners: [] }, 'planners: must be a list of at least one planner'],
  [
    { planners: ['bug1'] },
    'planners[0]: must be an object with the name of a planner, but is "bug1"',
  ],
  [
    planner('bug3', {}),
    'planners[0].planner: there is no planner "bug3" (there are: decomposition',
  ],
  [planner('bug2', { live: ['closer'] }), 'planners[0].params.live: there is no such parameter'],
  [planner('bug2', { leave: ['far'] }), 'planners[0].params.leave[0]: "far" is not one of report'],
  [planner('bug2', { leave: [null] }), 'planners[0].params.leave[0]: must be a number, a text'],
  [
    planner('probabilistic-roadmap', { samples: [-1] }),
    'planners[0].params.samples[0]: -1 is not from 0 to 100000.',
  ],
  [
    planner('tangent-bug', { lineOfSight: [1] }),
    'planners[0].params.lineOfSight[0]: 1 is not true or false.',
  ],
  [
    { planners: [{ planner: 'bug1' }, { planner: 'bug2' }, { planner: 'bug1' }] },
    'planners: Bug1 is there twice.',
  ],
  [
    {
      planners: [
        { planner: 'bug2', params: { leave: ['closer'], turn: ['left'] } },
        { planner: 'bug2', params: { turn: ['left'], leave: ['closer'] } },
      ],
    },
    'planners: Bug2 (turn left, leave closer) is there twice.',
  ],
]

describe('a fault is told in a sentence that begins with the field', () => {
  test.each(FAULTS)('%j', (fields, message) => {
    const check = () => checkSettings({ ...SMALL, ...fields })
    expect(check).toThrow(InputError)
    try {
      check()
    } catch (error) {
      expect(String(error)).toMatch(/^InputError: .*\.$/)
      expect(String(error).slice('InputError: '.length, message.length + 12)).toBe(message)
    }
  })

  test('but no size is too small if no map is made of it', () => {
    const rows = ['...........', '...........']
    const fields = { ...maps({ name: 'x', rows }), sizes: [[5, 5]], leastDistance: 10 }
    expect(checkSettings({ ...SMALL, ...fields }).leastDistance).toBe(10)
  })

  test.each([[[]], [3], ['x'], [null]])('%j is no object', (value) => {
    expect(() => checkSettings(value)).toThrow(
      /^The settings must be an object|^format: is missing/,
    )
  })

  test('bytes are no text', () => {
    const bytes = new TextEncoder().encode(saveSettings(settingsWith())) as unknown as string
    expect(() => readSettings(bytes)).toThrow(InputError)
    expect(() => readSettings(bytes)).toThrow('A text is needed, but this is an object.')
  })

  test('what is not JSON is named by line and column', () => {
    expect(() => readSettings('{\n  "seed": 1,\n  seed\n}')).toThrow('line 3, column 3')
  })
})

test('nobody asks for too many runs by mistake, and hears for how many', () => {
  const ask = (mapsPerCombination: number) => () => settingsWith({ mapsPerCombination })
  const most = Math.floor(MAX_RUNS / 120)
  expect(ask(most)).not.toThrow()
  expect(ask(most + 1)).toThrow(
    'mapsPerCombination: these settings ask for 10,000,080 runs (833,340 maps, 12 planner settings on each); at most 10,000,000 are allowed.',
  )
})

test('a long list of lists is counted, not made', () => {
  const values = Array.from({ length: 100 }, (_, i) => i)
  const params = { influence: values, repulsiveValue: values }
  const many = (planner: string) => ({ planner, params })
  expect(() =>
    settingsWith({
      families: [{ family: 'blocks', params: { density: values.slice(0, 60), hollow: values } }],
      mapsPerCombination: 1_000_000,
      planners: [many('potential-field'), many('potential-field-memory')],
    }),
  ).toThrow('these settings ask for 240,000,000,000,000 runs')
})
