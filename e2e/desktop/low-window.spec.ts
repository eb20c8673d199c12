import type { Locator, Page } from '@playwright/test'
import { chooseFromMapMenu, unfold } from '../actions'
import { expect, test } from '../fixtures'
import { hiddenParts } from '../hidden-parts'
import { currentLine, openScenario, playback, reasons, scrubber } from '../steps'

const SIZES = [
  { name: 'a phone held sideways', width: 844, height: 390 },
  { name: 'a window zoomed to 200 %', width: 640, height: 400 },
  { name: 'the smallest phone', width: 320, height: 568 },
]

/** Nothing lies over its middle, if need be once it has been scrolled to. */
const expectInReach = (element: Locator) => element.click({ trial: true })

/** Cards that stand one below the other, and lie on one another all the same. */
async function overlaps(page: Page): Promise<string[]> {
  return page.getByRole('main').evaluate((main) => {
    const cards = Array.from(main.querySelectorAll('section'), (card) => {
      const { left, right, top, bottom } = card.getBoundingClientRect()
      return { name: card.id, left, right, top, bottom }
    }).filter(({ name, top, bottom }) => name !== 'toolbar' && bottom > top)
    return cards.flatMap((one, i) =>
      cards
        .slice(i + 1)
        .filter(
          (other) =>
            Math.min(one.right, other.right) - Math.max(one.left, other.left) > 1 &&
            Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 1,
        )
        .map((other) => `${one.name} and ${other.name}`),
    )
  })
}

async function expectPlaybackInReach(page: Page) {
  await expectInReach(scrubber(page))
  await expectInReach(playback(page).getByRole('button', { name: 'Step back' }))
  await expectInReach(page.getByRole('combobox', { name: "Rover's view" }))
  expect(await overlaps(page)).toEqual([])
}

for (const { name, ...size } of SIZES) {
  test(`on ${name} all that a card holds can be reached`, async ({ page }) => {
    await page.setViewportSize(size)
    await openScenario(page, 'Fig. 11: Two obstacles, Bug2')
    await expectPlaybackInReach(page)
    await page.getByRole('button', { name: 'Map', exact: true }).click()
    await expectInReach(page.getByRole('menuitem', { name: 'Experiments' }))
    await page.keyboard.press('Escape')
    await unfold(page, 'result')
    await expectInReach(page.getByRole('rowheader', { name: 'Sensed' }))
    await unfold(page, 'planner')
    await expectInReach(page.getByLabel('Diagonal steps'))
    const steps = page.getByRole('button', { name: 'Fold the card of steps' })
    if ((await steps.getAttribute('aria-expanded')) === 'false') await steps.click()
    await expectInReach(
      reasons(page)
        .getByText(/^The end at/)
        .filter({ visible: true }),
    )
    await expectInReach(reasons(page).getByText(/^as soon as the goal is met/))
    await expectPlaybackInReach(page)
    await page.getByRole('button', { name: 'Compare planners' }).click()
    const comparison = page.getByRole('region', { name: 'Comparison of planners' })
    await expectInReach(comparison.getByLabel('Tangent Bug'))
    await expectInReach(comparison.getByText('Ratio: steps of the path'))
    await expectPlaybackInReach(page)
  })
}

for (const size of [
  { width: 1024, height: 768 },
  { width: 900, height: 600 },
  { width: 800, height: 800 },
]) {
  const name = `${size.width} × ${size.height}`
  test(`all of the playback is in a window of ${name} beside the comparison`, async ({ page }) => {
    await page.setViewportSize(size)
    await page.getByRole('button', { name: 'Compare planners' }).click()
    const comparison = page.getByRole('region', { name: 'Comparison of planners' })
    await expectInReach(comparison.getByLabel('Tangent Bug'))
    await expect(playback(page)).toBeInViewport({ ratio: 1 })
    await page.getByRole('button', { name: 'Fold the card of steps' }).click()
    await expect(playback(page)).toBeInViewport({ ratio: 1 })
    await expectPlaybackInReach(page)
  })
}

const foldSteps = (page: Page) => page.getByRole('button', { name: 'Fold the card of steps' })
const foldComparison = (page: Page) => page.getByRole('button', { name: 'Fold the comparison' })

