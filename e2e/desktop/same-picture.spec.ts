import { expect, test } from '../fixtures'
import {
  differences,
  expectStep,
  openScenario,
  picture,
  press,
  reasons,
  scrubber,
  stepsInAll,
} from '../steps'

const CASES = [
  { scenario: 'Fig. 5: Around two obstacles', moments: [104, 148] },
  { scenario: 'Fig. 6: Caught in a hollow', moments: [12, 31] },
  { scenario: 'Fig. 11: Two obstacles, Bug1', moments: [18, 40] },
  { scenario: 'Fig. 14: A slanting wall, Tangent Bug', moments: [8, 21] },
]

for (const { scenario, moments } of CASES) {
  test(`${scenario} looks the same forwards, backwards and by a jump`, async ({ page }) => {
    await openScenario(page, scenario)
    const steps = await stepsInAll(page)
    const see = async () => ({
      picture: await picture(page),
      reasons: await reasons(page).innerText(),
    })
    const seen = new Map([[steps, await see()]])

    const expectAsBefore = async (step: number, how: string) => {
      const before = seen.get(step)
      if (!before) throw new Error(`Step ${step} was not seen before.`)
      const now = await see()
      const what = `step ${step}, ${how}`
      expect(await differences(now.picture, before.picture), what).toBe(0)
      expect(now.reasons, what).toBe(before.reasons)
    }

    await press(page, 'Home')
    let step = 0
    for (const moment of moments) {
      await press(page, 'ArrowRight', moment - step)
      await expectStep(page, moment, steps)
      const now = await see()
      for (const other of seen.values()) {
        expect(await differences(now.picture, other.picture)).toBeGreaterThan(0)
      }
      seen.set(moment, now)
      step = moment
    }

    await press(page, 'End')
    await expectAsBefore(steps, 'by a jump')
    step = steps
    for (const moment of [...moments].reverse()) {
      await press(page, 'ArrowLeft', step - moment)
      await expectStep(page, moment, steps)
      await expectAsBefore(moment, 'backwards')
      step = moment
    }

    for (const moment of [moments[1], moments[0], steps]) {
      await scrubber(page).fill(String(moment))
      await expectStep(page, moment, steps)
      await expectAsBefore(moment, 'by the scrubber')
    }
  })
}
