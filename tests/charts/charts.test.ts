import { describe, expect, it } from 'vitest'
import { presets } from '../../src/app/experiments/presets'
import { chartsOf } from '../../src/charts/charts'
import { linesOptions } from '../../src/charts/draw-lines'
import { chartThemes, seriesStyle } from '../../src/charts/style'
import { millisecondsInWords, successInWords } from '../../src/charts/words'
import { runMap } from '../../src/experiments/run-map'
import { countWork, type ExperimentSettings } from '../../src/experiments/settings'
import { contrast, rgbOf } from '../../src/render/colour'

const settings: ExperimentSettings = {
  ...presets[0].settings,
  families: [{ family: 'random', params: { density: [10, 35] } }],
  sizes: [
    [10, 10],
    [12, 16],
    [16, 12],
  ],
  leastDistance: 4,
  mapsPerCombination: 5,
  planners: [
    { planner: 'decomposition', params: {} },
    {
      planner: 'probabilistic-roadmap',
      params: { samples: [5, 0, 20], search: ['dijkstra', 'a-star'] },
    },
    { planner: 'potential-field', params: { influence: [0, 1], repulsiveValue: [3, 30] } },
  ],
}
const rows = Array.from({ length: countWork(settings).maps }, (_, map) =>
  runMap(settings, map),
).flat()
const charts = chartsOf(settings, rows)
const chart = (id: string, among = charts) => {
  const found = among.find((one) => one.id === id)
  if (!found) throw new Error(`no chart ${id}`)
  return found
}
const optionsOf = (id: string, among = rows) => {
  const found = chart(id, chartsOf(settings, among))
  if (found.kind !== 'lines') throw new Error(`${id} has no lines`)
  return linesOptions(found, { width: 600, theme: chartThemes.dark, isShown: () => true })
}
const possible = rows.filter(({ reachable }) => reachable)

describe('every chart', () => {
  it.each(charts.map((one) => [one.id, one] as const))(
    '%s says in words and in a table what its marks show',
    (_, { marks, summary, series, table, missing }) => {
      expect(missing).toBe('')
      expect(summary).not.toMatch(/NaN|undefined/)
      expect(marks.length).toBeGreaterThan(1)
      for (const mark of marks) {
        expect(mark.label).not.toMatch(/NaN|undefined/)
        expect(series[mark.series]).toBeDefined()
        expect([mark.x, mark.y, mark.low, mark.high].every(Number.isFinite)).toBe(true)
        expect(mark.runs.length).toBeGreaterThan(0)
      }
      expect(new Set(marks.map(({ label }) => label)).size).toBe(marks.length)
      for (const line of table.rows) expect(line).toHaveLength(table.columns.length)
    },
  )

  it('says what is missing where there is nothing to draw', () => {
    const one = rows.filter(
      ({ planner, density, width }) => planner === 'decomposition' && density < 20 && width === 10,
    )
    const missing = chartsOf(settings, one).map((chart) => chart.missing !== '')
    expect(missing).toEqual([true, false, true, true, true])
    const few = rows.filter(({ params }) => params.samples === 5)
    expect(chart('samples', chartsOf(settings, few)).missing).not.toBe('')
    for (const chart of chartsOf(settings, [])) expect(chart.missing).not.toBe('')
  })
})

