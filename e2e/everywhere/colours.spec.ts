import { themes } from '../../src/render/theme'
import { choosePlanner, expectResult, inPlannerCard, openMap } from '../actions'
import { expect, test } from '../fixtures'

const themeOf = (colorScheme: string | null | undefined) =>
  colorScheme === 'light' ? themes.light : themes.dark

test('free cells, obstacles, start, goal, path, what was searched, and a roadmap', async ({
  colorScheme,
  map,
  page,
}) => {
  const theme = themeOf(colorScheme)
  await choosePlanner(page, 'Grid decomposition')
  await openMap(
    page,
    `
      ....#...
      S..G#...
      ....#...
    `,
  )
  await map.expectColour([4, 1], theme.obstacle.seen)
  await map.expectColour([6, 1], theme.cell.free)
  await map.expectColour([1, 0], theme.cell.closed)
  await map.expectColour([1, 1], theme.path)
  // Beside the sign in the middle of each.
  await map.expectColour([-0.3, 1], theme.start)
  await map.expectColour([3, 0.72], theme.goal)
  await map.expectColour([3, -1], theme.outside)

  await choosePlanner(page, 'Visibility graph')
  await openMap(
    page,
    `
      ..........
      .S......G.
      ..........
      ....#.....
      ..........
    `,
  )
  await map.expectColour([3, 4], theme.vertex)
  await map.expectColour([5, 1], theme.path)
})

test('what the rover senses and feels', async ({ colorScheme, map, page }) => {
  const theme = themeOf(colorScheme)
  await choosePlanner(page, 'Bug1')
  await openMap(
    page,
    `
      ...........
      .S...#...G.
      ...........
      ...........
      #..........
    `,
  )
  await expectResult(page, /^Reached/)
  await map.expectColour([2, 0], theme.cell.sensed)
  await map.expectColour([2, 4], theme.cell.unsensed)
  await map.expectColour([0, 4], theme.obstacle.unsensed)
  await map.expectColour([5.3, 1.3], theme.obstacle.felt)
  await map.expectColour([5, 1], theme.feltMark)
  await map.expectColour([3, 1], theme.path)
  await map.expectColour([3.78, 0.74], theme.hit)

  // One that senses further sees obstacles before it feels them.
  await choosePlanner(page, 'Tangent Bug')
  await openMap(
    page,
    `
      ..........
      .S......G.
      ..........
      ....#.....
      ..........
      ....#.....
    `,
  )
  await expectResult(page, 'Reached in 8 cells')
  await map.expectColour([4, 3], theme.obstacle.seen)
  await map.expectColour([4, 5], theme.obstacle.unsensed)
  await map.expectColour([3, 3], theme.cell.sensed)
  await map.expectColour([3, 4], theme.cell.unsensed)
})

test('potentials as heat, and as numbers where cells are large, behind a switch', async ({
  colorScheme,
  map,
  page,
}) => {
  const theme = themeOf(colorScheme)
  await choosePlanner(page, 'Potential field')
  await openMap(
    page,
    `
      .....
      S...G
      .....
    `,
  )
  const [lowest, highest] = [theme.heat[0], String(theme.heat.at(-1))]
  await map.expectColour([4.42, 1.42], lowest)
  await map.expectColour([0.42, 2.42], highest)
  expect((await map.coloursIn(1, 0)).size).toBeGreaterThan(1)
  for (let i = 0; i < 4; i++) await page.getByRole('button', { name: 'Zoom out' }).click()
  await expect.poll(async () => (await map.coloursIn(1, 0)).size).toBe(1)
  await page.getByRole('button', { name: 'Show the whole map' }).click()

  await inPlannerCard(page, async () => {
    const potentials = page.getByRole('switch', { name: 'Show potentials' })
    await expect(potentials).toBeChecked()
    await potentials.press('Space')
  })
  await map.expectColour([0.42, 2.42], theme.cell.free)
  await expect.poll(async () => (await map.coloursIn(1, 0)).size).toBe(1)
})
