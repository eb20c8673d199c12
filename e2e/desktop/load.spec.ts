import { expect, type Page, test } from '@playwright/test'
import { type Fetched, fetchedBy } from '../../bench/load/fetched.mjs'
import { chooseFromMapMenu, openFile } from '../actions'
import { ExperimentsPage, SMALL } from '../experiments'

/** Of all that comes before the first map is solved, or the form can be filled in; with gzip. */
const MOST_BYTES = 150_000

const scripts = (files: readonly Fetched[]) =>
  files.filter(({ type }) => type === 'script').map(({ path }) => path)

function expectWithinBudget(files: readonly Fetched[]): void {
  const list = files.map(({ path, gzip }) => `${path}: ${gzip}`).join('\n')
  expect(scripts(files).length, list).toBeGreaterThan(0)
  const total = files.reduce((sum, { gzip }) => sum + gzip, 0)
  expect(total, list).toBeLessThanOrEqual(MOST_BYTES)
  expect(files.filter(({ type }) => type === 'font').length, list).toBeLessThanOrEqual(1)
  const pictures = files.filter(({ content }) => content.startsWith('image/'))
  for (const { path, content } of pictures) expect(content, path).toMatch(/^image\/svg\+xml/)
}

/** Each named icon is drawn as SVG, and nothing else is a picture. */
async function expectIconsInSvg(page: Page): Promise<void> {
  const icons = page.locator('[data-icon]')
  expect(await icons.count()).toBeGreaterThan(0)
  await expect(page.locator('svg[data-icon]:has(path)')).toHaveCount(await icons.count())
  await expect(page.locator('img, picture')).toHaveCount(0)
}

/** The scripts that a page asks for from now on. */
function scriptsOf(page: Page): readonly string[] {
  const asked: string[] = []
  page.on('request', (request) => {
    if (request.resourceType() === 'script') asked.push(request.url())
  })
  return asked
}

async function openPlayground(page: Page): Promise<void> {
  await page.goto('')
  await expect(page.locator('#map')).toHaveAttribute('data-status', 'reached')
  await page.waitForLoadState('networkidle')
}

const fromMenu = (entry: string) => (page: Page) => chooseFromMapMenu(page, entry)

const DIALOGS = [
  { title: 'New map', open: fromMenu('New…') },
  { title: 'Scenarios', open: fromMenu('Scenarios…') },
  { title: 'Generate a map', open: fromMenu('Generate…') },
  { title: 'Help and keys', open: (page: Page) => page.locator('#help').click() },
  { title: 'Tangent Bug', open: (page: Page) => page.locator('#planner-about').click() },
]

test('the first load of the playground is within its budget', async ({ page }) => {
  const fetched = fetchedBy(page)
  await openPlayground(page)
  const files = await fetched()
  expect(scripts(files).join(), 'the worker counts').toContain('plan-worker')
  expectWithinBudget(files)
  await expectIconsInSvg(page)
})

for (const { title, open } of DIALOGS) {
  test(`the dialog "${title}" is loaded when it is opened`, async ({ page }) => {
    await openPlayground(page)
    const dialog = page.getByRole('dialog', { name: title })
    await expect(page.locator('dialog')).toHaveCount(0)
    const asked = scriptsOf(page)
    await open(page)
    await expect(dialog).toBeVisible()
    expect(asked).not.toEqual([])
    await page.keyboard.press('Escape')
    await expect(dialog).toBeHidden()
    await open(page)
    await expect(dialog).toBeVisible()
    await expect(page.locator('dialog')).toHaveCount(1)
  })
}

test('that a dialog cannot be loaded is said, and the next try may do better', async ({ page }) => {
  await openPlayground(page)
  const dialog = page.getByRole('dialog', { name: 'Help and keys' })
  await page.route('**/*.js', (route) => route.abort())
  await page.locator('#help').click()
  await expect(page.getByText('This part of the page could not be loaded.')).toBeVisible()
  await expect(dialog).toBeHidden()
  await page.unroute('**/*.js')
  await page.locator('#help').click()
  await expect(dialog).toBeVisible()
})

test('so is that a file cannot be opened or saved', async ({ page }) => {
  await openPlayground(page)
  const words = 'This part of the page could not be loaded. Try again'
  const tries = async () => {
    await openFile(page, 'map.txt', 'S.\n.G')
    for (const entry of ['Save', 'Save for MovingAI (.map)', 'Save picture (PNG)']) {
      await chooseFromMapMenu(page, entry)
    }
  }
  await page.route('**/*.js', (route) => route.abort())
  await tries()
  await expect(page.getByText(`map.txt was not opened. ${words}`)).toBeVisible()
  await expect(page.getByText(`Nothing was saved. ${words}`)).toBeVisible()
  await page.unroute('**/*.js')
  const downloads: string[] = []
  page.on('download', (download) => downloads.push(download.suggestedFilename()))
  await tries()
  await expect(page.getByText('Opened map.txt: 2 × 2 cells.').first()).toBeVisible()
  await expect.poll(() => downloads.length).toBe(3)
})

test('the page of experiments is within the budget, and loads charts with results', async ({
  page,
}) => {
  const fetched = fetchedBy(page)
  const experiments = new ExperimentsPage(page)
  await experiments.open()
  await page.waitForLoadState('networkidle')
  const files = await fetched()
  expectWithinBudget(files)
  await expectIconsInSvg(page)
  expect(scripts(files).filter((path) => /chart|worker/.test(path))).toEqual([])
  const asked = scriptsOf(page)
  await experiments.run(SMALL)
  expect(asked.filter((path) => /chart/.test(path))).not.toEqual([])
})
