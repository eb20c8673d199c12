import {
  chooseFromMapMenu,
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

const project = (some: object) =>
  JSON.stringify({
    format: 'path-planner',
    version: 1,
    diagonal: 'if-at-most-one-obstacle',
    start: [0, 0],
    goal: [2, 1],
    rows: ['...', '...'],
    ...some,
  })

const BAD_FILES: readonly (readonly [what: string, text: string, why: RegExp])[] = [
  ['empty', '', /The file is empty\./],
  [
    'broken',
    '{\n  "format": "path-planner",\n  "version" 1\n}',
    /broken in line 3, column 13: expected ":", but found "1/,
  ],
  [
    'truncated',
    project({}).slice(0, -20),
    /broken in line 1, column \d+: expected .*, but it ends/,
  ],
  [
    'foreign',
    '<svg xmlns="http://www.w3.org/2000/svg"/>',
    /This file is no map\. It begins with "<svg/,
  ],
  ['foreign JSON', '{"name": "x"}', /it has neither "format": "path-planner" nor a "wall_map"/],
  ['later', project({ version: 2 }), /is of version 2; this program reads version 1/],
  ['uneven', project({ rows: ['...', '..'] }), /Row 2 has 2 cells, but row 1 has 3/],
  ['strange', project({ rows: ['...', '.x.'] }), /"x" at \(1, 1\) is no cell/],
  ['endless', project({ goal: [3, 1] }), /The goal \(3, 1\) is not on the 3 × 2 map/],
  ['full', project({ rows: ['###', '###'] }), /The start \(0, 0\) is an obstacle/],
  [
    'too large',
    project({ rows: ['.'.repeat(2049), '.'.repeat(2049)] }),
    /The map's width is 2049: it must be a whole number from 2 to 2048/,
  ],
  [
    'hostile',
    '{"size": {"x": 1e9, "y": 1e9}, "wall_map": []}',
    /The map's width is 1000000000: it must be a whole number from 2 to 2048/,
  ],
  ['deep', '['.repeat(100).replace('[', '{"wall_map":[') + '['.repeat(1e5), /at most 100 levels/],
  [
    'without a free cell',
    '{"size": {"x": 2, "y": 2}, "wall_map": [[1, 1], [1, 1]]}',
    /no.* free cell|no cell .*free/,
  ],
]

test('a bad file is told what is wrong and where, and the map stays', async ({ page }) => {
  const before = await saveMap(page)
  for (const [what, text, why] of BAD_FILES) {
    const name = `${what}.json`
    await dropFile(page, name, text)
    const alert = page.getByRole('alert').filter({ hasText: `${name} was not opened.` })
    await expect(alert).toHaveText(why)
    await alert.getByRole('button', { name: 'Close this message' }).click()
    await expect(alert).toBeHidden()
  }
  await expectResult(page, 'Reached in 8 cells')
  expect(await saveMap(page)).toEqual(before)
  await page.keyboard.press('Control+z')
  await expect(page.getByRole('application')).not.toHaveAttribute('data-width', '10')
})

test('a file of more bytes than any map is not read', async ({ map, page }) => {
  await map.element.evaluate((element) => {
    const transfer = new DataTransfer()
    transfer.items.add(new File([new Uint8Array(65 * 2 ** 20)], 'film.mp4'))
    element.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true }))
  })
  await expect(page.getByRole('alert')).toContainText(
    'film.mp4 was not opened. It has 65 MB, more than the 64 MB of any map.',
  )
})

test('an error is over once a map was opened', async ({ page }) => {
  await dropFile(page, 'bad.json', '{')
  await expect(page.getByRole('alert')).toBeVisible()
  await openMap(page, ROWS)
  await expect(page.getByRole('alert')).toBeHidden()
})

test('messages that are closed with the keyboard give the focus back', async ({ page }) => {
  await openFile(page, 'one.txt', 'no map')
  await openFile(page, 'two.txt', 'no map')
  const closers = page.getByRole('button', { name: 'Close this message' })
  await expect(page.getByText(/^two\.txt was not opened/)).toBeVisible()
  const speed = page.getByLabel('Speed')
  await speed.focus()
  while ((await closers.count()) > 0) {
    await closers.first().focus()
    await page.keyboard.press('Enter')
    await expect(page.locator('body')).not.toBeFocused()
  }
  await expect(speed).toBeFocused()
})

test('a message is text, whatever the file holds', async ({ page }) => {
  await dropFile(page, '<b>x</b>.json', '<img src=x onerror=alert(1)>')
  const alert = page.getByRole('alert')
  await expect(alert).toContainText('<b>x</b>.json was not opened.')
  await expect(alert.locator('img, b')).toHaveCount(0)
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
