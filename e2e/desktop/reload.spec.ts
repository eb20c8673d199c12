import { linkTo } from '../../src/app/storage/link'
import { problemFromText } from '../../src/index'
import {
  chooseFromMapMenu,
  choosePlanner,
  expectResult,
  expectSettled,
  openMap,
  saveMap,
} from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ..........
  .S...#..G.
  .....#....
`

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROWS)
})

test('what is drawn survives a reload', async ({ map, page }) => {
  await map.drag([
    [3, 0],
    [3, 1],
  ])
  await map.drag([
    [8, 1],
    [9, 2],
  ])
  await choosePlanner(page, 'Tangent Bug')
  await page.getByLabel('Sensor range').fill('4')
  await page.getByLabel('Variant').selectOption('classic')
  await page.getByLabel('Diagonal steps').selectOption('only-when-no-obstacles')
  // The headline is still that of the plan before while the new one is on its way.
  await expectSettled(page)
  await expectResult(page, /^Reached/)
  const cells = String(await map.element.getAttribute('data-cells'))
  const before = await saveMap(page)
  await page.reload()
  await expect(map.element).toHaveAttribute('data-cells', cells)
  await expect(map.element).toHaveAttribute('data-planner', 'tangent-bug')
  await expect(page.getByLabel('Sensor range')).toHaveValue('4')
  await expect(page.getByLabel('Variant')).toHaveValue('classic')
  expect(await saveMap(page)).toEqual(before)
})

test('what cannot be read after a reload is said, and the page begins anew', async ({
  map,
  page,
}) => {
  await page.evaluate(() => {
    window.addEventListener('pagehide', () => {
      localStorage.setItem('path-planner.setup', '{"version":1,"width":3')
    })
  })
  await page.reload()
  await expect(page.getByText('What was drawn before could not be read')).toBeVisible()
  await expect(map.element).toHaveAttribute('data-status', 'reached')
})

test('a browser that keeps nothing is no reason to stop', async ({ map, page }) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError')
    }
  })
  await page.reload()
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  await map.click([0, 0])
  await expect(page.getByText('This browser keeps nothing for the next visit')).toBeVisible()
  await chooseFromMapMenu(page, 'Clear obstacles')
  await expect(map.element).toHaveAttribute('data-status', 'reached')
})

test('links stay in the address until the first edit, and what was drawn before them is kept', async ({
  map,
  page,
}) => {
  const links = ['S.\n.G', 'S..\n..G'].map((rows) =>
    linkTo({ problem: problemFromText(rows), plannerId: 'bug1', params: {}, seed: 1 }),
  )
  const widthIs = (width: number) =>
    expect(map.element).toHaveAttribute('data-width', String(width))
  for (const [i, link] of links.entries()) {
    await page.evaluate((hash) => {
      window.location.hash = hash
    }, link)
    await widthIs(2 + i)
    expect(new URL(page.url()).hash).toBe(link)
  }
  await page.reload()
  await widthIs(3)

  await page.goto('about:blank')
  await page.goto('')
  await widthIs(10)

  await page.goto(links[1])
  await widthIs(3)
  await choosePlanner(page, 'Bug2')
  await expect.poll(() => new URL(page.url()).hash).toBe('')
  await page.reload()
  await widthIs(3)
  await expect(map.element).toHaveAttribute('data-planner', 'bug2')
})
