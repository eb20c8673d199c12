import { describe, expect, it } from 'vitest'
import { plan } from '../../../src/algorithms/plan'
import { openText } from '../../../src/app/experiments/open-files'
import { addressOf } from '../../../src/app/experiments/open-in-playground'
import { presets } from '../../../src/app/experiments/presets'
import { mapInWords, runInWords } from '../../../src/app/experiments/run-words'
import { initialState } from '../../../src/app/experiments/state'
import { sortSummary, summarize } from '../../../src/app/experiments/summary-table'
import {
  addEntry,
  addMaps,
  editList,
  removeEntry,
  runEnded,
  runProgressed,
  runStarted,
  showResults,
  toggleSeries,
} from '../../../src/app/experiments/transitions'
import { setupInLink } from '../../../src/app/link'
import { defaultPreferences } from '../../../src/app/preferences'
import { settingsOf } from '../../../src/app/setup'
import { resultsToCsv } from '../../../src/experiments/results-csv'
import { resultsToJson, resultsToLines } from '../../../src/experiments/results-json'
import { runMap } from '../../../src/experiments/run-map'
import { countWork, type ExperimentSettings } from '../../../src/experiments/settings'
import { saveSettings } from '../../../src/experiments/settings-check'
import { WHOLE } from '../../../src/experiments/shards'

const settings: ExperimentSettings = {
  ...presets[0].settings,
  families: [
    { family: 'random', params: { density: [10, 40] } },
    {
      family: 'maps',
      params: {},
      maps: [{ name: 'corner.map', rows: ['......', '.####.', '....#.', '......'] }],
    },
  ],
  sizes: [[12, 9]],
  leastDistance: 4,
  mapsPerCombination: 4,
}
const rows = Array.from({ length: countWork(settings).maps }, (_, map) =>
  runMap(settings, map),
).flat()
const results = { settings, shard: WHOLE, rows }
const state = initialState(defaultPreferences)

describe('a run opened in the playground', () => {
  it('ends as its row says, on generated and on opened maps', () => {
    for (const row of rows) {
      const address = new URL(addressOf(settings, row), 'https://example.org/a/')
      expect(address.pathname).toBe('/a/index.html')
      const setup = setupInLink(address.hash)
      if (!setup) throw new Error('no setup')
      const { problem, plannerId, seed } = setup
      const outcome = plan(problem, plannerId, { params: settingsOf(setup), seed })
      expect(outcome.status).toBe(row.status)
      expect(outcome.measure.cells).toBe(row.cells)
    }
  })

  it('is told from others by its words', () => {
    const given = rows.find(({ family }) => family === 'maps')
    expect(given && mapInWords(settings, given)).toBe('Map 2: corner.map, 6 × 4')
    expect(mapInWords(settings, rows[0])).toBe('Map 0: Random obstacles, density 10, 12 × 9')
    expect(runInWords({ ...rows[0], status: 'loop', ratio: null, cells: 120 })).toBe(
      'loop after 120 cells',
    )
    expect(runInWords({ ...rows[0], status: 'not-found', ratio: null, cells: 0 })).toBe(
      'no path found',
    )
    expect(
      runInWords({ ...rows[0], status: 'reached', ratio: 1.5, cells: 16, milliseconds: 0.25 }),
    ).toBe('reached in 16 cells, 1.500 times the optimum, 0.25 ms')
  })
})

describe('a file', () => {
  it.each([
    ['JSON', resultsToJson(results)],
    ['CSV', resultsToCsv(results)],
    ['JSON lines', resultsToLines(results)],
  ])('of results as %s opens with its settings in the form', (_, text) => {
    const opened = openText(state, text)
    expect(opened.shown?.results).toEqual(results)
    expect(opened.checked).toEqual({ kind: 'settings', settings })
    expect(opened.formMade).not.toBe(state.formMade)
  })

  it('of settings opens in the form, and leaves the results', () => {
    const before = showResults(state, results)
    const opened = openText(before, saveSettings(settings))
    expect(opened.checked).toEqual({ kind: 'settings', settings })
    expect(opened.shown).toBe(before.shown)
  })

  it.each([
    ['', /broken in line 1/],
    ['{"format": "path-planner"}', /format: must be "path-planner-experiment"/],
    [saveSettings({ ...settings, seed: -1 }), /^seed: must be a whole number/],
    [resultsToJson(results).replace('"map":0', '"map":-1'), /Row 0 is no row of results: "map"/],
  ])('that is broken is refused: %.40s', (text, message) => {
    expect(() => openText(state, text)).toThrow(message)
  })
})

