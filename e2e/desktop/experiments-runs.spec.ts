import type { Page } from '@playwright/test'
import { openResults } from '../../src/experiments/open-results'
import { resultsToLines } from '../../src/experiments/results-json'
import { runMap } from '../../src/experiments/run-map'
import { countWork } from '../../src/experiments/settings'
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

test('large numbers have their thousands set apart on axes and beneath lists, too', async ({
  page,
}) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await experiments.run({
    ...SMALL,
    families: [{ family: 'random', params: { density: [30] } }],
    sizes: [[12, 12]],
    mapsPerCombination: 2500,
    planners: [{ planner: 'probabilistic-roadmap', params: { samples: [1, 1000] } }],
  })
  const chart = page.getByRole('region', { name: 'Probabilistic roadmap: success over samples' })
  await expect(chart.locator('svg text').filter({ hasText: /^1,000$/ })).toHaveCount(1)
  await expect(chart.getByRole('button', { name: /^1 sample: / })).toHaveCount(1)
  await expect(chart.getByRole('button', { name: /^1,000 samples: / })).toHaveCount(1)
  const failed = page.getByRole('table', { name: 'Results by planner' }).getByRole('button')
  await failed.filter({ hasText: /^1,\d{3}$/ }).click()
  const more = page.getByRole('button', { name: /^Show 20 more of 1,\d{3}$/ })
  await expect(more).toBeVisible()
})

test('of results out of which rows were taken, the maps that are left are counted', async ({
  page,
}) => {
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  const rows = [1, 4].flatMap((map) => runMap(SMALL, map)).filter(({ setting }) => setting < 2)
  const text = resultsToLines({ settings: SMALL, shard: { index: 1, of: 1 }, rows })
  await experiments.openFile('some.jsonl', text)
  await expect(page.getByText('2 of 42 maps, 4 runs, seed 3.', { exact: true })).toBeVisible()
})
