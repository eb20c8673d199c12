import type { Page } from '@playwright/test'
import { chooseFromMapMenu, choosePlanner, createMap, expectSettled } from '../actions'
import { expect, test } from '../fixtures'
import { expectStep, press, scrubber, stepsInAll } from '../steps'

/** Nearly every cell is closed, and each of them is a step. */
async function planWithMillionSteps(page: Page): Promise<number> {
  await choosePlanner(page, 'Grid decomposition')
  await createMap(page, 1100, 1100)
  await expectSettled(page)
  await expect.poll(() => stepsInAll(page)).toBeGreaterThan(1e6)
  return stepsInAll(page)
}

interface Answer {
  /** Animation frames from the key to the change on screen, and milliseconds. */
  readonly frames: number
  readonly time: number
}

/** Presses a key and watches how long it takes until the step on screen is another. */
async function answerTo(page: Page, key: string): Promise<Answer> {
  const measured = await scrubber(page).evaluateHandle((slider) => ({
    answer: new Promise<Answer>((resolve) => {
      const begin = () => {
        const before = slider.getAttribute('aria-valuetext')
        const began = performance.now()
        let frames = 0
        const look = () => {
          frames++
          const time = performance.now() - began
          if (slider.getAttribute('aria-valuetext') !== before) resolve({ frames, time })
          else requestAnimationFrame(look)
        }
        requestAnimationFrame(look)
      }
      window.addEventListener('keydown', begin, { capture: true, once: true })
    }),
  }))
  await press(page, key)
  return measured.evaluate(({ answer }) => answer)
}

test('a step on a tape of a million events is on screen at once, backwards too', async ({
  page,
}) => {
  const steps = await planWithMillionSteps(page)
  const keys = { forwards: 'ArrowRight', backwards: 'ArrowLeft' }
  await scrubber(page).focus()
  for (const place of [steps, 700_003, 350_001, 5]) {
    await scrubber(page).fill(String(place))
    await expectStep(page, place)
    for (const [direction, key] of Object.entries(keys)) {
      const answers: Answer[] = []
      const times = 6
      for (let i = 0; i < times; i++) {
        // At the end there is no step forwards, so it is begun with a step back.
        if (place === steps) {
          await press(page, key === 'ArrowRight' ? 'ArrowLeft' : 'End')
          await expectStep(page, key === 'ArrowRight' ? steps - 1 : steps)
        }
        answers.push(await answerTo(page, key))
      }
      const what = `${direction} at step ${place}: ${JSON.stringify(answers)}`
      expect(Math.max(...answers.map(({ frames }) => frames)), what).toBeLessThanOrEqual(3)
      expect(Math.min(...answers.map(({ time }) => time)), what).toBeLessThan(100)
    }
  }
})

test('landmarks and both ends of a tape of a million events are found', async ({ page }) => {
  const steps = await planWithMillionSteps(page)
  await press(page, 'Home')
  await expectStep(page, 0, steps)
  await press(page, 'Shift+ArrowRight', 2)
  await press(page, 'ArrowLeft')
  await press(page, 'ArrowRight')
  await expectStep(page, 1102, steps)
  await press(page, 'End')
  await expectStep(page, steps, steps)
  await press(page, 'Shift+ArrowLeft', 2)
  await expectStep(page, 1102, steps)
})

test('a long trace is written while the page goes on, and can be cancelled', async ({ page }) => {
  await choosePlanner(page, 'Grid decomposition')
  await createMap(page, 700, 700)
  await expectSettled(page)
  let downloads = 0
  page.on('download', () => downloads++)
  // Slow enough for a person, whatever the machine.
  const client = await page.context().newCDPSession(page)
  await client.send('Emulation.setCPUThrottlingRate', { rate: 8 })
  await chooseFromMapMenu(page, 'Save trace for Posthoc (+ .map)')
  const bar = page.getByRole('progressbar', { name: 'Saving…' })
  await expect(bar).toHaveAttribute('aria-valuenow', /./)
  await press(page, 'Home')
  await expectStep(page, 0)
  await expect(bar).toBeVisible()
  await scrubber(page).focus()
  await page.getByRole('button', { name: 'Cancel' }).press('Enter')
  await expect(page.getByText('Cancelled.')).toBeVisible()
  await expect(bar).toBeHidden()
  await expect(scrubber(page)).toBeFocused()
  expect(downloads).toBe(0)
})
