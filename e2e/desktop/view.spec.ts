import { expect, test } from '../fixtures'
import type { MapOnScreen, Place } from '../map-on-screen'
import { playback, scrubber } from '../steps'

const AT = [3, 4] as const

/** How far two places on the screen lie from each other. */
const distance = (a: { x: number; y: number }, b: { x: number; y: number }) =>
  Math.hypot(a.x - b.x, a.y - b.y)

async function moved(map: MapOnScreen, place: Place, action: () => Promise<void>) {
  const before = await map.cell(...place)
  await action()
  const after = await map.cell(...place)
  return { x: after.x - before.x, y: after.y - before.y }
}

test('the wheel zooms at the pointer', async ({ map }) => {
  const before = await map.view()
  const place = await map.cell(...AT)
  await map.wheel(AT, -300)
  await expect.poll(async () => (await map.view()).scale).toBeGreaterThan(before.scale * 1.3)
  expect(distance(await map.cell(...AT), place)).toBeLessThan(1)
  await map.wheel(AT, 600)
  await expect.poll(async () => (await map.view()).scale).toBeLessThan(before.scale)
  expect(distance(await map.cell(...AT), place)).toBeLessThan(1)
})

test('a pinch on a touchpad zooms finer', async ({ map, page }) => {
  const before = await map.view()
  await map.moveTo(...AT)
  await page.keyboard.down('Control')
  await page.mouse.wheel(0, -20)
  await page.keyboard.up('Control')
  await expect.poll(async () => (await map.view()).scale).toBeGreaterThan(before.scale * 1.1)
})

test('a pinch on a touchpad zooms at the pointer where the browser is Safari', async ({ map }) => {
  const before = await map.view()
  const place = await map.cell(...AT)
  const prevented = await map.element.evaluate((element, { x, y }) => {
    const tell = (type: string, scale: number) => {
      const event = new MouseEvent(type, { clientX: x, clientY: y, cancelable: true })
      return !element.dispatchEvent(Object.assign(event, { scale }))
    }
    return [tell('gesturestart', 1), tell('gesturechange', 1.2), tell('gesturechange', 1.5)]
  }, place)
  expect(prevented, 'else Safari zooms the page').toEqual([true, true, true])
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(before.scale * 1.5)
  expect(distance(await map.cell(...AT), place)).toBeLessThan(1)
})

test('there is an end to zooming, both ways', async ({ map }) => {
  await map.wheel(AT, -20_000)
  await expect.poll(async () => (await map.view()).scale).toBe(160)
  await map.wheel(AT, 40_000)
  await expect.poll(async () => (await map.view()).scale).toBeLessThan(10)
  const { scale, width, height } = await map.view()
  expect(scale * Math.max(width, height)).toBeGreaterThan(100)
})

test('the middle button moves the map and draws nothing', async ({ map }) => {
  const name = String(await map.element.getAttribute('aria-label'))
  const shift = await moved(map, AT, () =>
    map.drag(
      [
        [3, 4],
        [5, 7],
      ],
      'middle',
    ),
  )
  const { scale } = await map.view()
  expect(distance(shift, { x: 2 * scale, y: 3 * scale })).toBeLessThan(2)
  await expect(map.element).toHaveAccessibleName(name)
  await expect(map.element).toHaveAttribute('data-status', 'reached')
})

test('Space and drag moves the map, and draws nothing', async ({ map, page }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  const cells = String(await map.element.getAttribute('data-cells'))
  await page.keyboard.down('Space')
  const { x, y } = await map.cell(2, 12)
  const shift = await moved(map, AT, async () => {
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 40, y - 70, { steps: 4 })
    await page.mouse.up()
  })
  await page.keyboard.up('Space')
  expect(distance(shift, { x: 40, y: -70 })).toBeLessThan(1)
  await expect(map.element).toHaveAttribute('data-cells', cells)
  await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute('aria-disabled', 'true')
})

test('a drag beside the map moves it', async ({ map }) => {
  const shift = await moved(map, AT, () =>
    map.drag([
      [-1, 9],
      [-3, 9],
    ]),
  )
  const { scale } = await map.view()
  expect(distance(shift, { x: -2 * scale, y: 0 })).toBeLessThan(2)
})

test('the map never leaves the screen altogether', async ({ map, page }) => {
  await map.press(AT, 'middle')
  await page.mouse.move(5000, 5000)
  await map.release('middle')
  const { left, top } = await map.view()
  expect(left).toBeLessThan(1280 - 20)
  expect(top).toBeLessThan(800 - 20)
})

