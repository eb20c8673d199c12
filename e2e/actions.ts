import { readFile } from 'node:fs/promises'
import { expect, type Locator, type Page } from '@playwright/test'
import type { ParamValue } from '../src/index'

/** Picks an entry of the map menu, as "New…" or "Save". */
export async function chooseFromMapMenu(page: Page, entry: string): Promise<void> {
  await page.getByRole('button', { name: 'Map', exact: true }).click()
  await page.getByRole('menuitem', { name: entry, exact: true }).click()
}

/** Makes an empty map of this size by the menu's dialog. */
export async function createMap(page: Page, width: number, height: number): Promise<void> {
  await chooseFromMapMenu(page, 'New…')
  const dialog = page.getByRole('dialog', { name: 'New map' })
  await dialog.getByLabel('Width').fill(String(width))
  await dialog.getByLabel('Height').fill(String(height))
  await dialog.getByRole('button', { name: 'Create' }).click()
  await expect(page.getByRole('application')).toHaveAttribute('data-width', String(width))
}

/** Opens a file by the page's own file dialog. */
export async function openFile(page: Page, name: string, text: string): Promise<void> {
  const asked = page.waitForEvent('filechooser')
  await chooseFromMapMenu(page, 'Open…')
  const chooser = await asked
  const ending = name.slice(name.lastIndexOf('.'))
  const offered = (await chooser.element().getAttribute('accept'))?.split(',')
  expect(offered, 'endings of files that can be chosen').toContain(ending)
  await chooser.setFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
}

/** Opens a text map; afterwards it is on screen, solved by whatever planner is chosen. */
export async function openMap(page: Page, rows: string): Promise<void> {
  await openFile(page, 'map.txt', rows)
  await expect(page.getByText(/^Opened map\.txt/).first()).toBeVisible()
  await expectSettled(page)
}

/** Saves the map; returns the name and the text of the file. */
export async function saveMap(page: Page): Promise<{ name: string; text: string }> {
  const downloading = page.waitForEvent('download')
  await chooseFromMapMenu(page, 'Save')
  const download = await downloading
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), 'utf8') }
}

/** The rows of the map as a saved file has them: `#` obstacle, `.` free. */
export async function drawnRows(page: Page): Promise<string[]> {
  const { rows } = JSON.parse((await saveMap(page)).text)
  return rows
}

/** Lets go of a file over the map, and of others with it. */
export async function dropFile(
  page: Page,
  name: string,
  text: string,
  others: string[] = [],
): Promise<void> {
  const dataTransfer = await page.evaluateHandle(
    ([names, content]) => {
      const transfer = new DataTransfer()
      for (const fileName of names) transfer.items.add(new File([content], fileName))
      return transfer
    },
    [[name, ...others], text] as const,
  )
  const map = page.getByRole('application')
  await map.dispatchEvent('dragover', { dataTransfer })
  await expect(page.getByText('Drop the file to open it')).toBeVisible()
  await map.dispatchEvent('drop', { dataTransfer })
  await expect(page.getByText('Drop the file to open it')).toBeHidden()
}

/**
 * Lets go of `first.txt`, and of `last.txt` while that is read; returns what lets it be read to its end.
 */
export async function dropBoth(page: Page, first: string, last: string) {
  const slow = await page.evaluateHandle(
    ([firstText, lastText]) => {
      let read: (text: string) => void = () => {}
      const first = new File([], 'first.txt')
      first.text = () => new Promise((resolve) => (read = resolve))
      for (const file of [first, new File([lastText], 'last.txt')]) {
        const drop = new DragEvent('drop', { bubbles: true })
        // A transfer of the browser's own would hand over a copy of the file.
        Object.defineProperty(drop, 'dataTransfer', { value: { types: ['Files'], files: [file] } })
        document.body.dispatchEvent(drop)
      }
      return { readFirst: () => read(firstText) }
    },
    [first, last] as const,
  )
  return () =>
    slow.evaluate(async ({ readFirst }) => {
      readFirst()
      await new Promise((resolve) => requestAnimationFrame(resolve))
    })
}

export const plannerSelect = (page: Page): Locator =>
  page.getByRole('combobox', { name: 'Planner', exact: true })

const foldButton = (page: Page, card: string) =>
  page.getByRole('button', { name: `Fold the ${card} card` })

/** Opens a card if it is folded, as cards are on a phone; returns whether it was. */
export async function unfold(page: Page, card: string): Promise<boolean> {
  const button = foldButton(page, card)
  const wasFolded = (await button.getAttribute('aria-expanded')) === 'false'
  if (wasFolded) await button.click()
  return wasFolded
}

/** Does something in the planner card; if it was folded, it is so again afterwards. */
export async function inPlannerCard(page: Page, action: () => Promise<unknown>): Promise<void> {
  const wasFolded = await unfold(page, 'planner')
  await action()
  if (wasFolded) await foldButton(page, 'planner').click()
}

export async function choosePlanner(page: Page, title: string): Promise<void> {
  await inPlannerCard(page, async () => {
    await plannerSelect(page).selectOption({ label: title })
    // Before the next frame the parameters are still those of the other planner.
    await expect(page.locator('#planner-title')).toHaveText(title)
  })
}

/** The control of a parameter, found by its label, whatever unit stands behind that. */
export function paramControl(page: Page, label: string): Locator {
  return page.getByRole('region', { name: 'Planner' }).getByLabel(label)
}

export async function setParam(page: Page, label: string, value: ParamValue): Promise<void> {
  const control = paramControl(page, label)
  if (typeof value === 'number') return control.fill(String(value))
  if (typeof value === 'string') {
    await control.selectOption(value)
    return
  }
  // The box itself lies under the switch that is drawn for it.
  if ((await control.isChecked()) !== value) await control.press('Space')
  await expect(control).toBeChecked({ checked: value })
}

/** Waits until the plan on screen is that of what is on screen. */
export async function expectSettled(page: Page): Promise<void> {
  const settled = /^(reached|unreachable|not-found|local-minimum|dead-end|loop)$/
  await expect(page.getByRole('application')).toHaveAttribute('data-status', settled)
}

/** Waits until the result card says this as its headline. */
export async function expectResult(page: Page, words: string | RegExp): Promise<void> {
  await expect(page.getByRole('heading', { level: 2, name: words, exact: true })).toBeVisible()
}

/** A number of the result card, as "Turns" or "Expanded". */
export const resultNumber = (page: Page, label: string): Locator =>
  page
    .getByRole('table', { name: 'Numbers of this plan' })
    .getByRole('row', { name: label })
    .getByRole('cell')

/** Waits until these words were said to those who listen. */
export async function expectSaid(page: Page, words: string | RegExp): Promise<void> {
  await expect(page.getByRole('status')).toHaveText(words)
}

/** Presses Tab until the focus is on what is looked for. */
export async function tabTo(
  page: Page,
  role: 'button' | 'combobox',
  name: string,
): Promise<Locator> {
  const target = page.getByRole(role, { name, exact: true })
  const isFocused = () => target.evaluate((element) => element === document.activeElement)
  for (let i = 0; i < 40; i++) {
    if (await isFocused()) return target
    await page.keyboard.press('Tab')
  }
  throw new Error(`Tab does not lead to the ${role} "${name}".`)
}
