import type { Page } from '@playwright/test'
import { chooseFromMapMenu, expectSaid, openMap } from '../actions'
import { expect, test } from '../fixtures'
import {
  expectReason,
  expectStep,
  listen,
  openScenario,
  playback,
  press,
  scrubber,
  stepsInAll,
} from '../steps'

const BENT = 'Fig. 9: Along a bent obstacle'
const TWO = 'Fig. 11: Two obstacles, Bug2'
const HIT =
  '(2, 2) is an obstacle: hit point 1 at (1, 3), follow the boundary with the obstacle on the left.'
const END = 'The end at (2, 0): the goal is reached. The rover is at the goal.'

const choose = (page: Page, speed: string) =>
  page.getByLabel('Speed').selectOption({ label: speed })

const stepOnScreen = async (page: Page) => Number(await scrubber(page).inputValue())

async function expectPlaying(page: Page, isPlaying: boolean): Promise<void> {
  await expect(page.getByRole('application')).toHaveAttribute('data-playing', String(isPlaying))
  const name = isPlaying ? 'Pause' : 'Play'
  await expect(playback(page).getByRole('button', { name, exact: true })).toBeVisible()
}

test('Space and K play and pause, and it goes on where it stopped', async ({ page }) => {
  await openScenario(page, TWO)
  await choose(page, '1 step/s')
  await scrubber(page).focus()
  for (const key of ['Space', 'k']) {
    await press(page, 'Home')
    await press(page, 'ArrowRight', 3)
    await expectStep(page, 3)
    await press(page, key)
    await expectPlaying(page, true)
    await expect.poll(() => stepOnScreen(page)).toBeGreaterThan(3)
    await press(page, key)
    await expectPlaying(page, false)
    const stopped = await stepOnScreen(page)
    await press(page, key)
    await expectPlaying(page, true)
    await expect.poll(() => stepOnScreen(page)).toBeGreaterThan(stopped)
    await press(page, key)
    await expectPlaying(page, false)
    expect(await stepOnScreen(page)).toBeLessThan(await stepsInAll(page))
  }
})

test('at the end it plays from the beginning, to the end and no further', async ({ page }) => {
  await openScenario(page, TWO)
  const steps = await stepsInAll(page)
  await expectStep(page, steps)
  await choose(page, '30 steps/s')
  const play = playback(page).getByRole('button', { name: 'Play', exact: true })
  const least = scrubber(page).evaluate(
    (slider) =>
      new Promise<number>((resolve) => {
        let lowest = Number.POSITIVE_INFINITY
        const look = () => {
          const step = Number(slider.getAttribute('aria-valuetext')?.split(' ')[1])
          if (step > lowest) resolve(lowest)
          lowest = Math.min(lowest, step)
          requestAnimationFrame(look)
        }
        look()
      }),
  )
  await play.click()
  expect(await least).toBe(1)
  await expectPlaying(page, false)
  await expectStep(page, steps)
})

test('the buttons do what the keys do', async ({ page }) => {
  await openScenario(page, BENT)
  const click = (name: string) => playback(page).getByRole('button', { name, exact: true }).click()
  await click('To the beginning')
  await expectStep(page, 0, 9)
  await click('Step forward')
  await expectStep(page, 1)
  await click('Next landmark')
  await expectStep(page, 2)
  await expectReason(page, HIT)
  await click('To the end')
  await expectStep(page, 9)
  await expectReason(page, END)
  await click('Step back')
  await expectStep(page, 8)
  await click('Landmark before')
  await expectStep(page, 2)
  await press(page, 'End')
  await expectStep(page, 9)
  await press(page, 'Home')
  await expectStep(page, 0)
})

