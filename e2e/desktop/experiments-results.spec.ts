import { resultsToLines } from '../../src/experiments/results-json'
import { runMap } from '../../src/experiments/run-map'
import { countWork } from '../../src/experiments/settings'
import { WHOLE } from '../../src/experiments/shards'
import { ExperimentsPage, SMALL } from '../experiments'
import { expect, test } from '../fixtures'

test('a mark opens the runs that failed, and a run the playground where it failed', async ({
  page,
}) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  await page
    .getByRole('button', {
      name: /^Potential field \(influence 1, repulsiveValue 30\), density 35 %/,
    })
    .click()
  const dialog = page.getByRole('dialog', { name: 'Runs' })
  await expect(dialog.getByRole('heading', { name: /^Failed: [1-9]/ })).toBeVisible()
  const item = dialog.getByRole('listitem').first()
  const cells = /local minimum after (\d+) cells/.exec(await item.innerText())?.[1]
  const [playground] = await Promise.all([
    page.waitForEvent('popup'),
    item.getByRole('link', { name: 'Open in the playground' }).click(),
  ])
  await expect(playground.locator('#map')).toHaveAttribute('data-status', 'local-minimum')
  await expect(playground.getByRole('combobox', { name: 'Planner' })).toHaveValue('potential-field')
  await expect(playground.getByLabel('Repulsive value')).toHaveValue('30')
  await expect(playground.locator('#result-numbers')).toContainText(`${cells} cells`)
  await playground.close()
})

test('of marks that lie upon each other the one on top is opened', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  // At this density all settings of potential fields fail alike; this one is drawn last.
  const name = 'Potential field (influence 1, repulsiveValue 30), density 35 %'
  const mark = page.getByRole('button', { name })
  await mark.scrollIntoViewIfNeeded()
  const box = await mark.boundingBox()
  if (!box) throw new Error('The mark is not drawn.')
  const dialog = page.getByRole('dialog', { name: 'Runs' })
  for (const beside of [-1, 0, 1]) {
    await page.mouse.click(box.x + box.width / 2 + beside, box.y + box.height / 2 + beside)
    await expect(dialog.getByText(name)).toBeVisible()
    await page.keyboard.press('Escape')
  }
})

test('all columns of the results are in sight', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  const hidden = await page
    .locator('.wide-table', { has: page.locator('#summary') })
    .evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)
  expect(hidden).toBe(0)
})

test('the keyboard goes through the marks of a chart and opens them', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  const marks = page.locator('#charts [data-mark]')
  const widths = await marks.evaluateAll((all) =>
    all.map((one) => one.getBoundingClientRect().width),
  )
  // What has no width has no place for the focus, as a box of paths that are all optimal.
  expect(Math.min(...widths)).toBeGreaterThan(0)
  await marks.first().focus()
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('ArrowRight')
  const name = await page.evaluate(() => document.activeElement?.getAttribute('aria-label'))
  expect(name).toBe(await marks.nth(2).getAttribute('aria-label'))
  await page.keyboard.press('Enter')
  await expect(page.getByRole('dialog', { name: 'Runs' })).toContainText(String(name))
  await page.keyboard.press('Escape')
  await expect(marks.nth(2)).toBeFocused()
})

test('the library of the charts is loaded with the first results, not before', async ({ page }) => {
  const loaded: string[] = []
  page.on('request', (request) => loaded.push(request.url()))
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  const isCharts = (url: string) => url.includes('charts-panel')
  expect(loaded.some(isCharts)).toBe(false)
  await experiments.run(SMALL)
  expect(loaded.some(isCharts)).toBe(true)
})

test('of times that are less than a tick of the clock no more is told than that', async ({
  page,
}) => {
  const rows = Array.from({ length: countWork(SMALL).maps }, (_, map) => runMap(SMALL, map))
    .flat()
    .map((row) => ({ ...row, milliseconds: row.map % 3 === 0 ? 1 : 0 }))
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  const file = resultsToLines({ settings: SMALL, shard: WHOLE, rows })
  await experiments.openFile('rows.jsonl', file)
  await experiments.chartsDrawn()
  await expect(page.locator('#summary tbody tr').first()).toContainText(/under 1 ms3\d0 µs/)
  const chart = page.getByRole('region', { name: 'Time to plan over size' })
  await expect(chart).toContainText('below 1 estimated')
  const bars = chart.locator('[aria-label="rule"] line')
  const ends = await bars.evaluateAll((all) =>
    all.map((bar) => [Number(bar.getAttribute('y1')), Number(bar.getAttribute('y2'))]),
  )
  const axis = 380 - 46
  expect(ends.length).toBe(await chart.locator('[data-mark]').count())
  for (const both of ends) expect(Math.max(...both)).toBe(axis)
})

test('charts are saved as pictures that stand alone', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  const svg = await experiments.downloaded('Save “Success over density” as SVG')
  const isWellFormed = await page.evaluate(
    (text) =>
      new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror') === null,
    svg,
  )
  expect(isWellFormed).toBe(true)
  expect(svg).toContain('Bug2 (leave closer)')
  expect(svg).toContain('seed 3')
})

test('charts that are saved on a phone have room for all that is written in them', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 })
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  const longest = 'Potential field: success over influence and repulsive value'
  const svg = await experiments.downloaded(`Save “${longest}” as SVG`)
  const [end, width] = await page.evaluate((text) => {
    const { documentElement } = new DOMParser().parseFromString(text, 'image/svg+xml')
    const picture = document.body.appendChild(document.importNode(documentElement, true))
    const texts = [...picture.querySelectorAll('text')].map((one) => one.getBoundingClientRect())
    const { left, width } = picture.getBoundingClientRect()
    return [Math.max(...texts.map(({ right }) => right)) - left, width]
  }, svg)
  expect(end).toBeLessThan(width)
})
