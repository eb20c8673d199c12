import type { Page } from '@playwright/test'
import { themes } from '../../src/render/theme'
import { choosePlanner, expectSettled } from '../actions'
import { expect, test } from '../fixtures'
import type { MapOnScreen } from '../map-on-screen'
import {
  differences,
  drawn,
  expectReason,
  openScenario,
  picture,
  press,
  reasons,
  stepNumber,
} from '../steps'

const theme = themes.dark

/** Steps on until the reason is of this kind; returns it. */
async function stepUntil(page: Page, words: RegExp): Promise<string> {
  const sentence = reasons(page).getByText(words)
  for (let i = 0; i < 120; i++) {
    await press(page, 'ArrowRight')
    await drawn(page)
    if (await sentence.filter({ visible: true }).count()) return sentence.first().innerText()
  }
  throw new Error(`No step is explained by ${words}.`)
}

/** The cells that a sentence names. */
const cellsIn = (sentence: string) =>
  Array.from(sentence.matchAll(/\((\d+), (\d+)\)/g), ([, x, y]) => [Number(x), Number(y)] as const)

/** Whether a colour is anywhere in a cell on screen. */
async function expectColourIn(map: MapOnScreen, cell: readonly [number, number], colour: string) {
  await expect.poll(() => map.coloursIn(...cell), `colours in (${cell})`).toContain(colour)
}

test('Grid decomposition: the graph row by row, the search, the path', async ({ map, page }) => {
  await openScenario(page, 'Fig. 5: Around two obstacles')
  await choosePlanner(page, 'Grid decomposition')
  await expectSettled(page)
  const phase = stepNumber(page, 'Phase')
  await press(page, 'Home')
  await expect(phase).toHaveText('–')
  await press(page, 'Shift+ArrowRight')
  await expect(phase).not.toHaveText('–')
  const first = await phase.innerText()
  await press(page, 'ArrowRight')
  await expectReason(page, 'Row 0: 21 free cells of the graph.')
  await press(page, 'ArrowRight', 2)
  await expectReason(page, 'Row 2: 14 free cells of the graph.')
  await expect(stepNumber(page, 'Rows of the graph')).toHaveText('3')
  await expect(phase).toHaveText(first)
  await expect(stepNumber(page, 'Cost')).toHaveText('–')

  await press(page, 'Shift+ArrowRight')
  await expect(stepNumber(page, 'Rows of the graph')).toHaveText('8')
  await press(page, 'ArrowRight')
  await expectReason(page, 'Start at (0, 3) with cost 0.')
  await expect(stepNumber(page, 'Open')).toHaveText('1')
  const step = await stepUntil(page, /comes first, with cost [1-9].* It gives .* a shorter way\.$/)
  const [closed, ...opened] = cellsIn(step)
  await map.expectColour(closed, theme.cell.closed)
  expect(opened.length).toBeGreaterThan(0)
  for (const cell of opened) await map.expectColour(cell, theme.cell.open)
  expect(await phase.innerText()).not.toBe(first)

  await press(page, 'Shift+ArrowRight')
  await press(page, 'ArrowRight')
  await expectReason(page, 'The parents lead back from the goal: a path of 21 cells.')
})

test('Visibility graph: corners as they are tested, paths as they are tried', async ({
  map,
  page,
}) => {
  await openScenario(page, 'Fig. 5: Around two obstacles')
  await press(page, 'Home')
  await press(page, 'Shift+ArrowRight')
  await expectReason(page, 'Find the vertices.')
  await press(page, 'ArrowRight', 3)
  await expectReason(
    page,
    '(4, 0), diagonal to obstacle (3, 1): not all three cells are free, so it is no corner of this obstacle.',
  )
  // The three cells: two are free, the third is an obstacle.
  await expectColourIn(map, [4, 0], theme.passed)
  await expectColourIn(map, [3, 0], theme.passed)
  await expectColourIn(map, [4, 1], theme.failed)
  await press(page, 'ArrowRight', 3)
  await expectReason(
    page,
    '(2, 0), diagonal to obstacle (3, 1): it is free and so are both cells between them, so it is a vertex.',
  )
  for (const tested of [
    [2, 0],
    [3, 0],
    [2, 1],
  ] as const) {
    await expectColourIn(map, tested, theme.passed)
  }
  await press(page, 'ArrowRight')
  await expectReason(page, '(2, 0) is a vertex of the roadmap.')
  await expectColourIn(map, [2, 0], theme.vertex)

  await press(page, 'Shift+ArrowRight')
  await expectReason(page, 'Try simplest paths.')
  await expect(stepNumber(page, 'Vertices')).toHaveText('10')
  await expect(stepNumber(page, 'Edges')).toHaveText('0')
  const free = await stepUntil(page, /^The simplest path from .* is free: an edge of cost \d+\.$/)
  const [from, to] = cellsIn(free)
  expect(Math.max(Math.abs(from[0] - to[0]), Math.abs(from[1] - to[1]))).toBe(
    Number(/cost (\d+)/.exec(free)?.[1]),
  )
  const refused = await stepUntil(page, /are refused, the one from/)
  const at = cellsIn(refused)[3]
  await expectColourIn(map, at, theme.failed)
  const before = await picture(page)
  await press(page, 'ArrowRight')
  expect(await differences(await picture(page), before)).toBeGreaterThan(0)

  await press(page, 'Shift+ArrowRight')
  await expectReason(page, 'Search.')
  await press(page, 'ArrowRight')
  await expectReason(page, 'Start at (0, 3) with cost 0.')
  await press(page, 'Shift+ArrowRight')
  await expectReason(page, 'Path.')
})

test('Potential field: both fields, their sum, the walk', async ({ page }) => {
  await openScenario(page, 'Fig. 6: Caught in a hollow')
  const phase = stepNumber(page, 'Phase')
  const pictures = []
  await press(page, 'Home')
  for (const [name, row] of [
    ['Attraction', 'Row 0: the attraction is the square of the distance to the goal.'],
    ['Repulsion', 'Row 0: the closest obstacle repels where it is within influence.'],
    ['Sum of both', 'Row 0: attraction and repulsion added up.'],
  ] as const) {
    await press(page, 'Shift+ArrowRight')
    await expect(phase).toHaveText(name)
    await press(page, 'ArrowRight')
    await expectReason(page, row)
    await press(page, 'ArrowRight', 6)
    await expectReason(page, row.replace('Row 0', 'Row 6'))
    const now = await picture(page)
    for (const before of pictures) expect(await differences(now, before)).toBeGreaterThan(1000)
    pictures.push(now)
  }
  await press(page, 'Shift+ArrowRight')
  await expect(phase).toHaveText('Walk')
  await press(page, 'ArrowRight', 2)
  await expect(stepNumber(page, 'Position')).toHaveText(/^\(\d+, \d+\)$/)
  await press(page, 'End')
  await expectReason(
    page,
    'The end at (6, 3): a local minimum. No legal neighbour of (6, 3) has a lower potential.',
  )
})
