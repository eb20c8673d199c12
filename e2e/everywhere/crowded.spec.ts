import type { Page } from '@playwright/test'
import { expectAccessible } from '../accessibility'
import { choosePlanner, openMap } from '../actions'
import { expect, test } from '../fixtures'
import { playback, press } from '../steps'

const SIDE = 301
const WORDS = 'Too many vertices or edges to show: zoom in.'

/** An obstacle at every other cell of every other row: all cells diagonal to one are vertices. */
function manyCorners(): string {
  const cell = (x: number, y: number) => {
    if (y === 1 && x === 1) return 'S'
    if (y === SIDE - 2 && x === SIDE - 2) return 'G'
    return x % 2 === 0 && y % 2 === 0 ? '#' : '.'
  }
  const row = (_: unknown, y: number) => Array.from({ length: SIDE }, (_, x) => cell(x, y)).join('')
  return Array.from({ length: SIDE }, row).join('\n')
}

const note = (page: Page) => playback(page).getByText(WORDS)

/** What is read aloud of the note from now on. */
async function listen(page: Page): Promise<() => Promise<string[]>> {
  const heard = await page.locator('#crowded').evaluateHandle((live) => {
    const texts: string[] = []
    new MutationObserver(() => {
      if (live.ariaLive === 'polite' && live.textContent) texts.push(live.textContent)
    }).observe(live, { childList: true })
    return texts
  })
  return () => heard.jsonValue()
}

/** What stands at the corners and in the middle of the note; nothing else should. */
async function shownInstead(page: Page): Promise<string[]> {
  return note(page).evaluate((shown) => {
    const { left, right, top, bottom } = shown.getBoundingClientRect()
    const places = [
      [left + 4, top + 4],
      [right - 4, top + 4],
      [(left + right) / 2, (top + bottom) / 2],
      [left + 4, bottom - 4],
      [right - 4, bottom - 4],
    ]
    return places
      .map(([x, y]) => document.elementFromPoint(x, y))
      .filter((top) => top !== shown)
      .map((top) => top?.outerHTML.slice(0, 80) ?? 'nothing: it is beside the screen')
  })
}

/** The controls over which the note lies. */
async function coveredControls(page: Page): Promise<string[]> {
  return note(page).evaluate((shown) => {
    const note = shown.getBoundingClientRect()
    return Array.from(document.querySelectorAll('button, select, input'))
      .filter((control) => {
        const { left, right, top, bottom, width } = control.getBoundingClientRect()
        const isBeside =
          right <= note.left || left >= note.right || bottom <= note.top || top >= note.bottom
        return width > 0 && !isBeside
      })
      .map(({ id, className }) => id || className)
  })
}

test('what is left out of a crowded roadmap is said on the screen, and read aloud once', async ({
  map,
  page,
}) => {
  await choosePlanner(page, 'Visibility graph')
  await expect(note(page)).toBeHidden()
  const heard = await listen(page)
  await openMap(page, manyCorners())
  for (const times of [1, 2]) {
    await expect(map.element, `time ${times}`).toHaveAttribute('data-crowded', 'true')
    await expect(note(page)).toBeVisible()
    expect(await shownInstead(page)).toEqual([])
    expect(await coveredControls(page)).toEqual([])
    await map.element.focus()
    await press(page, '+', 6)
    await expect(map.element).toHaveAttribute('data-crowded', 'false')
    await expect(note(page)).toBeHidden()
    await press(page, '0')
  }
  await expect(note(page)).toBeVisible()
  await expectAccessible(page)
  expect(await heard()).toEqual([WORDS])
})

test('a crowded roadmap is read aloud again on a map of another size', async ({ page }) => {
  await choosePlanner(page, 'Visibility graph')
  const heard = await listen(page)
  await openMap(page, manyCorners())
  await expect(note(page)).toBeVisible()
  await choosePlanner(page, 'Bug2')
  await expect(note(page)).toBeHidden()
  await choosePlanner(page, 'Visibility graph')
  await expect(note(page)).toBeVisible()
  expect(await heard()).toEqual([WORDS])
  await openMap(page, `${manyCorners()}\n${'.'.repeat(SIDE)}`)
  await expect.poll(heard).toEqual([WORDS, WORDS])
})
