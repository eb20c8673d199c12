import type { Page } from '@playwright/test'
import { themes } from '../../src/render/theme'
import {
  chooseFromMapMenu,
  choosePlanner,
  createMap,
  drawnRows,
  expectSettled,
  openFile,
  setParam,
} from '../actions'
import { expect, test } from '../fixtures'
import { openScenario, press, type SavedFile, save, stepsInAll } from '../steps'

/** Fig. 14 has 11 × 18 cells of 48 pixels in a PNG and of 32 in an SVG, and a margin around them. */
const PNG = { cell: 48, margin: 12, width: 11 * 48 + 24, height: 18 * 48 + 24 }
const SVG = { width: 11 * 32 + 16, height: 18 * 32 + 16 }

const textOf = ({ content }: SavedFile) => content.toString('utf8')

/** The browser reads the image and says the colour of one of its pixels. */
async function colourInPng(page: Page, png: Buffer, x: number, y: number): Promise<string> {
  const values = await page.evaluate(
    async ([base64, column, row]) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
      const context = new OffscreenCanvas(1, 1).getContext('2d')
      context?.drawImage(image, -column, -row)
      return Array.from(context?.getImageData(0, 0, 1, 1).data ?? [])
    },
    [png.toString('base64'), x, y] as const,
  )
  return `#${Buffer.from(values).toString('hex', 0, 3)}`
}

test.beforeEach(async ({ page }) => {
  await openScenario(page, 'Fig. 14: A slanting wall, Bug2')
})

test('the trace is saved for Posthoc, and the map that it opens upon beside it', async ({
  map,
  page,
}) => {
  const rows = await drawnRows(page)
  const files = await save(page, 'Save trace for Posthoc (+ .map)', 2)
  const names = files.map(({ name }) => name)
  expect(names).toEqual(['path-planner-11x18-bug2.trace.json', 'path-planner-11x18.map'])
  const [trace, mapFile] = files.map(textOf)

  const { version, views, events } = JSON.parse(trace)
  expect(version).toBe('1.4.0')
  expect(Object.keys(views)).toContain('main')
  expect(events[0]).toMatchObject({ type: 'source', x: 2, y: 17, map: names[1] })
  expect(events[1]).toMatchObject({ type: 'destination', x: 8, y: 1 })
  const ids = new Set<number>()
  for (const { type, id, pId } of events) {
    expect(typeof type).toBe('string')
    expect(pId === undefined || pId === null || ids.has(pId), `parent ${pId} of ${id}`).toBe(true)
    ids.add(id)
  }
  const places = (kind: string) =>
    events.flatMap(({ type, x, y }: { type: string; x: number; y: number }) =>
      type === kind ? [[x, y]] : [],
    )
  expect(places('hit')).toEqual([
    [6, 13],
    [8, 5],
  ])
  expect(places('leave')).toEqual([
    [8, 8],
    [8, 2],
  ])
  expect(places('step')).toHaveLength(25)

  expect(mapFile).toMatch(/^type octile\nheight 18\nwidth 11\nmap\n/)
  await openFile(page, names[1], mapFile)
  await expect(page.getByText(/^Opened path-planner-11x18\.map/).first()).toBeVisible()
  await expect(map.element).toHaveAttribute('data-width', '11')
  expect(await drawnRows(page)).toEqual(rows)
})

test('the map alone is saved in the format of MovingAI', async ({ page }) => {
  const [file] = await save(page, 'Save for MovingAI (.map)')
  expect(file.name).toBe('path-planner-11x18.map')
  const [type, height, width, word, ...rows] = textOf(file).trimEnd().split('\n')
  expect([type, height, width, word]).toEqual(['type octile', 'height 18', 'width 11', 'map'])
  expect(rows.map((row) => row.replaceAll('@', '#'))).toEqual(await drawnRows(page))
})

test('the picture as it stands is saved as PNG', async ({ page }) => {
  const shown = async () => {
    const [file] = await save(page, 'Save picture (PNG)')
    expect(file.name).toBe('path-planner-11x18-bug2.png')
    const { content } = file
    expect([content.readUInt32BE(16), content.readUInt32BE(20)]).toEqual([PNG.width, PNG.height])
    return (x: number, y: number) => {
      const [column, row] = [x, y].map((at) => Math.floor(PNG.margin + (at + 0.5) * PNG.cell))
      return colourInPng(page, content, column, row)
    }
  }
  const theme = themes.dark
  const atEnd = await shown()
  expect(await atEnd(8, 1)).not.toBe(theme.cell.unsensed)
  expect(await atEnd(7, 15)).toBe(theme.cell.unsensed)
  expect(await atEnd(4, 15)).toBe(theme.path)
  expect(await atEnd(1, 10)).toBe(theme.obstacle.unsensed)
  await press(page, 'Home')
  const atBeginning = await shown()
  expect(await atBeginning(4, 15)).toBe(theme.cell.unsensed)
  expect(await atBeginning(1, 10)).toBe(theme.obstacle.unsensed)
})

/** Lets each part of the work take a slice of its own, and writes down when the page may go on. */
async function watchRests(page: Page) {
  return page.evaluateHandle(() => {
    const log: string[] = []
    let now = performance.now()
    performance.now = () => {
      now += 10
      return now
    }
    const { postMessage } = MessagePort.prototype
    MessagePort.prototype.postMessage = function (...args: unknown[]) {
      log.push('rest')
      Reflect.apply(postMessage, this, args)
    }
    return log
  })
}

