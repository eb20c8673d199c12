import { choosePlanner, expectSettled, openMap, saveMap } from '../actions'
import { expect, test } from '../fixtures'

const ROOM = `
  ............
  ............
  .S........G.
  ............
  ............
  ............
`

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROOM)
})

test('everything can be undone and redone', async ({ map, page }) => {
  const undo = page.getByRole('button', { name: 'Undo' })
  const redo = page.getByRole('button', { name: 'Redo' })
  // The choice of the planner, and the map that was opened.
  for (let step = 0; step < 2; step++) await undo.click()
  await expect(undo).toHaveAttribute('aria-disabled', 'true')
  await expectSettled(page)
  const planner = await map.element.getAttribute('data-planner')
  const before = await saveMap(page)

  await openMap(page, ROOM)
  await map.drag([
    [6, 0],
    [6, 4],
  ])
  await map.click([6, 2])
  await map.drag([
    [10, 2],
    [5, 4],
  ])
  await map.click([8, 1], 'right')
  await choosePlanner(page, 'Bug2')
  await page.getByLabel('Turn').selectOption('right')
  await page.getByLabel('Diagonal steps').selectOption('only-when-no-obstacles')
  await expectSettled(page)
  const after = await saveMap(page)
  const cells = await map.element.getAttribute('data-cells')

  for (let step = 0; step < 8; step++) await undo.click()
  await expect(undo).toHaveAttribute('aria-disabled', 'true')
  await expect(map.element).toHaveAttribute('data-planner', String(planner))
  expect(await saveMap(page)).toEqual(before)

  for (let step = 0; step < 8; step++) await redo.click()
  await expect(redo).toHaveAttribute('aria-disabled', 'true')
  await expect(page.getByLabel('Turn')).toHaveValue('right')
  await expect(map.element).toHaveAttribute('data-cells', String(cells))
  expect(await saveMap(page)).toEqual(after)
})

test('an edit after undoing leaves nothing to redo', async ({ map, page }) => {
  await map.click([6, 2])
  await page.keyboard.press('Control+z')
  await expect(page.getByRole('button', { name: 'Redo' })).toHaveAttribute('aria-disabled', 'false')
  await map.click([7, 2])
  await expect(page.getByRole('button', { name: 'Redo' })).toHaveAttribute('aria-disabled', 'true')
})
