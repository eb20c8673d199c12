import { readFile } from 'node:fs/promises'
import { expect, type Page } from '@playwright/test'
import { countWork, type ExperimentSettings } from '../src/experiments/settings'

/** Few and small maps, but enough for every chart. */
export const SMALL: ExperimentSettings = {
  format: 'path-planner-experiment',
  version: 1,
  seed: 3,
  diagonal: 'if-at-most-one-obstacle',
  families: [
    { family: 'random', params: { density: [10, 25, 35] } },
    { family: 'maps', params: {}, maps: [{ name: 'corner', rows: ['....', '.##.', '..#.'] }] },
  ],
  sizes: [
    [12, 12],
    [24, 24],
  ],
  mapsPerCombination: 6,
  leastDistance: 2,
  planners: [
    { planner: 'decomposition', params: {} },
    { planner: 'probabilistic-roadmap', params: { samples: [5, 20] } },
    { planner: 'potential-field', params: { influence: [0, 1], repulsiveValue: [3, 30] } },
    { planner: 'bug2', params: { leave: ['report', 'closer'] } },
  ],
}

/** The page of the experiments, as a person has it. */
export class ExperimentsPage {
  readonly page: Page

  constructor(page: Page) {
    this.page = page
  }

  async open(): Promise<void> {
    await this.page.goto('experiments.html')
    await expect(this.page.getByRole('heading', { name: 'Experiments' })).toBeVisible()
  }

  /** Opens a file of settings or results, or of maps. */
  async openFile(name: string, text: string, input = '#file'): Promise<void> {
    const file = { name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) }
    await this.page.locator(input).setInputFiles(file)
  }

  /** Runs the settings to the end, and waits until the charts are drawn. */
  async run(settings: ExperimentSettings): Promise<void> {
    await this.openFile('settings.json', JSON.stringify(settings))
    // Not the note that says so: it goes by itself, on a slow machine before it is looked for.
    const runs = countWork(settings).runs.toLocaleString('en')
    await expect(this.page.getByText(` = ${runs} runs`)).toBeVisible()
    await this.page.getByRole('button', { name: 'Run', exact: true }).click()
    await this.chartsDrawn()
  }

  async chartsDrawn(): Promise<void> {
    await expect(this.page.locator('[data-mark]').first()).toBeVisible({ timeout: 20_000 })
  }

  /** What a press on a button downloads. */
  async downloaded(button: string): Promise<string> {
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.getByRole('button', { name: button }).click(),
    ])
    return readFile(await download.path(), 'utf8')
  }
}
