import { themes } from '../../src/render/theme'
import { expect, test } from '../fixtures'
import { expectStep, stepsInAll } from '../steps'

const OUTSIDE = [-1, 3] as const

test('the theme is the system’s, until another is chosen', async ({ map, page }) => {
  const button = page.getByRole('button', { name: /^Theme: / })
  await map.expectColour(OUTSIDE, themes.dark.outside)
  await page.emulateMedia({ colorScheme: 'light' })
  await map.expectColour(OUTSIDE, themes.light.outside)

  await expect(button).toHaveAccessibleName('Theme: system. Change to dark')
  await button.click()
  await map.expectColour(OUTSIDE, themes.dark.outside)
  await page.reload()
  await expect(button).toHaveAccessibleName('Theme: dark. Change to light')
  await map.expectColour(OUTSIDE, themes.dark.outside)

  await page.emulateMedia({ colorScheme: 'dark' })
  await button.click()
  await expect(button).toHaveAccessibleName('Theme: light. Change to system')
  await map.expectColour(OUTSIDE, themes.light.outside)
  await button.click()
  await map.expectColour(OUTSIDE, themes.dark.outside)
})

test('a page that Back leads to has the theme that was chosen on the other one', async ({
  map,
  page,
}) => {
  // As browsers do that keep a page as it was, unlike the one that runs the tests.
  const leaveAndReturn = (theme: string) =>
    page.evaluate((chosen) => {
      const preferences = { theme: chosen, showPotential: true, hint: true }
      localStorage.setItem('path-planner.preferences', JSON.stringify(preferences))
      window.dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))
    }, theme)
  await leaveAndReturn('light')
  await map.expectColour(OUTSIDE, themes.light.outside)
  await page.goto('experiments.html')
  const button = page.getByRole('button', { name: /^Theme: / })
  await expect(button).toHaveAccessibleName('Theme: light. Change to system')
  await leaveAndReturn('dark')
  await expect(button).toHaveAccessibleName('Theme: dark. Change to light')
})

test('the line for newcomers goes when it is closed, and stays away', async ({ page }) => {
  const hint = page.getByText('Drag to draw obstacles.')
  await expect(hint).toBeVisible()
  await page.getByRole('button', { name: 'Close this hint' }).click()
  await expect(hint).toBeHidden()
  // The focus is at the map, but no cursor takes the arrows from the playback.
  await expect(page.getByRole('application')).toBeFocused()
  const last = await stepsInAll(page)
  await page.keyboard.press('ArrowLeft')
  await expectStep(page, last - 1, last)
  await page.reload()
  await expect(page.getByRole('application')).toHaveAttribute('data-status', 'reached')
  await expect(hint).toBeHidden()
})
