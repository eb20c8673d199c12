import type { Locator, Page } from '@playwright/test'
import { generators } from '../../src/grid/generators'
import { plan, planners, problemFromText, problemToText } from '../../src/index'
import { pathStyles } from '../../src/render/path-styles'
import { expectAccessible } from '../accessibility'
import { choosePlanner, expectSaid, openMap } from '../actions'
import { expect, test } from '../fixtures'
import { playback } from '../steps'

const MAP = `
..............
..S...........
.......##.....
.......##.....
..#######.....
.......##.....
...........G..
..............
`.trim()

const card = (page: Page) => page.getByRole('region', { name: 'Comparison of planners' })
const lineOf = (page: Page, title: string): Locator =>
  card(page)
    .getByRole('row')
    .filter({ has: page.getByRole('checkbox', { name: title, exact: true }) })

async function compare(page: Page): Promise<void> {
  await openMap(page, MAP)
  await page.getByRole('button', { name: 'Compare planners' }).click()
  const words = `^Compared: \\d of ${planners.length} planners reach the goal; .+\\.$`
  await expectSaid(page, new RegExp(words))
}

/** The cells of a row that do not depend on the clock. */
function numbersOf(text: string, id: string): string[] {
  const { measure, path } = plan(problemFromText(text), id)
  if (path.length === 0) return ['–', '–', '–', '–']
  const { cells, length, turns } = measure
  return [String(cells), length.toFixed(2), String(turns), String(cells - 1)]
}

async function expectTable(page: Page, text: string): Promise<void> {
  for (const { id, title } of planners) {
    const cells = lineOf(page, title).getByRole('cell')
    const read = async () => {
      const texts = await cells.allTextContents()
      return [texts[1], texts[2], texts[4], texts[6]]
    }
    await expect.poll(read, { message: title }).toEqual(numbersOf(text, id))
    await expect(cells.last()).toHaveText(/^\d[\d.]* (µs|ms)$/)
  }
}

test('one press tells of every planner what plan() tells', async ({ page }) => {
  await compare(page)
  await expect(page.getByRole('button', { name: 'Compare planners' })).toHaveAttribute(
    'aria-pressed',
    'true',
  )
  await expectTable(page, MAP)
  await expect(lineOf(page, 'Grid decomposition').getByRole('cell').nth(3)).toHaveText('1.00')
  await expect(lineOf(page, 'Bug1').getByRole('cell').nth(7)).toHaveText(/^≤ \d+$/)
  await expect(card(page).getByText('Algorithmica 2, 1987')).toBeAttached()
  await expectAccessible(page)
})

test('the table is sorted by its heads, with the keyboard too', async ({ page }) => {
  await compare(page)
  const head = card(page).getByRole('columnheader', { name: 'Cells' })
  const cells = async () => {
    const texts = await card(page).locator('tbody td:nth-child(3)').allTextContents()
    return texts.filter((text) => text !== '–').map(Number)
  }
  await head.getByRole('button').focus()
  await page.keyboard.press('Enter')
  await expect(head).toHaveAttribute('aria-sort', 'ascending')
  const ascending = await cells()
  expect(ascending).toEqual(ascending.toSorted((a, b) => a - b))
  await page.keyboard.press('Enter')
  await expect(head).toHaveAttribute('aria-sort', 'descending')
  expect(await cells()).toEqual(ascending.toReversed())
})

test('a path is drawn in its colour, hidden and shown by its row', async ({ map, page }) => {
  await compare(page)
  const { path } = plan(problemFromText(MAP), 'decomposition')
  const middle = path[Math.floor(path.length / 2)]
  const place = [middle % 14, Math.floor(middle / 14)] as const
  const { dark } = pathStyles[0].colour
  const isDrawn = async () => (await map.coloursIn(...place)).has(dark)
  await expect.poll(isDrawn).toBe(true)
  const box = page.getByRole('checkbox', { name: 'Grid decomposition', exact: true })
  await box.uncheck()
  await expect.poll(isDrawn).toBe(false)
  await box.press('Space')
  await expect(box).toBeChecked()
  await expect.poll(isDrawn).toBe(true)
})

test('an edit updates the table, and the comparison ends', async ({ map, page }) => {
  await compare(page)
  await map.click([10, 1])
  await map.click([10, 5])
  const rows = MAP.split('\n').map((row, y) =>
    y === 1 || y === 5 ? `${row.slice(0, 10)}#${row.slice(11)}` : row,
  )
  await expectTable(page, rows.join('\n'))
  await page.getByRole('button', { name: 'End the comparison' }).click()
  await expect(card(page)).toBeHidden()
  await expect(page.getByRole('button', { name: 'Compare planners' })).toBeFocused()
})

test('it is as wide as the playback below it, folded too', async ({ page }) => {
  await page.setViewportSize({ width: 1920, height: 1080 })
  await compare(page)
  const sides = (part: Locator) =>
    part.evaluate((element) => {
      const { left, right } = element.getBoundingClientRect()
      return [left, right]
    })
  expect(await sides(card(page))).toEqual(await sides(playback(page)))
  await page.getByRole('button', { name: 'Fold the comparison' }).click()
  await expect(card(page).getByRole('table')).toBeHidden()
  expect(await sides(card(page))).toEqual(await sides(playback(page)))
})

test('of a large map no number is cut off', async ({ page }) => {
  const size = { width: 1000, height: 1000 }
  const rule = 'if-at-most-one-obstacle'
  await choosePlanner(page, 'Bug1')
  await openMap(page, problemToText(generators[0].generate(size, { density: 20 }, 1, rule)))
  await page.getByRole('button', { name: 'Compare planners' }).click()
  await expect(lineOf(page, 'Tangent Bug').getByRole('cell').last()).toHaveText(/s$/)
  const [right, edge] = await Promise.all(
    [lineOf(page, 'Bug1').getByRole('cell').last(), card(page)].map((part) =>
      part.evaluate((element) => element.getBoundingClientRect().right),
    ),
  )
  expect(right).toBeLessThanOrEqual(edge)
})
