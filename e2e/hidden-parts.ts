import type { Page } from '@playwright/test'
import { expect } from './fixtures'
import type { MapOnScreen } from './map-on-screen'

/** What of the map lies under which card or bar; empty if all of it can be seen. */
export async function hiddenParts(page: Page, map: MapOnScreen): Promise<string[]> {
  const { left, top, scale, width, height } = await map.view()
  const [right, bottom] = [left + width * scale, top + height * scale]
  const covers = await page.getByRole('main').evaluate((main) =>
    Array.from(main.querySelectorAll('section, #hint'), (cover) => {
      const { left, top, right, bottom } = cover.getBoundingClientRect()
      const name = cover.getAttribute('aria-label') ?? cover.id
      return { name, left, top, right, bottom, isThere: right > left && bottom > top }
    }),
  )
  expect(covers.filter(({ isThere }) => isThere).length).toBeGreaterThanOrEqual(5)
  const hidden = covers.flatMap((cover) => {
    const across = Math.min(right, cover.right) - Math.max(left, cover.left)
    const down = Math.min(bottom, cover.bottom) - Math.max(top, cover.top)
    const isOver = cover.isThere && across > 0.5 && down > 0.5
    return isOver ? [`${Math.round(across)} × ${Math.round(down)} under "${cover.name}"`] : []
  })
  const screen = await page.evaluate(() => ({ width: innerWidth, height: innerHeight }))
  const isInside = left >= 0 && top >= 0 && right <= screen.width && bottom <= screen.height
  return isInside ? hidden : [...hidden, 'beside the screen']
}
