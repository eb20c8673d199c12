import type { Page } from '@playwright/test'
import { expectResult, expectSaid } from '../actions'
import { expect, test } from '../fixtures'
import {
  currentLine,
  expectReason,
  expectStep,
  openScenario,
  press,
  reasons,
  scrubber,
  stepNumber,
} from '../steps'

/** The landmarks of a scenario: the step that leads to each, the rover's place and the reason. */
type Landmark = readonly [step: number, position: string, reason: string]

const SPIRAL: readonly Landmark[] = [
  [5, '(6, 2)', hit(1, '(6, 2)', '(6, 3)', 'left')],
  [16, '(6, 4)', backOnMLine(1, '(6, 4)', 4)],
  [18, '(6, 5)', hit(2, '(6, 5)', '(6, 6)', 'left')],
  [61, '(7, 0)', backOnMLine(2, '(7, 0)', 0)],
  [64, '(6, 2)', loopSince(2)],
]

const SLANTING_BUG2: readonly Landmark[] = [
  [7, '(6, 13)', hit(1, '(6, 13)', '(7, 12)', 'left')],
  [19, '(8, 8)', backOnMLine(1, '(8, 8)', 9)],
  [23, '(8, 5)', hit(2, '(8, 5)', '(8, 4)', 'left')],
  [29, '(8, 2)', backOnMLine(2, '(8, 2)', 15)],
  [31, '(8, 1)', 'The end at (8, 1): the goal is reached. The rover is at the goal.'],
]

const SLANTING_TANGENT_BUG: readonly Landmark[] = [
  [8, '(6, 13)', hit(1, '(6, 13)', '(7, 12)', 'right')],
  [26, '(1, 3)', leave(1, '(1, 3)')],
  [34, '(8, 1)', 'The end at (8, 1): the goal is reached. The rover is at the goal.'],
]

function hit(number: number, cell: string, obstacle: string, side: string): string {
  return `${obstacle} is an obstacle: hit point ${number} at ${cell}, follow the boundary with the obstacle on the ${side}.`
}

function leave(number: number, cell: string): string {
  return `Leave point ${number} at ${cell}: a step of the simplest path is free, and the goal no farther than from the obstacle at its side.`
}

function backOnMLine(number: number, cell: string, index: number): string {
  return `Leave point ${number} at ${cell}: the m-line is met again, at its cell ${index}.`
}

function loopSince(steps: number): string {
  return `Loop: the same place and the same state as after ${steps} steps, so the rover goes round for ever.`
}

async function expectLandmark(page: Page, [step, position, reason]: Landmark): Promise<void> {
  await expectStep(page, step)
  await expectReason(page, reason)
  await expectSaid(page, reason)
  await expect(stepNumber(page, 'Position')).toHaveText(position)
}

test('Bug2 is stepped to its loop in the spiral, and it is said where and since when', async ({
  page,
}) => {
  await openScenario(page, 'Fig. 12: The spiral, Bug2')
  await press(page, 'Home')
  await expectStep(page, 0, 65)
  await expectReason(page, 'Before the first step.')

  let step = 0
  for (const landmark of SPIRAL) {
    await press(page, 'ArrowRight', landmark[0] - step)
    await expectLandmark(page, landmark)
    step = landmark[0]
  }
  await expect(currentLine(page)).toHaveText(/^if it was a hit point before/)
  await press(page, 'ArrowRight')
  await expectStep(page, 65, 65)
  const end = 'Hit point (6, 2) again, in the same state as after 2 steps.'
  await expectReason(page, `The end at (6, 2): the rover goes round for ever. ${end}`)
  await expectResult(page, 'Loop: hit point (6, 2) again, in the same state as after 2 steps')
  await expect(stepNumber(page, 'Walked')).toHaveText('57 steps')

  // To the moment at which the same state was there before.
  const before = reasons(page).getByRole('button', { name: /: step \d+/ })
  await before.focus()
  await press(page, 'Enter')
  await expect(scrubber(page)).toBeFocused()
  await expect(stepNumber(page, 'Position')).toHaveText('(6, 2)')
  await expect(stepNumber(page, 'Walked')).toHaveText('2 steps')
  await expect(before).toBeHidden()
  await press(page, 'ArrowRight')
  await expectLandmark(page, SPIRAL[0])
})

for (const { planner, landmarks } of [
  { planner: 'Bug2', landmarks: SLANTING_BUG2 },
  { planner: 'Tangent Bug', landmarks: SLANTING_TANGENT_BUG },
]) {
  test(`${planner} at the slanting wall, from landmark to landmark and back`, async ({ page }) => {
    await openScenario(page, `Fig. 14: A slanting wall, ${planner}`)
    await press(page, 'Home')
    for (const landmark of landmarks) {
      await press(page, 'Shift+ArrowRight')
      await expectLandmark(page, landmark)
    }
    await press(page, 'Shift+ArrowRight')
    await expectStep(page, landmarks[landmarks.length - 1][0])
    for (const landmark of landmarks.slice(0, -1).reverse()) {
      await press(page, 'Shift+ArrowLeft')
      await expectLandmark(page, landmark)
    }
    await press(page, 'Shift+ArrowLeft')
    await expectStep(page, 0)
  })
}

test('the line of the pseudocode and the variables belong to the step', async ({ page }) => {
  await openScenario(page, 'Fig. 14: A slanting wall, Bug2')
  const cell = stepNumber(page, 'Cell of the m-line')
  const cellAtHit = stepNumber(page, 'Cell of the m-line at the hit point')
  await press(page, 'Home')
  await expect(currentLine(page)).toHaveCount(0)
  await expect(cell).toHaveText('–')

  await press(page, 'ArrowRight')
  await expect(currentLine(page)).toHaveText('m-line ← the simplest path from start to goal')
  await press(page, 'Shift+ArrowRight')
  await expect(currentLine(page)).toHaveText(/here is a hit point$/)
  await expect(cell).toHaveText('4')
  await expect(cellAtHit).toHaveText('4')
  await expect(stepNumber(page, 'Boundary')).toHaveText('on the left')

  await press(page, 'ArrowRight')
  await expect(currentLine(page)).toHaveText(/^follow the boundary until the m-line is met/)
  await expect(cell).toHaveText('none')
  await press(page, 'Shift+ArrowRight')
  await expect(currentLine(page)).toHaveText('leave there and follow the m-line again')
  await expect(stepNumber(page, 'Boundary')).toHaveText('not followed')
  await press(page, 'ArrowRight')
  await expect(currentLine(page)).toHaveText('follow the m-line towards the goal')
  await press(page, 'ArrowLeft', 2)
  await expect(currentLine(page)).toHaveText(/^follow the boundary until the m-line is met/)
  await press(page, 'End')
  await expect(currentLine(page)).toHaveText('as soon as the goal is met: done')
})