for (const size of [
  { width: 1366, height: 500 },
  { width: 900, height: 600 },
  { width: 760, height: 580 },
  { width: 641, height: 580 },
  { width: 853, height: 480 },
  { width: 640, height: 360 },
]) {
  const name = `${size.width} × ${size.height}`
  test(`in a window of ${name} the comparison and the steps take turns`, async ({ page }) => {
    await page.setViewportSize(size)
    const comparison = page.getByRole('region', { name: 'Comparison of planners' })
    const firstRow = comparison.getByRole('row', { name: /^Grid decomposition/ })
    const compare = page.getByRole('button', { name: 'Compare planners' })
    await expect(foldSteps(page)).toHaveAttribute('aria-expanded', 'false')
    await foldSteps(page).click()
    await expect(foldSteps(page)).toHaveAttribute('aria-expanded', 'true')
    await compare.click()
    await expect(foldSteps(page)).toHaveAttribute('aria-expanded', 'false')
    await expect(firstRow).toBeInViewport({ ratio: 0.3 })
    await foldSteps(page).click()
    await expect(foldComparison(page)).toHaveAttribute('aria-expanded', 'false')
    await expect(firstRow).toBeHidden()
    await expect(currentLine(page)).toBeInViewport({ ratio: 0.9 })
    await expectPlaybackInReach(page)
    // One that comes again comes unfolded.
    await compare.click()
    await expect(comparison).toBeHidden()
    await compare.click()
    await expect(firstRow).toBeInViewport({ ratio: 0.3 })
  })
}

test('a comparison that is folded leaves its head only, below the steps', async ({ page }) => {
  await page.setViewportSize({ width: 1366, height: 768 })
  const comparison = page.getByRole('region', { name: 'Comparison of planners' })
  await page.getByRole('button', { name: 'Compare planners' }).click()
  await expect(comparison.getByRole('table')).toBeVisible()
  await foldComparison(page).click()
  await expect(comparison.getByRole('table')).toBeHidden()
  await expect(foldSteps(page)).toHaveAttribute('aria-expanded', 'true')
  expect(await overlaps(page)).toEqual([])
  await foldComparison(page).click()
  await expect(comparison.getByRole('table')).toBeVisible()
})

for (const size of [
  { width: 1280, height: 720, compared: true },
  { width: 1024, height: 768, compared: false },
  { width: 853, height: 480, compared: false },
  { width: 390, height: 667, compared: false },
]) {
  const beside = size.compared ? ' beside the comparison' : ''
  test(`the line of the step is in sight in ${size.width} × ${size.height}${beside}`, async ({
    page,
  }) => {
    await page.setViewportSize(size)
    if (size.compared) await page.getByRole('button', { name: 'Compare planners' }).click()
    // Cards that begin folded in such a window are folded a little later.
    await expect(async () => {
      const isOpen = (await foldSteps(page).getAttribute('aria-expanded')) === 'true'
      if (!isOpen) await foldSteps(page).click()
      await expect(currentLine(page)).toHaveText('as soon as the goal is met: done')
      await expect(currentLine(page)).toBeInViewport({ ratio: 0.9, timeout: 1000 })
    }).toPass()
  })
}

for (const size of [
  { width: 640, height: 400 },
  { width: 640, height: 480 },
  { width: 568, height: 320 },
]) {
  const window = `a window of ${size.width} × ${size.height}`
  test(`the map is seen at first in ${window}, clear of the cards`, async ({ map, page }) => {
    await page.setViewportSize(size)
    await page.reload()
    await expect(map.element).toHaveAttribute('data-status', 'reached')
    await expect.poll(() => hiddenParts(page, map)).toEqual([])
    const { scale, height } = await map.view()
    expect(scale * height, 'pixels from its top to its bottom').toBeGreaterThan(size.height / 2)
  })
}

test('on the smallest phone nothing has to be moved sideways', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 568 })
  const bar = await page.getByRole('region', { name: 'Map and view' }).boundingBox()
  expect(bar?.height, 'one row of buttons').toBeLessThan(60)
  for (const [entry, title] of [
    ['Scenarios…', 'Scenarios'],
    ['Generate…', 'Generate a map'],
    ['New…', 'New map'],
  ]) {
    await chooseFromMapMenu(page, entry)
    const dialog = page.getByRole('dialog', { name: title })
    await expect(dialog).toBeVisible()
    const beyond = await dialog.evaluate((box) => box.scrollWidth - box.clientWidth)
    expect(beyond, title).toBe(0)
    await page.keyboard.press('Escape')
  }
})

for (const { width, rows } of [
  { width: 768, rows: 1 },
  { width: 641, rows: 2 },
]) {
  test(`in a window ${width} pixels wide the buttons of the steps take ${rows} of its rows`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height: 1000 })
    const bar = playback(page)
    const names = [
      'Move the bar of steps',
      'To the beginning',
      'To the end',
      'Fold the bar of steps',
    ]
    const parts = [
      ...names.map((name) => bar.getByRole('button', { name })),
      bar.getByLabel('Speed'),
    ]
    const boxes = await Promise.all(parts.map((part) => part.boundingBox()))
    // They differ in height: those whose middles are close stand in one row.
    const middles = boxes.map((box) =>
      box ? Math.round((box.y + box.height / 2) / 10) : Number.NaN,
    )
    expect(new Set(middles).size).toBe(rows)
  })
}
