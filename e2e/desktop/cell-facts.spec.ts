import { expectSaid } from '../actions'
import { expect, test } from '../fixtures'
import { cellFacts, openScenario, press } from '../steps'

test('pointing at a cell tells what a rover knows of it at this moment', async ({ map, page }) => {
  await openScenario(page, 'Fig. 14: A slanting wall, Bug2')
  const facts = cellFacts(page)
  await map.moveTo(8, 8)
  await expect(facts).toHaveText(
    /^\(8, 8\), free\. Leave point 1; cell \d+ of the m-line; stood on after 15 steps; sensed after 13 steps of the rover\.$/,
  )
  await map.moveTo(6, 13)
  await expect(facts).toHaveText(/^\(6, 13\), free\. Hit point 1; cell 4 of the m-line; stood on/)
  await map.moveTo(7, 12)
  await expect(facts).toHaveText(
    /^\(7, 12\), obstacle\. Cell 5 of the m-line; at its side while it followed the boundary/,
  )
  await map.moveTo(0, 0)
  await expect(facts).toHaveText('(0, 0), free. The planner knows nothing of it yet.')

  // The mouse stays where it is, time goes back to where nothing is known there.
  await map.moveTo(8, 8)
  await page.keyboard.press('Home')
  await expect(facts).toHaveText('(8, 8), free. The planner knows nothing of it yet.')
  await press(page, 'ArrowRight', 2)
  await expect(facts).toHaveText('(8, 8), free. Cell 9 of the m-line.')
  await map.moveTo(2, 17)
  await expect(facts).toHaveText(/^\(2, 17\), start\. /)
  await map.moveTo(-2, 3)
  await expect(facts).toHaveText('Point at a cell to see what the planner knows of it.')
})

test('the cursor of the keyboard tells the same and it is said', async ({ map, page }) => {
  await openScenario(page, 'Fig. 14: A slanting wall, Bug2')
  await map.element.focus()
  await press(page, 'ArrowUp')
  const words = '(2, 16), free. Sensed from the start.'
  await expect(cellFacts(page)).toHaveText(words)
  await expectSaid(page, words)
  await press(page, 'Escape')
  await expect(cellFacts(page)).toHaveText(/^Point at a cell/)
})

test('costs and parents of a search, vertices and edges of a roadmap', async ({ map, page }) => {
  await openScenario(page, 'Fig. 5: Around two obstacles')
  const facts = cellFacts(page)
  await map.moveTo(2, 0)
  await expect(facts).toHaveText(
    /^\(2, 0\), free\. Vertex with \d+ edges; closed, cost \d+ by way of \(\d+, \d+\)\.$/,
  )
  await map.moveTo(20, 3)
  await expect(facts).toHaveText(
    /^\(20, 3\), goal\. Cell 20 of the path; vertex with \d+ edges?; closed, cost 20 by way of \(\d+, \d+\)\.$/,
  )
  await map.moveTo(0, 0)
  await expect(facts).toHaveText('(0, 0), free. The planner knows nothing of it yet.')
  await page.getByRole('combobox', { name: 'Planner', exact: true }).selectOption('decomposition')
  await expect(facts).toHaveText(/^\(0, 0\), free\. Vertex; closed, cost \d+ by way of/)
})

test('the parts of a potential and their sum', async ({ map, page }) => {
  await openScenario(page, 'Fig. 6: Caught in a hollow')
  await map.moveTo(7, 3)
  await expect(cellFacts(page)).toHaveText(/Attraction 49; repulsion \d+(\.\d+)?; potential \d+/)
  await page.keyboard.press('Home')
  await press(page, 'Shift+ArrowRight', 2)
  await expect(cellFacts(page)).toHaveText('(7, 3), free. Attraction 49.')
})
