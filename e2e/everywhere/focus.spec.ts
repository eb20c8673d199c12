import type { Page } from '@playwright/test'
import { expect, test } from '../fixtures'

const LEAST_WIDTH = 2
/** What WCAG asks of parts that one has to see. */
const LEAST_CONTRAST = 3

/**
 * How well what has the focus is told apart: its name, whether it was scrolled into sight, the width
 * of its ring and how it stands out.
 */
async function ringOfFocused(page: Page) {
  return page.evaluate(() => {
    const pixel = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })
    const luminance = (colour: string) => {
      if (!pixel) throw new Error('There is no canvas.')
      pixel.fillStyle = colour
      pixel.fillRect(0, 0, 1, 1)
      const [red, green, blue] = Array.from(pixel.getImageData(0, 0, 1, 1).data, (value) =>
        value <= 10 ? value / 3294.6 : ((value / 255 + 0.055) / 1.055) ** 2.4,
      )
      return 0.2126 * red + 0.7152 * green + 0.0722 * blue
    }
    const focused = document.activeElement
    if (!focused || focused === document.body) return null
    // The box itself lies under the switch that is drawn for it.
    const drawn = (focused.matches('.switch input') && focused.nextElementSibling) || focused
    const { top, bottom } = drawn.getBoundingClientRect()
    const body = focused.closest('.body')?.getBoundingClientRect()
    const surface = getComputedStyle(document.body).getPropertyValue('--md-sys-color-surface')
    const { outlineColor, outlineStyle, outlineWidth, opacity } = getComputedStyle(drawn)
    const [darker, lighter] = [luminance(outlineColor), luminance(surface)].sort((a, b) => a - b)
    return {
      name: focused.id || focused.getAttribute('aria-label') || String(focused.textContent),
      isInSight: !body || (top > body.top - 1 && bottom < body.bottom + 1),
      width: outlineStyle === 'solid' && opacity === '1' ? Number.parseFloat(outlineWidth) : 0,
      contrast: (lighter + 0.05) / (darker + 0.05),
    }
  })
}

/** Goes through all that the keyboard reaches; tells of what does not show that it has the focus. */
async function unseen(page: Page): Promise<{ stops: number; faint: string[] }> {
  const faint: string[] = []
  await page.keyboard.press('Tab')
  let stops = 0
  for (let ring = await ringOfFocused(page); ring; ring = await ringOfFocused(page)) {
    stops++
    const { name, isInSight, width, contrast } = ring
    if (!isInSight) faint.push(`${name}: out of sight`)
    if (width < LEAST_WIDTH || contrast < LEAST_CONTRAST) {
      faint.push(`${name}: ${width} px, ${contrast.toFixed(1)} to 1`)
    }
    await page.keyboard.press('Tab')
  }
  return { stops, faint }
}

test('all that the keyboard reaches on the map shows that it has the focus', async ({ page }) => {
  await page.getByRole('button', { name: 'Compare planners' }).press('Enter')
  const planner = page.getByRole('button', { name: 'Fold the planner card' })
  await planner.focus()
  if ((await planner.getAttribute('aria-expanded')) === 'false') await planner.press('Enter')
  await page.getByRole('application').focus()
  const { stops, faint } = await unseen(page)
  expect(stops).toBeGreaterThan(25)
  expect(faint).toEqual([])
})

test('all that the keyboard reaches in the settings of experiments shows it, too', async ({
  page,
}) => {
  await page.goto('experiments.html')
  for (const entry of await page.locator('#form summary').all()) await entry.press('Enter')
  await page.locator('#open').focus()
  const { stops, faint } = await unseen(page)
  expect(stops).toBeGreaterThan(40)
  expect(faint).toEqual([])
})
