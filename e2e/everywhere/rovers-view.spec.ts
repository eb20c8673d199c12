import type { Page } from '@playwright/test'
import { themes } from '../../src/render/theme'
import { choosePlanner, openMap } from '../actions'
import { expect, test } from '../fixtures'
import { expectStep, playback, press } from '../steps'

const FAR_OBSTACLE = [0, 5] as const
const NEAR_OBSTACLE = [5, 3] as const
const FAR = [6, 5] as const
const NEAR = [2, 2] as const

const choose = (page: Page, view: string) =>
  playback(page).getByLabel("Rover's view").selectOption({ label: view })

test("the world, what the rover knows, or both, as chosen under Rover's view", async ({
  colorScheme,
  map,
  page,
}) => {
  const { cell, obstacle } = colorScheme === 'light' ? themes.light : themes.dark
  await choosePlanner(page, 'Tangent Bug')
  await openMap(
    page,
    `
      ...........
      .S.......G.
      ...........
      .....#.....
      ...........
      #..........
    `,
  )
  await press(page, 'Home')
  await expectStep(page, 0)
  await expect(playback(page).getByLabel("Rover's view")).toHaveValue('both')
  await map.expectColour(FAR_OBSTACLE, obstacle.unsensed)
  await map.expectColour(NEAR_OBSTACLE, obstacle.unsensed)
  await map.expectColour(NEAR, cell.unsensed)

  await choose(page, 'What the rover knows')
  await map.expectColour(FAR_OBSTACLE, cell.unsensed)
  await map.expectColour(NEAR_OBSTACLE, cell.unsensed)
  await choose(page, 'World')
  await map.expectColour(FAR_OBSTACLE, obstacle.seen)
  await map.expectColour(NEAR_OBSTACLE, obstacle.seen)
  await map.expectColour(FAR, cell.free)
  await map.expectColour(NEAR, cell.free)

  // The obstacle beside its path is sensed, the other one never.
  await press(page, 'End')
  await map.expectColour(FAR_OBSTACLE, obstacle.seen)
  await choose(page, 'What the rover knows')
  await map.expectColour(FAR_OBSTACLE, cell.unsensed)
  await map.expectColour(FAR, cell.unsensed)
  await map.expectColour([1, 3], cell.sensed)
  await map.expectColour(NEAR_OBSTACLE, obstacle.seen)
  await choose(page, 'Both')
  await map.expectColour(FAR_OBSTACLE, obstacle.unsensed)
  await map.expectColour(NEAR_OBSTACLE, obstacle.seen)
})

test('planners that see the whole map have no view of a rover', async ({ page }) => {
  await choosePlanner(page, 'Bug1')
  await expect(playback(page).getByLabel("Rover's view")).toBeVisible()
  await choosePlanner(page, 'Grid decomposition')
  await expect(playback(page).getByLabel("Rover's view")).toBeHidden()
})
