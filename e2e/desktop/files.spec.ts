import type { Page, Route } from '@playwright/test'
import {
  choosePlanner,
  drawnRows,
  dropFile,
  expectResult,
  openFile,
  openMap,
  saveMap,
} from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ..........
  .S...#..G.
  .....#....
`

/** A file of the original program: columns, and things that do not matter here. */
const ORIGINAL = JSON.stringify({
  size: { x: 4, y: 3 },
  wall_map: [
    [0, 0, 0],
    [0, 1, 1],
    [0, 0, 0],
    [1, 0, 0],
  ],
  potential_map: [],
  agent: { x: 1 },
})

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROWS)
})

test('what is saved can be opened again and is the same', async ({ map, page }) => {
  await page.getByLabel('Diagonal steps').selectOption('only-when-no-obstacles')
  await map.drag([
    [7, 0],
    [7, 1],
  ])
  const saved = await saveMap(page)
  expect(saved.name).toBe('path-planner-10x3.json')
  expect(JSON.parse(saved.text)).toEqual({
    format: 'path-planner',
    version: 1,
    diagonal: 'only-when-no-obstacles',
    start: [1, 1],
    goal: [8, 1],
    rows: ['.......#..', '.....#.#..', '.....#....'],
  })
  await expectResult(page, /^Reached/)
  const cells = String(await map.element.getAttribute('data-cells'))

  await openMap(page, 'S.\n.G')
  await page.getByLabel('Diagonal steps').selectOption('if-at-most-one-obstacle')
  await expect(map.element).toHaveAttribute('data-width', '2')
  await openFile(page, saved.name, saved.text)
  await expect(page.getByText(`Opened ${saved.name}: 10 × 3 cells.`).first()).toBeVisible()
  await expect(page.getByLabel('Diagonal steps')).toHaveValue('only-when-no-obstacles')
  await expect(map.element).toHaveAttribute('data-cells', cells)
  expect(await saveMap(page)).toEqual(saved)
})

test('a file of the original program', async ({ map, page }) => {
  await openFile(page, 'old.json', ORIGINAL)
  const note = 'Opened old.json: 4 × 3 cells. The file has no start or goal: they were put at '
  const message = page.getByText(note)
  await expect(message).toBeVisible()
  expect(await drawnRows(page)).toEqual(['...#', '.#..', '.#..'])
  await expectResult(page, /^Reached in \d cells$/)
  const { start, goal } = await map.element.evaluate((element) => ({ ...element.dataset }))
  const place = (cell = '') => `(${cell.replace(',', ', ')})`
  await expect(message).toHaveText(`${note}${place(start)} and ${place(goal)}.`)
})

test('a map of the MovingAI benchmarks, and that it brings another diagonal rule', async ({
  page,
}) => {
  const rule = page.getByLabel('Diagonal steps')
  await expect(rule).toHaveValue('if-at-most-one-obstacle')
  await expect(page.getByText('Diagonal steps are now')).toHaveCount(0)
  await openFile(page, 'arena.map', 'type octile\nheight 2\nwidth 3\nmap\n...\n.@.\n')
  await expect(page.getByText(/^Opened arena\.map: 3 × 2 cells\./).first()).toBeVisible()
  await expect(page.getByText('Diagonal steps are now: Only when no obstacles.')).toBeVisible()
  await expect(rule).toHaveValue('only-when-no-obstacles')
})

test('a file dropped on the map is opened, and that is one step to undo', async ({ map, page }) => {
  await dropFile(page, 'small.txt', 'S..\n.#.\n..G')
  await expect(page.getByText('Opened small.txt: 3 × 3 cells.').first()).toBeVisible()
  await expect(map.element).toHaveAttribute('data-height', '3')
  await expectResult(page, 'Reached in 4 cells')
  await page.keyboard.press('Control+z')
  await expect(map.element).toHaveAttribute('data-width', '10')
  await expectResult(page, 'Reached in 8 cells')
})

test('of files that are dropped together the first is opened, and that is told', async ({
  page,
}) => {
  await dropFile(page, 'first.txt', 'S..\n.#.\n..G', ['second.txt', 'third.scen'])
  await expect(page.getByText('Opened first.txt: 3 × 3 cells.').first()).toBeVisible()
  await expect(page.getByText('Of 3 files only the first, first.txt, was taken.')).toBeVisible()
})

/** Holds back what the next file is read by; returns what lets it go on. */
async function holdReader(page: Page): Promise<() => Promise<void>> {
  const held: Route[] = []
  const hold = async (route: Route) => {
    held.push(route)
  }
  await page.route(/open-worker/, hold, { times: 1 })
  return async () => {
    // Nobody may be waiting for it any more.
    for (const route of held) await route.continue().catch(() => {})
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)))
  }
}

test('of two files that are read at once, the one that was asked for last is opened', async ({
  map,
  page,
}) => {
  const readFirst = await holdReader(page)
  await dropFile(page, 'first.txt', 'S.\n.G')
  await dropFile(page, 'last.txt', 'S..\n..G')
  await expect(page.getByText(/^Opened last\.txt/).first()).toBeVisible()
  await readFirst()
  await expect(map.element).toHaveAttribute('data-width', '3')
  await expect(page.getByText('first.txt')).toHaveCount(0)
})

test.describe('while a file is read', () => {
  test('that is shown, the page goes on, and it can be cancelled', async ({ map, page }) => {
    const before = await drawnRows(page)
    const read = await holdReader(page)
    await dropFile(page, 'large.txt', 'S.\n.G')
    await expect(page.getByRole('progressbar', { name: 'Opening large.txt…' })).toBeVisible()
    await page.getByRole('button', { name: 'Cancel' }).click()
    await expect(page.getByText('Cancelled.')).toBeVisible()
    await read()
    expect(await drawnRows(page)).toEqual(before)
    await map.click([0, 0])
    await expectResult(page, /^Reached/)
  })

  test('what is drawn stays', async ({ map, page }) => {
    const read = await holdReader(page)
    await dropFile(page, 'large.txt', 'S.\n.G')
    await map.click([0, 0])
    const words = 'large.txt was not opened, because the map on screen was changed meanwhile.'
    await expect(page.getByText(words)).toBeVisible()
    await read()
    expect((await drawnRows(page))[0]).toBe('#.........')
  })
})