test('the toolbar zooms and shows the whole map again', async ({ map, page }) => {
  const fitted = await map.view()
  const press = (name: string) => page.getByRole('button', { name }).click()
  await press('Zoom in')
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(fitted.scale * 1.25)
  await press('Zoom out')
  await press('Zoom out')
  await expect.poll(async () => (await map.view()).scale).toBeCloseTo(fitted.scale / 1.25)
  await press('Show the whole map')
  await expect.poll(() => map.view()).toEqual(fitted)
})

test('a window of another size shows the same map, whole', async ({ map, page }) => {
  await expect(map.element).toHaveAttribute('data-status', 'reached')
  const cells = String(await map.element.getAttribute('data-cells'))
  const before = await map.view()
  await page.setViewportSize({ width: 900, height: 620 })
  await expect.poll(async () => (await map.view()).scale).toBeLessThan(before.scale)
  const { left, top, scale, width, height } = await map.view()
  expect(left).toBeGreaterThanOrEqual(0)
  expect(top).toBeGreaterThanOrEqual(0)
  expect(left + scale * width).toBeLessThanOrEqual(900)
  expect(top + scale * height).toBeLessThanOrEqual(620)
  await expect(map.element).toHaveAttribute('data-cells', cells)
  await page.setViewportSize({ width: 1280, height: 800 })
  await expect.poll(() => map.view()).toEqual(before)
})

test('cards can be moved and folded, and the map lies beside them', async ({ map, page }) => {
  const card = page.getByRole('region', { name: 'Planner', exact: true })
  const handle = page.getByRole('button', { name: 'Move the planner card' })
  const box = async () => (await card.boundingBox()) ?? { x: Number.NaN, y: Number.NaN }
  const before = await box()
  await handle.hover()
  await page.mouse.down()
  await page.mouse.move(700, 300, { steps: 4 })
  await page.mouse.up()
  await expect.poll(async () => (await box()).x).toBeGreaterThan(before.x + 100)
  await handle.focus()
  const dragged = await box()
  await page.keyboard.press('ArrowLeft')
  await page.keyboard.press('Shift+ArrowDown')
  expect((await box()).x).toBe(dragged.x - 16)
  await page.keyboard.press('Home')
  await expect.poll(async () => (await box()).x).toBe(before.x)

  await expect(page.getByLabel('Diagonal steps')).toBeVisible()
  await page.getByRole('button', { name: 'Fold the planner card' }).click()
  await expect(page.getByLabel('Diagonal steps')).toBeHidden()
  await expect(card.getByRole('heading', { name: 'Tangent Bug' })).toBeVisible()
  await expect(map.element).toHaveAttribute('data-status', 'reached')
})

test('no text is selected while a card is moved, as Safari would, and is again afterwards', async ({
  page,
}) => {
  const summary = page.locator('#planner .summary')
  const canBeSelected = () =>
    summary.evaluate((element) =>
      element.dispatchEvent(new Event('selectstart', { bubbles: true, cancelable: true })),
    )
  await page.getByRole('heading', { name: 'Planner', exact: true }).hover()
  await page.mouse.down()
  await page.mouse.move(700, 300)
  expect(await canBeSelected()).toBe(false)
  await page.mouse.up()
  expect(await canBeSelected()).toBe(true)
})

test('the playback can be moved and folded, and its buttons stay', async ({ page }) => {
  const bar = playback(page)
  const box = async () => (await bar.boundingBox()) ?? { y: Number.NaN, height: Number.NaN }
  const before = await box()
  const fold = bar.getByRole('button', { name: 'Fold the bar of steps' })
  await fold.click()
  await expect(fold).toHaveAttribute('aria-expanded', 'false')
  await expect(page.getByLabel("Rover's view")).toBeHidden()
  await expect(bar.getByRole('button', { name: 'Play', exact: true })).toBeVisible()
  await expect(scrubber(page)).toBeVisible()
  await expect.poll(async () => (await box()).height).toBeLessThan(before.height)
  await fold.click()
  await expect.poll(box).toEqual(before)

  await bar.getByRole('button', { name: 'Move the bar of steps' }).focus()
  await page.keyboard.press('ArrowUp')
  expect((await box()).y).toBe(before.y - 16)
  await page.keyboard.press('Home')
  await expect.poll(box).toEqual(before)
})
