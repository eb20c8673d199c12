import { choosePlanner, expectResult, openMap } from '../actions'
import { expect, test } from '../fixtures'
import { expectStep, scrubber, stepsInAll } from '../steps'

const ROWS = `
  ..........
  .S......G.
  ..........
`

test.describe('where motion is welcome', () => {
  test.use({ contextOptions: { reducedMotion: 'no-preference' } })

  test('newcomers see a plan being made, until they take over', async ({ map }) => {
    await expect(map.element).toHaveAttribute('data-playing', 'true')
    await expect(map.element).toHaveAttribute('data-status', 'reached')
    await map.click([-1, 3])
    await expect(map.element).toHaveAttribute('data-playing', 'false')
  })

  test('a stroke shows the end of the plan, on the scrubber too', async ({ map, page }) => {
    await expect(map.element).toHaveAttribute('data-playing', 'true')
    await map.press([0, 0])
    const end = await stepsInAll(page)
    await expect(scrubber(page)).toHaveValue(String(end))
    await expectStep(page, end, end)
    await map.release()
  })

  test('a plan that arrives is played once', async ({ map, page }) => {
    await openMap(page, ROWS)
    await expect(map.element).toHaveAttribute('data-playing', 'false')
    await choosePlanner(page, 'Bug1')
    await expect(map.element).toHaveAttribute('data-playing', 'true')
    await expectResult(page, 'Reached in 8 cells')
    await expect(map.element).toHaveAttribute('data-playing', 'false')
  })

  test('while the pointer is down the path is there at once', async ({ map, page }) => {
    await openMap(page, ROWS)
    await expect(map.element).toHaveAttribute('data-playing', 'false')
    await map.element.evaluate((element) => {
      const played = () => {
        if (element.dataset.playing === 'true') element.dataset.wasPlayed = 'true'
      }
      new MutationObserver(played).observe(element, { attributeFilter: ['data-playing'] })
    })
    await map.press([8, 1])
    await map.moveTo(6, 2)
    await map.moveTo(5, 1)
    await expectResult(page, 'Reached in 5 cells')
    await map.release()
    await expect(map.element).toHaveAttribute('data-status', 'reached')
    await expect(map.element).not.toHaveAttribute('data-was-played')

    // The counter-check: this would have been noticed.
    await page.getByLabel('Diagonal steps').selectOption('only-when-no-obstacles')
    await expect(map.element).toHaveAttribute('data-was-played', 'true')
  })
})

test('under reduced motion nothing is played', async ({ map, page }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  await expect(map.element).toHaveAttribute('data-playing', 'false')
  await choosePlanner(page, 'Bug1')
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  await expect(map.element).toHaveAttribute('data-playing', 'false')
})
