import type { Page } from '@playwright/test'
import { openResults } from '../../src/experiments/open-results'
import { resultsToLines } from '../../src/experiments/results-json'
import { runMap } from '../../src/experiments/run-map'
import { countWork } from '../../src/experiments/settings'
import { readSettings } from '../../src/experiments/settings-check'
import { timeless } from '../../tests/experiments/settings'
import { ExperimentsPage, SMALL } from '../experiments'
import { expect, test } from '../fixtures'

const MANY = { ...SMALL, mapsPerCombination: 3000 }

/** The page of experiments while it runs so many maps that there is time to look at it. */
async function longRun(page: Page): Promise<ExperimentsPage> {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.openFile('many.json', JSON.stringify(MANY))
  await page.getByRole('button', { name: 'Run', exact: true }).click()
  return experiments
}

test('the same settings give the same rows in the browser and in Node', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run(SMALL)
  const maps = Array.from({ length: countWork(SMALL).maps }, (_, map) => map)
  const expected = timeless(maps.flatMap((map) => runMap(SMALL, map)))
  for (const kind of ['CSV', 'JSON']) {
    const results = openResults(await experiments.downloaded(`Rows as ${kind}`))
    expect(results.settings).toEqual(SMALL)
    expect(timeless(results.rows)).toEqual(expected)
  }
})

test('a run that is cancelled keeps its first maps, and they can be looked at', async ({
  page,
}) => {
  const experiments = await longRun(page)
  const bar = page.getByRole('progressbar', { name: 'Maps done' })
  await expect(bar).toBeVisible()
  await expect(page.getByText(/^[1-9][\d,]* of 21,000 maps, .* left$/)).toBeVisible()
  const cancel = page.getByRole('button', { name: 'Cancel' })
  await cancel.click()
  await expect(page.getByText(/^The first [\d,]+ of 21,000 maps, .* runs, seed 3\.$/)).toBeVisible()
  await expect(bar).toBeHidden()
  await experiments.chartsDrawn()
  const { rows } = openResults(await experiments.downloaded('Rows as JSON'))
  const done = rows.length / countWork(MANY).settings
  expect(Number.isInteger(done)).toBe(true)
  expect(timeless(rows.slice(0, 20))).toEqual(
    timeless([0, 1, 2].flatMap((map) => runMap(MANY, map))).slice(0, 20),
  )
})

test('a run goes on while the results of a shard are looked at, and can be cancelled', async ({
  page,
}) => {
  const experiments = await longRun(page)
  const shard = { index: 2, of: 3 }
  const rows = Array.from({ length: 14 }, (_, i) => runMap(SMALL, 14 + i)).flat()
  await experiments.openFile('shard.jsonl', resultsToLines({ settings: SMALL, shard, rows }))
  await expect(page.getByText('14 maps of shard 2/3, 126 runs, seed 3.')).toBeVisible()
  await page.getByRole('button', { name: 'Cancel' }).click()
  await expect(page.getByText(/^The first [\d,]+ of 21,000 maps, .* runs, seed 3\.$/)).toBeVisible()
})

test('a run is not lost by leaving the page without a question', async ({ page }) => {
  await longRun(page)
  const bar = page.getByRole('progressbar', { name: 'Maps done' })
  await expect(bar).toBeVisible()
  const asked: string[] = []
  page.on('dialog', (dialog) => {
    asked.push(dialog.type())
    return dialog.dismiss()
  })
  const leave = page.getByRole('link', { name: 'Playground' })
  await leave.click()
  await expect.poll(() => asked).toEqual(['beforeunload'])
  await expect(bar).toBeVisible()
  await page.getByRole('button', { name: 'Cancel' }).click()
  await expect(bar).toBeHidden()
  await leave.click()
  await expect(page.locator('#map')).toBeVisible()
  expect(asked).toHaveLength(1)
})

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

test('a wrong field is named where it stands, and nothing is run', async ({ page }) => {
  await new ExperimentsPage(page).open()
  await page.locator('summary', { hasText: 'Probabilistic roadmap' }).click()
  const samples = page.getByLabel('Samples')
  await samples.fill('20, many')
  await expect(samples).toHaveAttribute('aria-invalid', 'true')
  await expect(page.getByText(/"many" is no number/)).toBeVisible()
  await page.getByRole('button', { name: 'Run', exact: true }).click()
  await expect(samples).toBeFocused()
  await expect(page.getByRole('progressbar')).toBeHidden()
  await samples.fill('20, 40')
  await expect(samples).not.toHaveAttribute('aria-invalid', 'true')
  await expect(page.getByText('200 maps × 11 planner settings = 2,200 runs')).toBeVisible()
})

test('who adds and removes planners with the keyboard keeps the focus', async ({ page }) => {
  await new ExperimentsPage(page).open()
  const add = page.getByLabel('Add a planner')
  await add.focus()
  await page.keyboard.press('B')
  await expect(page.getByText('Bug1 is there twice.')).toBeVisible()
  await expect(add).toBeFocused()
  await page.getByRole('button', { name: 'Remove Bug1' }).last().focus()
  await page.keyboard.press('Enter')
  await expect(page.getByText('200 maps × 13 planner settings')).toBeVisible()
  await expect(add).toBeFocused()
})

test('settings are saved and opened again; a file that is broken changes nothing', async ({
  page,
}) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.openFile('mine.json', JSON.stringify(SMALL))
  await expect(page.getByText('42 maps × 9 planner settings = 378 runs')).toBeVisible()
  await experiments.openFile('broken.json', JSON.stringify({ ...SMALL, seed: 'x' }))
  await expect(page.getByText(/broken\.json was not opened\. seed: must be/)).toBeVisible()
  expect(readSettings(await experiments.downloaded('Save'))).toEqual(SMALL)
})

test('maps from files are a family of their own', async ({ page }) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.openFile('own.txt', 'S..\n.#.\n..G\n', '#map-files')
  await expect(page.getByText('own.txt, 3 × 3')).toBeVisible()
  await experiments.openFile('bad.txt', 'S?\n.G\n', '#map-files')
  await expect(page.getByText(/bad\.txt was not opened/)).toBeVisible()
  await page.getByLabel('Least distance').fill('2')
  await expect(page.getByText('220 maps × 13 planner settings')).toBeVisible()
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

test('a link that is broken is refused, and what was drawn stays', async ({ page, map }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  const before = await map.view()
  await page.goto('index.html#setup=nonsense')
  await expect(page.getByRole('alert')).toContainText('The link was not opened. It is damaged')
  expect(await map.view()).toEqual(before)
  expect(new URL(page.url()).hash).toBe('')
})

test('the two pages lead to each other', async ({ page }) => {
  await page.getByRole('button', { name: 'Map', exact: true }).click()
  await page.getByRole('menuitem', { name: 'Experiments' }).click()
  await expect(page.getByRole('heading', { name: 'Experiments' })).toBeVisible()
  await page.getByRole('link', { name: 'Playground' }).click()
  await expect(page.locator('#map')).toBeVisible()
})