describe('the summary', () => {
  const summary = summarize(settings, rows)

  it('counts what a loop over the rows counts', () => {
    for (const line of summary) {
      const own = rows.filter(({ setting }) => summary.indexOf(line) === setting)
      const reached = own.filter(({ status }) => status === 'reached').length
      const reachable = own.filter((row) => row.reachable).length
      expect(line.runs).toBe(own.length)
      expect(line.reached).toBe(reached / own.length)
      expect(line.reachedOfReachable).toBe(reached / reachable)
      expect(line.failures).toHaveLength(reachable - reached)
    }
  })

  it('is sorted by any column, both ways', () => {
    const failures = sortSummary(summary, 'failures', true).map((line) => line.failures.length)
    expect(failures).toEqual([...failures].sort((a, b) => b - a))
    const names = sortSummary(summary, 'name', false).map(({ name }) => name)
    expect(names.indexOf('Probabilistic roadmap (samples 20)')).toBeLessThan(
      names.indexOf('Probabilistic roadmap (samples 160)'),
    )
    expect(names[0]).toBe('Bug1')
  })

  it('has what there is no number of at the end, either way', () => {
    const lines = [{ ...summary[0], medianRatio: Number.NaN }, ...summary.slice(1)]
    for (const descending of [false, true]) {
      expect(sortSummary(lines, 'medianRatio', descending).at(-1)?.medianRatio).toBeNaN()
    }
  })
})

describe('the state of the page', () => {
  it('begins with settings that can be run', () => {
    expect(state.checked.kind).toBe('settings')
  })

  it('adds, edits and removes families and planners', () => {
    const added = addEntry(state, 'planners', 'bug1')
    const { key } = added.draft.planners[added.draft.planners.length - 1]
    expect(added.checked).toMatchObject({ fault: { field: 'planners', text: /twice/ } })
    const edited = editList(added, 'planners', key, 'turn', ['right'])
    expect(edited.checked.kind).toBe('settings')
    expect(edited.formMade).toBe(added.formMade)
    expect(removeEntry(edited, 'planners', key).draft).toEqual(state.draft)
  })

  it('has all opened maps in one family', () => {
    const map = { name: 'a', rows: ['..', '..'] }
    const once = addMaps(state, [map])
    const twice = addMaps(once, [map, map])
    expect(twice.draft.families.map(({ maps }) => maps.length)).toEqual([0, 3])
  })

  it('tells the progress at each quarter only', () => {
    let running = runStarted(state, 100)
    const said = new Set<string>()
    for (let done = 1; done <= 100; done++) {
      running = runProgressed(running, done, 1000)
      said.add(running.said)
    }
    expect(said.size).toBe(4)
    expect(running.run).toMatchObject({ done: 100, total: 100 })
  })

  it('keeps the first maps of a run that was cancelled', () => {
    const running = runStarted(state, countWork(settings).maps)
    const perMap = countWork(settings).settings
    const ended = runEnded(running, { ...results, rows: rows.slice(0, 5 * perMap) })
    expect(ended.run.kind).toBe('idle')
    expect(ended.shown).toMatchObject({ maps: 5, total: countWork(settings).maps })
  })

  it('keeps the results of the run before if none of this are there', () => {
    const before = showResults(state, results)
    const ended = runEnded(runStarted(before, 10), { ...results, rows: [] })
    expect(ended.shown).toBe(before.shown)
    expect(ended.run.kind).toBe('idle')
  })

  it('goes on while other results are looked at', () => {
    const running = runProgressed(runStarted(state, 100), 30, 1000)
    expect(openText(running, resultsToLines(results)).run).toBe(running.run)
  })

  it('knows how many maps a shard should have', () => {
    const shard = { index: 2, of: 3 }
    const { maps } = countWork(settings)
    const first = Math.floor(maps / 3)
    const own = rows.filter(({ map }) => map >= first && map < Math.floor((2 * maps) / 3))
    const { shown } = showResults(state, { settings, shard, rows: own })
    expect(shown?.maps).toBeGreaterThan(1)
    expect(shown?.total).toBe(shown?.maps)
  })

  it('begins with few enough lines where planners have many settings', () => {
    expect(showResults(state, results).hidden.size).toBe(0)
    const sectionV = presets[1].settings
    const shown = showResults(state, { settings: sectionV, shard: WHOLE, rows: [] })
    const lines = countWork(sectionV).settings - shown.hidden.size
    expect(lines).toBeGreaterThanOrEqual(8)
    expect(lines).toBeLessThanOrEqual(14)
  })

  it('leaves a series out, and brings it back', () => {
    const out = toggleSeries(state, 'Bug1')
    expect([...out.hidden]).toEqual(['Bug1'])
    expect(toggleSeries(out, 'Bug1').hidden.size).toBe(0)
  })
})
