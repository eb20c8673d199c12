import type { Locator } from '@playwright/test'
import {
  chooseFromMapMenu,
  choosePlanner,
  drawnRows,
  expectResult,
  openMap,
  plannerSelect,
} from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ........
  .S....G.
  ........
  ........
  ........
`

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROWS)
})

test('a finger draws and erases', async ({ map, page }) => {
  await map.touch([
    [3, 0],
    [3, 2],
    [4, 3],
  ])
  await expectResult(page, /^Reached in [78] cells$/)
  await map.tap(6, 4)
  expect(await drawnRows(page)).toEqual([
    '...#....',
    '...#....',
    '...#....',
    '....#...',
    '......#.',
  ])
  await map.touch([
    [3, 0],
    [3, 2],
  ])
  await map.tap(6, 4)
  expect((await drawnRows(page)).join('')).toMatch(/^\.{28}#\.{11}$/)
})

test('a finger drags start and goal', async ({ map, page }) => {
  await map.touch([
    [6, 1],
    [5, 2],
    [4, 4],
  ])
  await expect(map.element).toHaveAttribute('data-goal', '4,4')
  await expectResult(page, 'Reached in 4 cells')
  await map.touch([
    [1, 1],
    [2, 4],
  ])
  await expect(map.element).toHaveAttribute('data-start', '2,4')
  await expectResult(page, 'Reached in 3 cells')
})

test('two fingers zoom, and what the first had begun to draw is taken back', async ({
  map,
  page,
}) => {
  const before = await map.view()
  await map.touch(
    [
      [3, 2],
      [2, 1],
      [1, 0],
    ],
    [
      [4, 3],
      [5, 4],
      [6, 5],
    ],
  )
  await expect.poll(async () => (await map.view()).scale).toBeGreaterThan(before.scale * 1.5)
  expect((await drawnRows(page)).join('')).not.toContain('#')
  await page.getByRole('button', { name: 'Show the whole map' }).click()
  await expect.poll(() => map.view()).toEqual(before)
})

test('two fingers zoom once where the browser tells of them twice, as Safari does', async ({
  map,
  page,
}) => {
  await map.element.evaluate((element: HTMLElement) => {
    let scale = 1
    element.addEventListener('pointermove', ({ clientX, clientY }) => {
      scale *= 1.2
      const event = new MouseEvent('gesturechange', { clientX, clientY })
      element.dispatchEvent(Object.assign(event, { scale }))
    })
  })
  const { scale } = await map.view()
  await map.touch(
    [
      [3, 2],
      [2.5, 2],
      [2, 2],
    ],
    [
      [4, 2],
      [4.5, 2],
      [5, 2],
    ],
  )
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(scale * 3)
  expect((await drawnRows(page)).join('')).not.toContain('#')
})

test('two fingers move the map', async ({ map, page }) => {
  const before = await map.view()
  await map.touch(
    [
      [2, 1],
      [3, 2],
      [4, 3],
    ],
    [
      [4, 1],
      [5, 2],
      [6, 3],
    ],
  )
  await expect.poll(async () => (await map.view()).left).toBeCloseTo(before.left + 2 * before.scale)
  expect((await map.view()).top).toBeCloseTo(before.top + 2 * before.scale)
  expect((await map.view()).scale).toBeCloseTo(before.scale)
  expect((await drawnRows(page)).join('')).not.toContain('#')
})

test('the cards lie folded at the bottom, and one at a time comes up', async ({ page }) => {
  const planner = page.getByRole('button', { name: 'Fold the planner card' })
  const result = page.getByRole('button', { name: 'Fold the result card' })
  await expect(planner).toHaveAttribute('aria-expanded', 'false')
  await expect(result).toHaveAttribute('aria-expanded', 'false')
  await expectResult(page, 'Reached in 6 cells')
  await expect(page.getByRole('heading', { name: 'Grid decomposition' })).toBeVisible()

  await page.getByRole('heading', { name: 'Grid decomposition' }).tap()
  await expect(planner).toHaveAttribute('aria-expanded', 'true')
  await plannerSelect(page).selectOption('bug1')
  await expect(page.getByLabel('Turn')).toBeInViewport()
  await page.getByRole('heading', { name: 'Reached in 6 cells' }).tap()
  await expect(planner).toHaveAttribute('aria-expanded', 'false')
  await expect(page.getByRole('row', { name: 'Sensed' })).toBeInViewport()
})

test('nothing sticks out of the screen', async ({ map, page }) => {
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390)
  const { left, top, scale, width, height } = await map.view()
  expect(left).toBeGreaterThanOrEqual(0)
  expect(top).toBeGreaterThanOrEqual(0)
  expect(left + scale * width).toBeLessThanOrEqual(390)
  expect(top + scale * height).toBeLessThanOrEqual(844)
  for (const name of ['Map', 'Undo', 'Redo', 'Zoom in', 'Zoom out', 'Help and keys']) {
    await expect(page.getByRole('button', { name, exact: true })).toBeInViewport({ ratio: 1 })
  }
})

test('on a narrow phone, too, speed and view stay beside what they belong to', async ({ page }) => {
  await choosePlanner(page, 'Bug2')
  await page.setViewportSize({ width: 360, height: 740 })
  const middleOf = async (part: Locator) => {
    const box = await part.boundingBox()
    return box ? box.y + box.height / 2 : Number.NaN
  }
  const rows: [Locator, Locator][] = [
    [page.getByLabel('Speed'), page.getByRole('button', { name: 'To the beginning' })],
    [page.getByLabel("Rover's view"), page.getByText(/^Step \d+ of/)],
  ]
  for (const [field, mate] of rows) {
    expect(Math.abs((await middleOf(field)) - (await middleOf(mate)))).toBeLessThan(6)
  }
})

test('what explains the comparison stays where the table is moved sideways', async ({ page }) => {
  await page.getByRole('button', { name: 'Compare planners' }).click()
  const comparison = page.getByRole('region', { name: 'Comparison of planners' })
  const note = comparison.getByText('Ratio: steps of the path')
  const before = await note.boundingBox()
  const moved = await comparison.getByRole('table').evaluate((table) => {
    const body = table.parentElement
    body?.scrollBy(150, 0)
    return body?.scrollLeft
  })
  expect(moved).toBe(150)
  expect(await note.boundingBox()).toEqual(before)
})

test('Safari zooms the page to no field for its small letters', async ({ page }) => {
  await chooseFromMapMenu(page, 'New…')
  for (const path of ['index.html', 'experiments.html']) {
    const sizes = await page
      .locator('select, input[type=number], input[type=text]')
      .evaluateAll((fields) => fields.map((field) => parseFloat(getComputedStyle(field).fontSize)))
    expect(Math.min(...sizes), path).toBeGreaterThanOrEqual(16)
    await page.goto('experiments.html')
  }
})
