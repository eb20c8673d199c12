import type { Page } from '@playwright/test'
import { choosePlanner, createMap, expectSettled } from '../actions'
import { expect, test } from '../fixtures'
import type { MapOnScreen } from '../map-on-screen'
import { expectStep, playback, press, reasons, scrubber, stepsInAll } from '../steps'

const SIDE = 2048

/** The largest map there is, and the plan for it. */
async function planOnLargestMap(page: Page, planner: string): Promise<void> {
  await choosePlanner(page, planner)
  await createMap(page, SIDE, SIDE)
  const map = page.getByRole('application')
  await expect(map).toHaveAttribute('data-painted', 'true')
  await expectSettled(page)
  await expect(map).toHaveAttribute('data-painted', 'true')
}

async function zoomIn(map: MapOnScreen): Promise<void> {
  const middle = SIDE / 2
  await map.wheel([middle, middle - 200], -2400)
  await expect.poll(async () => (await map.view()).scale).toBeGreaterThan(8)
}

interface Answer {
  /** Animation frames from the move to the one that shows it. */
  readonly frames: number
  readonly isPlanning: boolean
}

/** From now on, for each move of a stroke: after how many frames another colour is under it. */
async function watchStroke(page: Page): Promise<() => Promise<Answer[]>> {
  const watched = await page.getByRole('application').evaluateHandle((map) => {
    const ground = map.querySelector<HTMLCanvasElement>('canvas[data-layer=ground]')
    const copy = new OffscreenCanvas(innerWidth, innerHeight)
    const context = copy.getContext('2d', { willReadFrequently: true })
    if (!ground || !context) throw new Error('There is no ground to look at.')
    const colours = (x: number, y: number, width: number, height: number) => {
      context.drawImage(ground, x, y, width, height, x, y, width, height)
      return new Uint32Array(context.getImageData(x, y, width, height).data.buffer)
    }
    const before = colours(0, 0, copy.width, copy.height)
    const answers: Answer[] = []
    window.addEventListener('pointermove', ({ clientX, clientY, buttons }) => {
      if (buttons === 0) return
      const [x, y] = [Math.floor(clientX), Math.floor(clientY)]
      const isPlanning = map.dataset.run === 'running'
      let frames = 0
      const look = () => {
        frames++
        // After what is drawn in this frame.
        setTimeout(() => {
          const isSeen = colours(x, y, 1, 1)[0] !== before[y * copy.width + x]
          if (isSeen || frames > 30) answers.push({ frames, isPlanning })
          else requestAnimationFrame(look)
        })
      }
      requestAnimationFrame(look)
    })
    return answers
  })
  return () => watched.jsonValue()
}

test('a stroke on four million cells is on screen in the next frame while the planner works', async ({
  map,
  page,
}) => {
  await planOnLargestMap(page, 'Grid decomposition')
  await zoomIn(map)
  const { left, top, scale } = await map.view()
  const [x, y] = [Math.ceil(350 - left), Math.ceil(300 - top)].map((at) => Math.ceil(at / scale))
  const answers = await watchStroke(page)
  await map.press([x, y])
  for (let i = 1; i <= 25; i++) await map.moveTo(x + i, y + (i % 3))
  await expect.poll(async () => (await answers()).length).toBeGreaterThanOrEqual(25)
  await map.release()
  const list = await answers()
  expect(list.filter(({ isPlanning }) => isPlanning).length).toBeGreaterThan(10)
  expect(list.filter(({ frames }) => frames > 1)).toEqual([])
  await expectSettled(page)
})

/** Frames that the page draws, counted until the answer is asked for. */
async function countFrames(page: Page): Promise<() => Promise<number>> {
  const counted = await page.evaluateHandle(() => {
    const count = { frames: 0 }
    const next = () => {
      count.frames++
      requestAnimationFrame(next)
    }
    requestAnimationFrame(next)
    return count
  })
  return async () => (await counted.jsonValue()).frames
}

test('one steps back from the end of a plan of millions of steps, and forwards again', async ({
  page,
}) => {
  await planOnLargestMap(page, 'Grid decomposition')
  const steps = await stepsInAll(page)
  expect(steps).toBeGreaterThan(3e6)
  const frames = await countFrames(page)
  await scrubber(page).focus()
  for (let back = 1; back <= 3; back++) {
    await press(page, 'ArrowLeft')
    await expectStep(page, steps - back, steps)
  }
  for (const place of [2_000_003, 3_000_000, 1_000_000, 17]) {
    await scrubber(page).fill(String(place))
    await expectStep(page, place, steps)
    await press(page, 'ArrowLeft')
    await expectStep(page, place - 1, steps)
  }
  await press(page, 'End')
  await expectStep(page, steps, steps)
  expect(await frames()).toBeGreaterThan(10)
})

test('a plan too long for its tape says that small things are left out', async ({ page }) => {
  await planOnLargestMap(page, 'Potential field')
  await expect(
    playback(page).getByText(/^Step [\d,]+ of [\d,]+, small things left out$/),
  ).toBeVisible()
  const words = /^This plan is too long to keep all that happens in it\. Small things are left out/
  await expect(reasons(page).getByText(words)).toBeVisible()
  await press(page, 'ArrowLeft')
  await expect(reasons(page).getByText(words)).toBeVisible()

  await choosePlanner(page, 'Bug2')
  await expectSettled(page)
  await expect(reasons(page).getByText(words)).toBeHidden()
})

test('no browser leaves out cells of a map that is drawn as a whole', async ({ map, page }) => {
  await planOnLargestMap(page, 'Bug2')
  const drawn = await page.evaluateHandle(() => {
    const ratios: number[] = []
    const { drawImage } = CanvasRenderingContext2D.prototype
    CanvasRenderingContext2D.prototype.drawImage = function (...args: unknown[]) {
      // Size of what is drawn: the whole image, or as the arguments say; and that on the canvas.
      const { width } = args[0] as HTMLCanvasElement
      const [from, to] = args.length === 9 ? [args[3], args[7]] : [width, args[3]]
      ratios.push(Number(to) / Number(from))
      Reflect.apply(drawImage, this, args)
    }
    return ratios
  })
  await map.wheel([SIDE / 2, SIDE / 2], 2400)
  await expect.poll(async () => (await map.view()).scale).toBeLessThan(0.1)
  await expect.poll(async () => (await drawn.jsonValue()).length).toBeGreaterThan(0)
  // Smoothing takes the four nearest pixels into account, which is all of them down to a half.
  expect(Math.min(...(await drawn.jsonValue()))).toBeGreaterThan(0.45)
})