describe('the marks', () => {
  it('of success over density have the runs that failed behind them', () => {
    for (const { x, series, y, runs } of chart('success').marks) {
      const own = possible.filter(
        ({ mapParams, setting }) => mapParams.density === x && setting === series,
      )
      const failed = own.filter(({ status }) => status !== 'reached')
      expect(runs).toEqual([{ title: 'Failed', rows: failed }])
      expect(y).toBeCloseTo(1 - failed.length / own.length)
    }
  })

  it('of samples count roadmaps only', () => {
    for (const { x, series, runs } of chart('samples').marks) {
      const search = ['dijkstra', 'a-star'][series]
      const failed = possible.filter(
        ({ planner, params, status }) =>
          planner === 'probabilistic-roadmap' &&
          params.samples === x &&
          params.search === search &&
          status !== 'reached',
      )
      expect(runs[0].rows).toEqual(failed)
    }
  })

  it('of the heat map stand for one influence and one repulsive value each', () => {
    const { marks } = chart('field')
    expect(marks).toHaveLength(4)
    for (const { x, y, runs } of marks) {
      const failed = possible.filter(
        ({ params, status }) =>
          params.influence === x && params.repulsiveValue === y && status !== 'reached',
      )
      expect(runs[0].rows).toEqual(failed)
    }
  })

  it('of the ratio have the longest detours behind them, longest first', () => {
    for (const { runs, series } of chart('ratio').marks) {
      const ratios = runs[0].rows.map(({ ratio }) => ratio ?? 0)
      expect(ratios).toEqual([...ratios].sort((a, b) => b - a))
      const detours = rows.filter(({ ratio, setting }) => (ratio ?? 0) > 1 && setting === series)
      expect(ratios).toHaveLength(Math.min(50, detours.length))
    }
  })

  it('of samples lie on the axis, those of none too', () => {
    const { series, marks } = chart('samples')
    expect(series.map(({ name }) => name)).toEqual([
      'Probabilistic roadmap, search dijkstra, cost cells',
      'Probabilistic roadmap, search a-star, cost cells',
    ])
    expect(marks.map(({ x }) => x)).toEqual([0, 5, 20, 0, 5, 20])
    expect(optionsOf('samples').x?.type).toBe('symlog')
    expect(optionsOf('time').x?.type).toBe('log')
  })

  it('of time are in the table by size, of sizes with as many cells too', () => {
    const { columns, rows: lines } = chart('time').table
    expect(columns).toEqual(['Planner', '10 × 10', '12 × 16', '16 × 12'])
    const other = rows.map((row) => ({ ...row, milliseconds: row.width }))
    for (const line of chart('time', chartsOf(settings, other)).table.rows) {
      expect(line.slice(1)).toEqual(['10 ms', '12 ms', '16 ms'])
    }
    expect(lines).toHaveLength(countWork(settings).settings)
  })

  it('of time are estimated where most runs took less than a tick of the clock', () => {
    const coarse = rows.map((row) => ({ ...row, milliseconds: row.map % 5 === 0 ? 10 : 0 }))
    const { marks, y: axis, summary, table } = chart('time', chartsOf(settings, coarse))
    for (const { y, low, high, label } of marks) {
      expect([y, low, high]).toEqual([2, 0, 10])
      expect(label).toMatch(/: median under 10 ms, about 2 ms, \d+ runs$/)
    }
    expect(axis.label).toBe('Median time to plan (ms); below 10 estimated')
    expect(summary).toContain('Medians under 10 ms, a tick of the clock, are estimated.')
    expect(summary).toContain('Grid decomposition: about 2 ms to about 2 ms.')
    expect(table.rows[0][1]).toBe('about 2 ms')
    expect(chart('samples', chartsOf(settings, coarse)).table.rows[0][4]).toBe('under 10 ms')
    const fine = rows.map((row) => ({ ...row, milliseconds: 0.01 }))
    expect(chart('time', chartsOf(settings, fine)).y.label).toBe('Median time to plan (ms)')
  })

  it('of time stay where they are, however slow a few runs were', () => {
    const slow = rows.map((row) => ({ ...row, milliseconds: row.map % 5 === 0 ? 1000 : 0 }))
    slow[0] = { ...slow[0], milliseconds: 1 }
    for (const { y, high, label } of chart('time', chartsOf(settings, slow)).marks) {
      expect([y, high]).toEqual([0.2, 1])
      expect(label).toContain('median under 1 ms, about 200 µs,')
    }
  })

  it('of time are no lower than many runs can tell, where none took a tick', () => {
    const still = rows.map((row) => ({ ...row, milliseconds: row.setting === 0 ? 0 : 3 }))
    const [first] = chart('time', chartsOf(settings, still)).marks
    const runs = rows.filter(({ setting, width }) => setting === 0 && width === 10).length
    expect([first.y, first.low, first.high]).toEqual([3 / runs, 0, 3])
    expect(first.label).toContain(': median under 3 ms, 10 runs')
  })

  it('of time cannot be placed if no run took a tick, and that is said', () => {
    const still = rows.map((row) => ({ ...row, milliseconds: 0 }))
    const { missing } = chart('time', chartsOf(settings, still))
    expect(missing).toBe('All runs were too short for the clock.')
  })
})

