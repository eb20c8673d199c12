import type { Page } from '@playwright/test'
import { openMap as readMap } from '../../src/grid/formats/open-map'
import { generators } from '../../src/grid/generators'
import { plan, planners, problemToText } from '../../src/index'
import {
  choosePlanner,
  createMap,
  expectResult,
  expectSaid,
  expectSettled,
  openFile,
  openMap,
  plannerSelect,
  saveMap,
  setParam,
} from '../actions'
import { expect, test } from '../fixtures'

/** Walls across the whole map, with a gap at the right and at the left in turn. */
function windingWay(side: number): string {
  const row = (_: unknown, y: number) => {
    const wall = y % 2 === 1 ? '#' : '.'
    const middle = wall.repeat(side - 2)
    if (y === 0) return `S${middle}.`
    if (y === side - 1) return `.${middle}G`
    return y % 4 === 1 ? `${wall}${middle}.` : `.${middle}${wall}`
  }
  return Array.from({ length: side }, row).join('\n')
}

/** A plan that takes minutes: the rover looks far around it at each step of its many detours. */
async function startLongPlan(page: Page): Promise<void> {
  await choosePlanner(page, 'Tangent Bug')
  await setParam(page, 'Variant', 'classic')
  await setParam(page, 'Line of sight', true)
  await setParam(page, 'Sensor range', 50)
  await openFile(page, 'map.txt', windingWay(301))
  await expectResult(page, 'Planning…')
}

const randomMap = problemToText(
  generators[0].generate({ width: 60, height: 40 }, { density: 20 }, 3, 'if-at-most-one-obstacle'),
)

test('a long plan shows how far it is, and the page still answers', async ({ map, page }) => {
  await startLongPlan(page)
  const progress = page.getByRole('progressbar', { name: 'Planning' })
  await expect(progress).toBeVisible()
  await expect(map.element).toHaveAttribute('data-status', 'planning')

  const { scale } = await map.view()
  await page.getByRole('button', { name: 'Zoom in' }).click()
  await expect.poll(async () => (await map.view()).scale).toBeGreaterThan(scale)
  const longestFrame = await page.evaluate(async () => {
    let longest = 0
    let last = performance.now()
    for (let i = 0; i < 30; i++) {
      const now = await new Promise<number>((resolve) => requestAnimationFrame(resolve))
      longest = Math.max(longest, now - last)
      last = now
    }
    return longest
  })
  expect(longestFrame).toBeLessThan(500)
  await expect(progress).toBeVisible()
})

test('a long plan can be cancelled and asked for again', async ({ map, page }) => {
  await startLongPlan(page)
  await page.getByRole('button', { name: 'Cancel' }).click()
  await expectResult(page, 'Cancelled')
  await expect(map.element).toHaveAttribute('data-status', 'cancelled')
  await expect(page.getByRole('progressbar', { name: 'Planning' })).toBeHidden()
  await expect(page.getByText('Tangent Bug was stopped before it came to an answer.')).toBeVisible()
  await page.getByRole('button', { name: 'Plan again' }).click()
  await expectResult(page, 'Planning…')
  await page.getByRole('button', { name: 'Cancel' }).click()
  await expectSaid(page, 'Planner: Tangent Bug. Planning was cancelled.')
  await choosePlanner(page, 'Grid decomposition')
  await expectResult(page, /^Reached in [\d,]+ cells$/)
})

test('the focus stays in the card when the button that has it goes', async ({ page }) => {
  await startLongPlan(page)
  await page.getByRole('button', { name: 'Cancel' }).focus()
  await page.keyboard.press('Enter')
  await expectResult(page, 'Cancelled')
  await expect(page.getByRole('button', { name: 'Plan again' })).toBeFocused()
  await page.keyboard.press('Enter')
  await expectResult(page, 'Planning…')
  // On its only button, or on the next one to cancel with if that is there at once.
  await expect(
    page.getByRole('region', { name: 'Planning…' }).locator('button:focus'),
  ).toBeVisible()
})

test('a plan that nobody waits for any more is dropped', async ({ map, page }) => {
  await startLongPlan(page)
  await choosePlanner(page, 'Bug1')
  await expectSaid(page, /^Planner: Bug1\. Reached in [\d,]+ cells\.$/)
  await expect(map.element).toHaveAttribute('data-planner', 'bug1')
  await expect(map.element).toHaveAttribute('data-run', 'settled')
})

test('progress is told in numbers where the planner knows them', async ({ map, page }) => {
  await choosePlanner(page, 'Grid decomposition')
  const told = page.getByRole('progressbar', { includeHidden: true }).evaluate(
    (bar) =>
      new Promise<number[]>((resolve) => {
        const values: number[] = []
        const note = () => {
          const value = bar.getAttribute('aria-valuenow')
          if (value !== null) values.push(Number(value))
          if (document.querySelector('#map[data-width="2048"][data-status="reached"]'))
            resolve(values)
        }
        new MutationObserver(note).observe(document.body, { subtree: true, attributes: true })
      }),
  )
  await createMap(page, 2048, 2048)
  await expect(map.element).toHaveAttribute('data-status', 'reached', { timeout: 20_000 })
  const values = await told
  expect(values.length).toBeGreaterThan(0)
  expect(values).toEqual(values.toSorted((a, b) => a - b))
  expect(values.at(-1)).toBeLessThanOrEqual(100)
})

test('after many quick edits the plan of the last one stands', async ({ map, page }) => {
  await openMap(page, randomMap)
  for (const { id } of planners) {
    await plannerSelect(page).selectOption(id)
    await map.drag([
      [20, 2],
      [28, 36],
      [31, 3],
    ])
    await page.keyboard.press('Control+z')
    await map.drag([
      [50, 35],
      [45, 4],
    ])
    await expectSettled(page)
    const { problem } = readMap((await saveMap(page)).text)
    const { status, path } = plan(problem, id)
    await expect(map.element).toHaveAttribute('data-status', status)
    await expect(map.element).toHaveAttribute('data-cells', String(path.length))
  }
})

test('on a map of 60 × 40 cells each plan is there within a few frames of the edit', async ({
  map,
  page,
}) => {
  await openMap(page, randomMap)
  await map.element.focus()
  for (const { title, id } of planners) {
    await choosePlanner(page, title)
    await expect(map.element).toHaveAttribute('data-planner', id)
    await expectSettled(page)
    await map.element.focus()
    // On a machine with nothing else to do it is one frame. Of several edits the quickest counts.
    const frames = await map.element.evaluate(async (element) => {
      const nextFrame = () => new Promise(requestAnimationFrame)
      const counts: number[] = []
      for (let edit = 0; edit < 12; edit++) {
        await nextFrame()
        const key = edit % 2 === 0 ? 'ArrowUp' : 'ArrowDown'
        element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }))
        element.dispatchEvent(new KeyboardEvent('keydown', { key: 's', bubbles: true }))
        let count = 0
        while (element.dataset.status === 'planning') {
          await nextFrame()
          count++
        }
        counts.push(count)
      }
      return counts
    })
    const fewest = Math.min(...frames.filter((count) => count > 0))
    expect(fewest, `${title}: ${frames}`).toBeLessThanOrEqual(3)
  }
})
