import { expectSettled, plannerSelect } from '../actions'
import { expect, test } from '../fixtures'
import { expectReason, expectStep, openScenario, press, stepNumber, stepsInAll } from '../steps'

test.beforeEach(async ({ page }) => {
  await openScenario(page, 'Fig. 14: A slanting wall, Bug2')
})

test('an edit that changes nothing for the rover leaves the step as it is', async ({
  map,
  page,
}) => {
  await press(page, 'Home')
  await press(page, 'ArrowRight', 11)
  await expectStep(page, 11, 31)
  await map.click([0, 15])
  await expectSettled(page)
  await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute('aria-disabled', 'false')
  await expectStep(page, 11, 31)
  await press(page, 'Control+z')
  await expectSettled(page)
  await expectStep(page, 11, 31)
})

test('another way there: it stays after the same landmark, and comes back with undo', async ({
  map,
  page,
}) => {
  await press(page, 'Home')
  await press(page, 'Shift+ArrowRight', 2)
  await press(page, 'ArrowRight')
  await expectStep(page, 20, 31)
  const before = await stepNumber(page, 'Position').innerText()

  // The start three rows further away: the rover has three steps more to go.
  await map.drag([
    [2, 17],
    [0, 17],
    [0, 14],
  ])
  await expectSettled(page)
  await press(page, 'ArrowLeft')
  await expectReason(
    page,
    /^Leave point 1 at \(\d+, \d+\): the m-line is met again, at its cell \d+\.$/,
  )
  await press(page, 'ArrowRight')
  await press(page, 'Control+z')
  await expectSettled(page)
  await expectStep(page, 20, 31)
  await expect(stepNumber(page, 'Position')).toHaveText(before)
})

test('at the end it stays at the end', async ({ map, page }) => {
  await press(page, 'Shift+ArrowLeft')
  await press(page, 'Shift+ArrowRight')
  await expectStep(page, 31, 31)
  await map.click([8, 6])
  await expectSettled(page)
  const steps = await stepsInAll(page)
  await expectStep(page, steps, steps)
  await expectReason(page, /^The end at \(8, 1\)/)
})

test('another planner is shown to its end', async ({ page }) => {
  await press(page, 'Home')
  await press(page, 'ArrowRight', 3)
  await plannerSelect(page).selectOption('bug1')
  await expectSettled(page)
  const steps = await stepsInAll(page)
  await expectStep(page, steps, steps)
})
