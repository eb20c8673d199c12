import type { Locator } from '@playwright/test'
import { chooseFromMapMenu, choosePlanner, paramControl } from '../actions'
import { expect, test } from '../fixtures'
import { coloursOf } from '../pixel'
import { currentLine, scrubber } from '../steps'

test.use({ contextOptions: { forcedColors: 'active', reducedMotion: 'reduce' } })

const pixelsOf = async (element: Locator) =>
  coloursOf(await element.screenshot({ animations: 'disabled' }))

const borderOf = (element: Locator, side: string) =>
  element.evaluate((box, name) => getComputedStyle(box).getPropertyValue(name), side)

/** The focus is there before, so that it is no part of what changes. */
async function expectTold(control: Locator, shown: Locator) {
  await control.focus()
  const before = await pixelsOf(shown)
  await control.press('Space')
  await expect.poll(() => pixelsOf(shown)).not.toEqual(before)
}

test('what is on, chosen or here is told from the rest where the system chooses the colours', async ({
  page,
}) => {
  expect(new Set(await pixelsOf(scrubber(page))).size, 'colours of the scrubber').toBeGreaterThan(2)

  const signs = page.locator('#hint').getByText('Drag to draw obstacles.').locator('span')
  for (const sign of await signs.all()) {
    expect(await borderOf(sign, 'background-color')).not.toBe(
      await borderOf(page.locator('#hint'), 'background-color'),
    )
  }

  const line = currentLine(page)
  const others = page.getByRole('list', { name: 'Pseudocode' }).locator('li:not([aria-current])')
  expect(await borderOf(line, 'border-left-color')).not.toBe(
    await borderOf(others.first(), 'border-left-color'),
  )

  const compare = page.getByRole('button', { name: 'Compare planners' })
  expect(await borderOf(compare, 'outline-style')).toBe('none')
  await compare.click()
  expect(await borderOf(compare, 'outline-style')).toBe('solid')
  const box = page.getByRole('region', { name: 'Comparison of planners' }).getByLabel('Bug1')
  await expectTold(box, box)

  await choosePlanner(page, 'Tangent Bug')
  const lineOfSight = paramControl(page, 'Line of sight')
  await expectTold(lineOfSight, lineOfSight.locator('xpath=following-sibling::span'))

  await chooseFromMapMenu(page, 'New…')
  const keep = page.getByRole('radio', { name: /^Keep the drawing/ })
  await expectTold(keep, keep.locator('xpath=following-sibling::span'))
})