test('both files of a trace are saved where a download has to wait for the one before, as in Safari', async ({
  page,
}) => {
  await page.evaluate(() => {
    const { click } = HTMLAnchorElement.prototype
    let timer: ReturnType<typeof setTimeout> | undefined
    HTMLAnchorElement.prototype.click = function () {
      clearTimeout(timer)
      timer = setTimeout(() => click.call(this), 20)
    }
  })
  await save(page, 'Save trace for Posthoc (+ .map)', 2)
})

for (const { entry, files } of [
  { entry: 'Save', files: 1 },
  { entry: 'Save for MovingAI (.map)', files: 1 },
  { entry: 'Save trace for Posthoc (+ .map)', files: 2 },
  { entry: 'Save picture (SVG)', files: 1 },
]) {
  test(`the page goes on between the parts of a file: ${entry}`, async ({ page }) => {
    const log = await watchRests(page)
    await save(page, entry, files)
    // For each of the map's rows, at least.
    expect((await log.jsonValue()).length).toBeGreaterThanOrEqual(18)
  })
}

test('the page goes on between the parts of making a PNG', async ({ page }) => {
  const log = await watchRests(page)
  await log.evaluate((log, width) => {
    const note = (part: string) => {
      if (!log.includes(part)) log.push(part)
    }
    const { fillRect, drawImage } = CanvasRenderingContext2D.prototype
    CanvasRenderingContext2D.prototype.fillRect = function (...box) {
      if (this.canvas.width === width) note('canvas')
      fillRect.apply(this, box)
    }
    // The page, too, may be painting at that time: on a canvas of another width.
    CanvasRenderingContext2D.prototype.drawImage = function (...args: unknown[]) {
      if (this.canvas.width === width) note('cells')
      Reflect.apply(drawImage, this, args)
    }
    const { toBlob } = HTMLCanvasElement.prototype
    HTMLCanvasElement.prototype.toBlob = function (...args) {
      note('file')
      toBlob.apply(this, args)
    }
  }, PNG.width)
  await save(page, 'Save picture (PNG)')
  const parts = (await log.jsonValue()).filter((part, i, all) => part !== all[i - 1])
  expect(parts).toEqual(['rest', 'canvas', 'rest', 'cells', 'rest', 'file'])
})

test('a picture of noise is not saved where the browser gives out nothing else', async ({
  page,
}) => {
  await page.evaluate(() => {
    const { getImageData } = CanvasRenderingContext2D.prototype
    CanvasRenderingContext2D.prototype.getImageData = function (...box) {
      const image = getImageData.apply(this, box)
      return new ImageData(crypto.getRandomValues(image.data), image.width)
    }
  })
  const downloads: string[] = []
  page.on('download', (download) => downloads.push(download.suggestedFilename()))
  await chooseFromMapMenu(page, 'Save picture (PNG)')
  await expect(
    page.getByText(/^Nothing was saved\. To guard your privacy, this browser/),
  ).toBeVisible()
  await chooseFromMapMenu(page, 'Save picture (SVG)')
  await expect.poll(() => downloads).toEqual(['path-planner-11x18-bug2.svg'])
})

test('the picture as it stands is saved as SVG', async ({ page }) => {
  const shown = async () => {
    const [file] = await save(page, 'Save picture (SVG)')
    expect(file.name).toBe('path-planner-11x18-bug2.svg')
    const text = textOf(file)
    const parsed = await page.evaluate((source) => {
      const document = new DOMParser().parseFromString(source, 'image/svg+xml')
      const { documentElement: root } = document
      return {
        name: root.nodeName,
        size: [root.getAttribute('width'), root.getAttribute('height')].map(Number),
        errors: document.querySelectorAll('parsererror').length,
        shapes: document.querySelectorAll('path, rect, circle').length,
        numbers: Array.from(document.querySelectorAll('text'), (label) => label.textContent),
      }
    }, text)
    expect(parsed).toMatchObject({ name: 'svg', size: [SVG.width, SVG.height], errors: 0 })
    expect(parsed.shapes).toBeGreaterThan(10)
    expect(text).not.toMatch(/href|url\(|script/)
    return { text, numbers: parsed.numbers }
  }
  const atEnd = await shown()
  // Two hit points and two leave points, each with its number.
  expect(atEnd.numbers.sort()).toEqual(['1', '1', '2', '2'])
  await press(page, 'Home')
  expect(await stepsInAll(page)).toBe(31)
  const atBeginning = await shown()
  expect(atBeginning.numbers).toEqual([])
  expect(atBeginning.text).not.toBe(atEnd.text)
})

test('what a picture leaves out is told', async ({ page }) => {
  const words = page.getByText('The picture leaves out vertices or edges')
  await save(page, 'Save picture (PNG)')
  await expect(words).toBeHidden()
  await choosePlanner(page, 'Probabilistic roadmap')
  await createMap(page, 400, 400)
  await setParam(page, 'Samples', 100_000)
  await expectSettled(page)
  await save(page, 'Save picture (PNG)')
  await expect(words).toBeVisible()
})
