import { themes } from '../../src/render/theme'
import {
  chooseFromMapMenu,
  choosePlanner,
  drawnRows,
  expectResult,
  expectSaid,
  openMap,
} from '../actions'
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

test('a press on a free cell draws, a press on an obstacle erases', async ({ map, page }) => {
  await map.drag([
    [6, 0],
    [6, 4],
  ])
  await expectSaid(page, '5 cells are now obstacles. Reached in 10 cells.')
  expect(await drawnRows(page)).toEqual([
    '......#.....',
    '......#.....',
    '......#.....',
    '......#.....',
    '......#.....',
    '............',
  ])
  await map.drag([
    [6, 2],
    [6, 3],
  ])
  await expectSaid(page, '2 cells are now free. Reached in 10 cells.')
  await map.click([8, 5])
  await expectSaid(page, '(8, 5) is now an obstacle. Reached in 10 cells.')
  expect(await drawnRows(page)).toEqual([
    '......#.....',
    '......#.....',
    '............',
    '............',
    '......#.....',
    '........#...',
  ])
})

test('a fast stroke has no holes and spares start and goal', async ({ map, page }) => {
  await map.press([0, 0])
  const { x, y } = await map.cell(11, 2)
  await page.mouse.move(x, y)
  await map.moveTo(1, 2)
  await map.release()
  expect(await drawnRows(page)).toEqual([
    '###.........',
    '...######...',
    '..########.#',
    '............',
    '............',
    '............',
  ])
  await expect(map.element).toHaveAttribute('data-start', '1,2')
  await expect(map.element).toHaveAttribute('data-goal', '10,2')
})

test('the path follows the stroke while the button is down', async ({ map, page }) => {
  await expectResult(page, 'Reached in 10 cells')
  await map.press([6, 0])
  await map.moveTo(6, 4)
  await expect(map.element).toHaveAttribute('data-cells', '10')
  await expectResult(page, 'Reached in 10 cells')
  await map.moveTo(6, 5)
  await expectResult(page, /^Proven unreachable: every cell that can be reached/)
  await page.keyboard.press('Escape')
  await expectResult(page, 'Reached in 10 cells')
  await map.release()
  expect((await drawnRows(page)).join('')).not.toContain('#')
})

test('the goal is dragged across an obstacle and back', async ({ map, page }) => {
  await map.drag([
    [6, 1],
    [6, 3],
  ])
  await map.press([10, 2])
  await map.moveTo(6, 2)
  await expect(map.element).toHaveAttribute('data-goal', '7,2')
  await map.moveTo(4, 2)
  await expect(map.element).toHaveAttribute('data-goal', '4,2')
  await expectResult(page, 'Reached in 4 cells')
  await map.moveTo(9, 2)
  await expect(map.element).toHaveAttribute('data-goal', '9,2')
  await expectResult(page, 'Reached in 9 cells')
  await map.release()
  await expectSaid(page, 'The goal is now at (9, 2). Reached in 9 cells.')
})

test('start and goal may share a cell and come apart again', async ({ map, page }) => {
  await map.drag([
    [1, 2],
    [10, 2],
  ])
  await expect(map.element).toHaveAttribute('data-start', '10,2')
  await expectResult(page, 'Reached in 1 cell')
  await map.drag([
    [10, 2],
    [3, 2],
  ])
  await expect(map.element).toHaveAttribute('data-goal', '3,2')
  await expectResult(page, 'Reached in 8 cells')
})

test('the right button sets the start, then the goal, and so on', async ({ map, page }) => {
  await map.click([2, 4], 'right')
  await expectSaid(page, /^The start is now at \(2, 4\)/)
  await map.click([9, 4], 'right')
  await expectSaid(page, /^The goal is now at \(9, 4\)/)
  await expectResult(page, 'Reached in 8 cells')
  await map.click([5, 5])
  await map.click([5, 5], 'right')
  await expect(page.getByText(/The start cannot be set at \(5, 5\): an obstacle/)).toBeVisible()
  await map.click([3, 4], 'right')
  await expect(map.element).toHaveAttribute('data-start', '3,4')
})

test('all obstacles are cleared at once', async ({ map, page }) => {
  await map.drag([
    [4, 0],
    [4, 5],
  ])
  await chooseFromMapMenu(page, 'Clear obstacles')
  await expectSaid(page, 'All obstacles are cleared. Reached in 10 cells.')
  expect((await drawnRows(page)).join('')).not.toContain('#')
  await page.keyboard.press('Control+z')
  await expectResult(page, /^Proven unreachable/)
})

test('a cleared path comes back with undo or the next change, and goes with redo', async ({
  map,
  page,
}) => {
  const result = await page.getByRole('heading', { level: 2, name: /^Reached in/ }).innerText()
  const rows = await drawnRows(page)
  await chooseFromMapMenu(page, 'Clear path')
  await expectResult(page, 'Path cleared')
  await page.getByRole('button', { name: 'Undo' }).click()
  await expectResult(page, result)
  await expectSaid(page, 'The path is shown again.')
  expect(await drawnRows(page)).toEqual(rows)

  await page.getByRole('button', { name: 'Redo' }).click()
  await expectResult(page, 'Path cleared')
  await map.click([6, 4])
  await expectResult(page, 'Reached in 10 cells')
})

test('an edit is on screen while the pointer is down', async ({ map, page }) => {
  await openMap(page, '.....\nS...G\n.....')
  await map.press([1, 0])
  await map.expectColour([1, 0], themes.dark.obstacle.seen)
  await map.moveTo(2, 1)
  await map.expectColour([2, 1], themes.dark.obstacle.seen)
  await map.release()
  await map.press([1, 0])
  await map.moveTo(2, 1)
  await map.expectColour([2, 1], themes.dark.path)
  await map.release()
})
