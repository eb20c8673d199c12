import { project } from '../../tests/grid/formats/sound-file'
import { choosePlanner, dropFile, expectResult, openFile, openMap, saveMap } from '../actions'
import { expect, test } from '../fixtures'

const ROWS = `
  ..........
  .S...#..G.
  .....#....
`

const BAD_FILES: readonly (readonly [what: string, text: string, why: RegExp])[] = [
  ['empty', '', /The file is empty\./],
  [
    'broken',
    '{\n  "format": "path-planner",\n  "version" 1\n}',
    /broken in line 3, column 13: expected ":", but found "1/,
  ],
  ['truncated', project().slice(0, -20), /broken in line 1, column \d+: expected .*, but it ends/],
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

test.beforeEach(async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await openMap(page, ROWS)
})

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
  for (const name of ['one', 'two']) {
    await openFile(page, `${name}.txt`, 'no map')
    await expect(page.getByText(`${name}.txt was not opened`)).toBeVisible()
  }
  const closers = page.getByRole('button', { name: 'Close this message' })
  const speed = page.getByLabel('Speed')
  await speed.focus()
  for (let left = await closers.count(); left > 0; left--) {
    await closers.first().focus()
    await page.keyboard.press('Enter')
    await expect(closers).toHaveCount(left - 1)
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
