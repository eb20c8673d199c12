import { readFile } from 'node:fs/promises'
import { type Download, expect, type JSHandle, type Locator, type Page } from '@playwright/test'
import { chooseFromMapMenu, expectSettled } from './actions'

export const playback = (page: Page): Locator => page.getByRole('region', { name: 'Playback' })

export const scrubber = (page: Page): Locator =>
  page.getByRole('slider', { name: 'Step on screen' })

/** The card that says why. */
export const reasons = (page: Page): Locator => page.getByRole('region', { name: 'Why this step' })

/** Presses a key so often. */
export async function press(page: Page, key: string, times = 1): Promise<void> {
  for (let i = 0; i < times; i++) await page.keyboard.press(key)
}

/** Opens a scenario of the menu with the keyboard alone. */
export async function openScenario(page: Page, title: string): Promise<void> {
  await page.getByRole('button', { name: 'Map', exact: true }).focus()
  await press(page, 'Enter')
  await expect(page.getByRole('menuitem', { name: 'New…' })).toBeFocused()
  await press(page, 'ArrowDown')
  await expect(page.getByRole('menuitem', { name: 'Scenarios…' })).toBeFocused()
  await press(page, 'Enter')
  const dialog = page.getByRole('dialog', { name: 'Scenarios' })
  const scenario = dialog.getByRole('button', { name: title })
  await expect(dialog).toBeVisible()
  while (!(await scenario.evaluate((button) => button.matches(':focus')))) await press(page, 'Tab')
  await press(page, 'Enter')
  await expect(dialog).toBeHidden()
  await expectSettled(page)
}

/** Waits until this many steps have been taken; `of` how many. */
export async function expectStep(page: Page, step: number, of?: number): Promise<void> {
  const inThousands = (count: number) => count.toLocaleString('en')
  const all = of === undefined ? '[\\d,]+' : inThousands(of)
  const words = new RegExp(`^Step ${inThousands(step)} of ${all}$`)
  await expect(playback(page).getByText(words)).toBeVisible()
}

export async function stepsInAll(page: Page): Promise<number> {
  await drawn(page)
  return Number(await scrubber(page).getAttribute('max'))
}

/** Waits until the step on screen has this reason, in the open card or the head of a folded one. */
export async function expectReason(page: Page, words: string | RegExp): Promise<void> {
  await expect(
    reasons(page).getByText(words, { exact: true }).filter({ visible: true }),
  ).toHaveCount(1)
}

/** A number of the step on screen, as "Walked" or a variable of the planner. */
export function stepNumber(page: Page, label: string): Locator {
  const header = page.getByRole('rowheader', { name: label, exact: true })
  return page
    .getByRole('table', { name: 'Numbers of this step' })
    .getByRole('row')
    .filter({ has: header })
    .getByRole('cell')
}

/** The line of the pseudocode that the step belongs to. */
export const currentLine = (page: Page): Locator =>
  page.getByRole('list', { name: 'Pseudocode' }).locator('[aria-current=step]')

/** What is known of the cell that is pointed at. */
export const cellFacts = (page: Page): Locator =>
  playback(page).getByText(/^(\(\d+, \d+\), |Point at a cell)/)

/** Everything that is said from now on, in its order; of what was done before nothing. */
export async function listen(page: Page): Promise<() => Promise<string[]>> {
  await drawn(page)
  const heard = await page.getByRole('status').evaluateHandle((region) => {
    const texts: string[] = []
    // The same words again differ by a space at their end.
    const hear = () => texts.push((region.textContent ?? '').trim())
    new MutationObserver(hear).observe(region, {
      childList: true,
      characterData: true,
      subtree: true,
    })
    return texts
  })
  return () => heard.jsonValue()
}

/** Waits until what the last key did is on screen: in the first frame after it. */
export async function drawn(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve))
    await frame()
    await frame()
  })
}

/** All that is drawn of the map, kept in the page to be compared with. */
export async function picture(page: Page): Promise<JSHandle<Uint8ClampedArray>> {
  await drawn(page)
  return page.getByRole('application').evaluateHandle((map) => {
    const [left, top, scale, columns, rows] = ['left', 'top', 'scale', 'width', 'height'].map(
      (name) => Math.round(Number(map.dataset[name])),
    )
    const canvas = new OffscreenCanvas(columns * scale, rows * scale)
    const context = canvas.getContext('2d', { willReadFrequently: true })
    if (!context) throw new Error('The browser gives no context to draw in.')
    for (const layer of map.querySelectorAll('canvas')) context.drawImage(layer, -left, -top)
    return context.getImageData(0, 0, canvas.width, canvas.height).data
  })
}

/**
 * How many values of two pictures differ. The browser itself smooths the same edge now and then by
 * one or two of 255 differently; that does not count.
 */
export async function differences(
  one: JSHandle<Uint8ClampedArray>,
  other: JSHandle<Uint8ClampedArray>,
): Promise<number> {
  return one.evaluate((values, others) => {
    let count = Math.abs(values.length - others.length)
    values.forEach((value, i) => {
      if (Math.abs(value - others[i]) > 4) count++
    })
    return count
  }, other)
}

export interface SavedFile {
  readonly name: string
  readonly content: Buffer
}

/** Saves by an entry of the map menu; returns as many files as that makes. */
export async function save(page: Page, entry: string, files = 1): Promise<SavedFile[]> {
  const downloads: Download[] = []
  const note = (download: Download) => downloads.push(download)
  page.on('download', note)
  await chooseFromMapMenu(page, entry)
  await expect.poll(() => downloads.length).toBe(files)
  page.off('download', note)
  return Promise.all(
    downloads.map(async (download) => ({
      name: download.suggestedFilename(),
      content: await readFile(await download.path()),
    })),
  )
}