test('the scrubber goes to any step, by mouse and by keys, and says where it is', async ({
  page,
}) => {
  await openScenario(page, BENT)
  const slider = scrubber(page)
  await slider.fill('2')
  await expectStep(page, 2)
  await expect(slider).toHaveAttribute('aria-valuetext', `step 2 of 9: ${HIT}`)
  await slider.focus()
  await press(page, 'ArrowRight', 2)
  await expectStep(page, 4)
  await press(page, 'PageDown')
  await expectStep(page, 9)
  await press(page, 'PageUp')
  await expectStep(page, 2)

  const box = await slider.boundingBox()
  if (!box) throw new Error('The scrubber is not on screen.')
  const [y, middle] = [box.y + box.height / 2, box.x + box.width / 2]
  await page.mouse.move(middle, y)
  await page.mouse.down()
  await expect.poll(() => stepOnScreen(page)).toBeGreaterThan(2)
  await page.mouse.move(box.x + box.width + 30, y, { steps: 4 })
  await expectStep(page, 9)
  await page.mouse.move(box.x - 30, y, { steps: 4 })
  await expectStep(page, 0)
  await page.mouse.up()
})

test('keys that come faster than frames are all counted on the scrubber', async ({ page }) => {
  await openScenario(page, BENT)
  await scrubber(page).focus()
  for (let i = 0; i < 10; i++) {
    await press(page, 'End')
    await expectStep(page, 9)
    const keys = ['Home', 'ArrowRight', 'ArrowRight', 'PageDown', 'ArrowLeft']
    await Promise.all(keys.map((key) => press(page, key)))
    await expectStep(page, 8)
  }
})

test('played slowly, each landmark is said, and nothing else', async ({ page }) => {
  await openScenario(page, BENT)
  await choose(page, '5 steps/s')
  await expectSaid(page, 'Speed: 5 steps/s.')
  await scrubber(page).focus()
  const heard = await listen(page)
  await press(page, 'Space')
  await expectSaid(page, END)
  expect(await heard()).toEqual(['Playing.', HIT, END])
})

for (const speed of ['100 steps/s', 'Whole in a moment']) {
  test(`played fast (${speed}), only the end is said`, async ({ page }) => {
    await openScenario(page, TWO)
    await choose(page, speed)
    await expectSaid(page, `Speed: ${speed}.`)
    await scrubber(page).focus()
    const heard = await listen(page)
    await press(page, 'Space')
    await expectSaid(page, /^The end at \(4, 0\)/)
    expect(await heard()).toEqual([
      'Playing.',
      'The end at (4, 0): the goal is reached. The rover is at the goal.',
    ])
  })
}

test('the scrubber says landmarks to those who listen, its own words say the rest', async ({
  page,
}) => {
  await openScenario(page, BENT)
  const heard = await listen(page)
  // A landmark that is passed within one frame is not said: each step is to be on screen.
  for (const step of [1, 2, 3, 4]) {
    await scrubber(page).fill(String(step))
    await expectStep(page, step)
  }
  await press(page, 'ArrowRight')
  await expectStep(page, 5)
  await expect.poll(heard).toContain(HIT)
  for (const words of await heard()) expect(words).toBe(HIT)
})

test('the speed is there again after a reload', async ({ page }) => {
  await choose(page, '30 steps/s')
  await expectSaid(page, 'Speed: 30 steps/s.')
  await page.reload()
  await expect(page.getByLabel('Speed')).toHaveValue('30')
})

test('without a plan on screen there is nothing to step through', async ({ page }) => {
  await openMap(page, 'S..G\n....')
  const landmarks = playback(page).locator('#ticks > *')
  await expect(landmarks).not.toHaveCount(0)
  const play = playback(page).getByRole('button', { name: 'Play' })
  const colour = await play.evaluate((button) => getComputedStyle(button).backgroundColor)
  await chooseFromMapMenu(page, 'Clear path')
  await expect(playback(page).getByText('No steps')).toBeVisible()
  await expect(landmarks).toHaveCount(0)
  await expect(scrubber(page)).toBeDisabled()
  await expect(play).toHaveAttribute('aria-disabled', 'true')
  await expect(play).not.toHaveCSS('background-color', colour)
  await press(page, '.')
  await expectSaid(page, 'There is no plan to step through.')
  await press(page, 'k')
  await expectSaid(page, 'There is no plan to play.')
})
