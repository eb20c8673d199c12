import { chooseFromMapMenu, choosePlanner, expectResult, openMap, saveMap } from '../actions'
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
  await map.click([0, 0])
  await expect(page.getByText('This browser keeps nothing for the next visit')).toBeVisible()
  await chooseFromMapMenu(page, 'Clear obstacles')
  await expect(map.element).toHaveAttribute('data-status', 'reached')
})
