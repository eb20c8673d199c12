import { describe, expect, it } from 'vitest'
import { presets } from '../../../src/app/experiments/presets'
import {
  addEntry,
  addMaps,
  editList,
  openSettings,
  removeEntry,
  runEnded,
  runProgressed,
  runStarted,
  showResults,
  toggleSeries,
} from '../../../src/app/experiments/transitions'
import { tell } from '../../../src/app/state/messages'
import { resultsToLines } from '../../../src/experiments/results-json'
import { countWork } from '../../../src/experiments/settings'
import { WHOLE } from '../../../src/experiments/shards'
import { openText, results, rows, settings, state } from './small-experiment'

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

  it('has no errors of before once a run has begun or settings are opened', () => {
    const failed = tell(tell(state, 'error', 'The run was broken off.'), 'note', 'By the way.')
    for (const next of [runStarted(failed, 1), openSettings(failed, settings)]) {
      expect(next.messages.map(({ text }) => text)).toEqual(['By the way.'])
    }
  })

  it('is told of one map as of one', () => {
    expect(runStarted(state, 1).said).toBe('Running 1 map.')
    const perMap = countWork(settings).settings
    const ended = runEnded(runStarted(state, 1), { ...results, rows: rows.slice(0, perMap) })
    expect(ended.said).toBe('Results of 1 map.')
  })

  it('keeps the first maps of a run that was cancelled', () => {
    const running = runStarted(state, countWork(settings).maps)
    const perMap = countWork(settings).settings
    const ended = runEnded(running, { ...results, rows: rows.slice(0, 5 * perMap + 1) })
    expect(ended.run.kind).toBe('idle')
    const { maps } = countWork(settings)
    expect(ended.shown).toMatchObject({ maps: 6, areFirst: true, total: maps })
  })

  it('counts the maps of results out of which rows were taken', () => {
    const { maps } = countWork(settings)
    const of = (some: typeof rows) => showResults(state, { ...results, rows: some }).shown
    expect(of(rows.filter(({ setting }) => setting === 0))).toMatchObject({ maps, total: maps })
    const few = rows.filter(({ map }) => map === 1 || map === 4)
    expect(of(few)).toMatchObject({ maps: 2, areFirst: false, total: maps })
    expect(of([])).toMatchObject({ maps: 0 })
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
    expect(shown?.areFirst).toBe(true)
  })

  it('begins with few enough lines where planners have many settings', () => {
    expect(showResults(state, results).hidden.size).toBe(0)
    const sectionV = presets[1].settings
    const shown = showResults(state, { settings: sectionV, shard: WHOLE, rows: [] })
    const lines = countWork(sectionV).settings - shown.hidden.size
    expect(lines).toBeGreaterThanOrEqual(8)
    expect(lines).toBeLessThanOrEqual(14)
    expect(shown.hidden).toContain('Tangent Bug (variant classic, range 2)')
    expect(shown.hidden).not.toContain('Bug2 (leave closer)')
  })

  it('leaves out nothing of fourteen lines, and most of fifteen', () => {
    const hiddenOf = (most: number) => {
      const range = Array.from({ length: most }, (_, i) => i + 1)
      const many = { ...settings, planners: [{ planner: 'tangent-bug', params: { range } }] }
      return showResults(state, { settings: many, shard: WHOLE, rows: [] }).hidden.size
    }
    expect([14, 15].map(hiddenOf)).toEqual([0, 14])
  })

  it('leaves a series out, and brings it back', () => {
    const out = toggleSeries(state, 'Bug1')
    expect([...out.hidden]).toEqual(['Bug1'])
    expect(toggleSeries(out, 'Bug1').hidden.size).toBe(0)
  })
})