describe('the words', () => {
  it('of the heat map name the best of its cells', () => {
    const field = chart('field')
    if (field.kind !== 'cells') throw new Error('It has no cells.')
    const { summary, marks } = field
    const best = Math.max(...marks.map(({ value }) => value))
    const [first] = marks.filter(({ value }) => value === best)
    const share = `${(100 * best).toFixed(1)} %`
    expect(summary).toContain(`influence ${first.x} and repulsive value ${first.y}: ${share}.`)
    expect(new Set(marks.map(({ value }) => value)).size).toBeGreaterThan(1)
  })

  it('of success over density count the settings that never failed, and tell of the others', () => {
    const { series, marks, summary } = chart('success')
    const curves = series.map((_, number) => marks.filter((mark) => mark.series === number))
    const failing = curves.filter((own) => own.some(({ y }) => y < 1))
    expect([failing.length > 0, failing.length < curves.length]).toEqual([true, true])
    const always = curves.length - failing.length
    expect(summary).toContain(`${always} of ${curves.length} planner settings always reached it.`)
    for (const own of failing) {
      const [from, to] = [own[0], own[own.length - 1]].map(({ y }) => `${(100 * y).toFixed(1)} %`)
      expect(summary).toContain(`${series[own[0].series].name} from ${from} to ${to}`)
    }
  })

  it('of a success have its share, its numbers and its interval', () => {
    const share = { rate: 0.9141, low: 0.8673, high: 0.9466 }
    const success = { ...share, rows: rows.slice(0, 20), failures: rows.slice(0, 2) }
    expect(successInWords(success)).toBe('91.4 % (18 of 20; 95 % interval 86.7 % to 94.7 %)')
    expect(successInWords({ ...success, rows: [], failures: [] })).toBe(
      'no goal that can be reached',
    )
  })

  it.each([
    [0, 'too short to measure'],
    [0.0004, '0.4 µs'],
    [0.0123, '12 µs'],
    [0.1, '100 µs'],
    [0.9949, '990 µs'],
    [0.995, '1 ms'],
    [7.25, '7.3 ms'],
    [99.4, '99 ms'],
    [99.7, '100 ms'],
    [1234.5, '1,235 ms'],
    [Number.NaN, '–'],
  ])('of %d milliseconds have two digits that count', (milliseconds, words) => {
    expect(millisecondsInWords(milliseconds)).toBe(words)
  })
})

describe('the styles', () => {
  it.each(Object.entries(chartThemes))('of the %s theme stand out on its surface', (_, theme) => {
    const contrastOf = (colour: string) => contrast(rgbOf(colour), rgbOf(theme.surface))
    for (const colour of theme.series) expect(contrastOf(colour)).toBeGreaterThanOrEqual(3)
    expect(contrastOf(theme.ink)).toBeGreaterThanOrEqual(7)
  })

  it('differ for 280 series, and between neighbours in colour, symbol and line', () => {
    const styles = Array.from({ length: 280 }, (_, i) => seriesStyle(chartThemes.dark, i))
    expect(new Set(styles.map((style) => JSON.stringify(style))).size).toBe(280)
    styles.slice(1).forEach((style, i) => {
      expect(style.colour).not.toBe(styles[i].colour)
      expect(style.symbol).not.toBe(styles[i].symbol)
      expect(style.dash).not.toBe(styles[i].dash)
    })
  })
})
