import { describe, expect, it } from 'vitest'
import { plan } from '../../../src/algorithms/plan'
import { addressOf } from '../../../src/app/experiments/open-in-playground'
import { mapInWords, runInWords } from '../../../src/app/experiments/run-words'
import { sortSummary, summarize } from '../../../src/app/experiments/summary-table'
import { showResults } from '../../../src/app/experiments/transitions'
import { settingsOf } from '../../../src/app/state/setup'
import { setupInLink } from '../../../src/app/storage/link'
import { resultsToCsv } from '../../../src/experiments/results-csv'
import { resultsToJson, resultsToLines } from '../../../src/experiments/results-json'
import { saveSettings } from '../../../src/experiments/settings-check'
import { openText, results, rows, settings, state } from './small-experiment'

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
    expect(
      runInWords({ ...rows[0], status: 'loop', ratio: null, cells: 120, milliseconds: 3 }),
    ).toBe('loop after 120 cells, time 3 ms')
    expect(
      runInWords({ ...rows[0], status: 'not-found', ratio: null, cells: 0, milliseconds: 0 }),
    ).toBe('no path found, time too short to measure')
    expect(
      runInWords({ ...rows[0], status: 'reached', ratio: 1.5, cells: 16, milliseconds: 0.25 }),
    ).toBe('reached in 16 cells, 1.500 times the optimum, time 250 µs')
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
