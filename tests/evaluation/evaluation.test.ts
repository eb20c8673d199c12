import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { evaluate } from '../../src/evaluation/evaluation'
import { checkSettings, countWork, type Row, readSettings, runMap } from '../../src/index'

const committed = readSettings(readFileSync('settings/section-v.json', 'utf8'))

// All that the evaluation looks for, on few and small maps.
const settings = checkSettings({
  ...committed,
  sizes: [
    [20, 20],
    [30, 30],
  ],
  mapsPerCombination: 2,
})
const rows: Row[] = Array.from({ length: countWork(settings).maps }, (_, map) =>
  runMap(settings, map, () => performance.now()),
).flat()

const { markdown, figures } = evaluate({ settings, rows }, 'a clock', 'drawings')

/** The text below a heading that contains the words. */
function section(words: string): string {
  const found = markdown.split('\n## ').find((part) => part.split('\n')[0].includes(words))
  if (!found) throw new Error(`There is no section about ${words}.`)
  return found
}

const own = (planner: string, params: Readonly<Record<string, unknown>> = {}) =>
  rows.filter(
    (row) =>
      row.planner === planner &&
      row.reachable &&
      Object.entries(params).every(([name, value]) => row.params[name] === value),
  )

test('the committed settings ask for at least 10,000 maps, some of 40 × 40', () => {
  expect(countWork(committed).maps).toBeGreaterThanOrEqual(10_000)
  expect(committed.sizes).toContainEqual([40, 40])
})

test('the committed page is about these settings, and its drawings are there', () => {
  const page = readFileSync('docs/evaluation.md', 'utf8')
  const { maps, runs } = countWork(committed)
  expect(page).toContain(`**Maps**: ${maps.toLocaleString('en')};`)
  expect(page).toContain(`**Runs**: ${runs.toLocaleString('en')}.`)
  expect(page).toContain(`Seed ${committed.seed}, diagonal rule`)
  const shown = [...page.matchAll(/\]\((evaluation\/[a-z-]+\.svg)\)/g)].map(([, path]) => path)
  expect(shown).toHaveLength(figures.length)
  for (const path of shown) expect(readFileSync(`docs/${path}`, 'utf8')).toContain('</svg>')
})

test('every claim has a section, and every drawing is shown', () => {
  expect(markdown.match(/^## /gm)).toHaveLength(10)
  expect(markdown.match(/^> /gm)).toHaveLength(9)
  const shown = [...markdown.matchAll(/!\[([^\]]+)\]\(drawings\/([a-z-]+)\.svg\)/g)]
  expect(shown.map(([, alt, name]) => [name, alt]).sort()).toEqual(
    figures.map(({ name, alt }) => [name, alt]).sort(),
  )
  expect(markdown).not.toMatch(/NaN|undefined|Infinity|null/)
})

describe('what is written is what was counted', () => {
  test('how often planners arrive', () => {
    const all = own('decomposition')
    expect(section('Decomposition')).toContain(`${all.length} of ${all.length} maps`)
    const proofs = rows.filter(
      ({ planner, status }) => planner === 'bug1' && status === 'unreachable',
    )
    expect(proofs.length).toBeGreaterThan(0)
    expect(section('Bug1 is complete')).toContain(`of the other ${proofs.length} that it is not`)
  })

  test('loops', () => {
    const loops = own('bug2', { leave: 'report' }).filter(({ status }) => status === 'loop')
    expect(loops.length).toBeGreaterThan(0)
    expect(section('Bug2 is shorter')).toContain(`On ${loops.length} of ${own('bug1').length} maps`)
    const tangent = own('tangent-bug', { variant: 'report', range: 2 })
    const around = tangent.filter(({ status }) => status === 'loop')
    expect(section('Tangent Bug')).toContain(`loop on ${around.length} of ${tangent.length} maps`)
  })

  test('who walks less', () => {
    const bug1 = new Map(own('bug1').map((row) => [row.map, row]))
    const both = own('bug2', { leave: 'report' }).filter(({ status }) => status === 'reached')
    const less = both.filter(({ map, steps }) => steps < (bug1.get(map)?.steps ?? 0))
    const share = (100 * less.length) / both.length
    expect(section('Bug2 is shorter')).toContain(
      `(${both.length} maps), Bug2 walks less than Bug1 on ${share.toFixed(1)} %`,
    )
  })

  test('what memory mends', () => {
    const params = { influence: 1, repulsiveValue: 30 }
    const memory = new Map(own('potential-field-memory', params).map((row) => [row.map, row]))
    const trapped = own('potential-field', params).filter(({ status }) => status !== 'reached')
    const mended = trapped.filter(({ map }) => memory.get(map)?.status === 'reached')
    expect(section('memory mends')).toContain(`${mended.length} of ${trapped.length} maps`)
    expect(section('memory mends')).toContain('failed on 0 where')
  })

  test('roadmaps by samples', () => {
    for (const samples of [10, 20, 40, 80, 160, 320]) {
      const runs = own('probabilistic-roadmap', { samples })
      const reached = runs.filter(({ status }) => status === 'reached')
      const share = (100 * reached.length) / runs.length
      expect(section('Roadmaps')).toContain(`| ${samples} | ${share.toFixed(1)} % (`)
    }
  })

  test('bounds', () => {
    const runs = rows.filter(({ planner }) => planner === 'bug1').length
    expect(section('How far')).toContain(`| Bug1 | ${runs} | 0 |`)
    expect(section('How far')).toContain('No run was above its bound.')
  })
})

test('a claim that the figures contradict is said to be contradicted', () => {
  const lost = rows.map(
    (row): Row => (row.planner === 'bug1' ? { ...row, status: 'loop', ratio: null } : row),
  )
  const other = evaluate({ settings, rows: lost }, 'a clock', 'drawings').markdown
  const told = other.split('\n## ').find((part) => part.startsWith('Bug1')) ?? ''
  expect(told).toContain('Not borne out. It arrived on 0 of')
})

test('the same rows make the same page', () => {
  expect(evaluate({ settings, rows }, 'a clock', 'drawings')).toEqual({ markdown, figures })
})

describe.each(figures)('drawing $name', ({ svg }) => {
  test('is sound: tags are closed, numbers are numbers, it has a title', () => {
    const open: string[] = []
    for (const [tag, closing, name, self] of svg.matchAll(/<(\/?)([a-z]+)[^>]*?(\/?)>/g)) {
      if (closing) expect(open.pop(), tag).toBe(name)
      else if (!self) open.push(name)
    }
    expect(open).toEqual([])
    expect(svg).toMatch(/<title>[^<]{20,}<\/title>/)
    expect(svg).not.toMatch(/NaN|Infinity|undefined/)
  })

  test('stays within its borders', () => {
    const [, width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/)?.map(Number) ?? []
    const values = (names: string) =>
      [...svg.matchAll(new RegExp(` (?:${names})="(-?[\\d.]+)"`, 'g'))].map(([, v]) => Number(v))
    expect(Math.max(...values('x|x1|x2|cx'))).toBeLessThanOrEqual(width)
    expect(Math.max(...values('y|y1|y2|cy'))).toBeLessThanOrEqual(height)
    expect(Math.min(...values('x|x1|x2|cx|y|y1|y2|cy'))).toBeGreaterThanOrEqual(0)
  })
})
