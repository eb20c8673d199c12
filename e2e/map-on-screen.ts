import { expect, type Locator, type Page } from '@playwright/test'
import { coloursOf } from './pixel'

/** Column and row of a cell; fractions lie beside its centre: (3.3, 2) is to the right of it. */
export type Place = readonly [x: number, y: number]

type Button = 'left' | 'middle' | 'right'

/**
 * The map as a person has it: cells by column and row under a real mouse or real fingers, and
 * colours as they are on screen.
 */
export class MapOnScreen {
  readonly element: Locator
  readonly #page: Page

  constructor(page: Page) {
    this.#page = page
    this.element = page.locator('#map')
  }

  /** Where the map lies, in CSS pixels: its left, its top, the side of a cell; and its cells. */
  async view() {
    const data = await this.element.evaluate((map) => ({ ...map.dataset }))
    const [left, top, scale, width, height] = ['left', 'top', 'scale', 'width', 'height'].map(
      (name) => Number(data[name] ?? Number.NaN),
    )
    expect([left, top, scale, width, height], 'where the map lies').not.toContain(Number.NaN)
    return { left, top, scale, width, height }
  }

  /** The centre of a cell, in CSS pixels. */
  async cell(...[x, y]: Place) {
    const { left, top, scale } = await this.view()
    return { x: left + (x + 0.5) * scale, y: top + (y + 0.5) * scale }
  }

  /** What colour is on screen at the centre of a cell, as `#rrggbb`. */
  async colourAt(...place: Place): Promise<string> {
    const { x, y } = await this.cell(...place)
    const clip = { x: Math.floor(x), y: Math.floor(y), width: 1, height: 1 }
    return coloursOf(await this.#page.screenshot({ clip, scale: 'css' }))[0]
  }

  /** All colours within a cell, without its edges. */
  async coloursIn(...[x, y]: Place): Promise<Set<string>> {
    const { scale } = await this.view()
    const corner = await this.cell(x - 0.35, y - 0.35)
    const side = Math.floor(0.7 * scale)
    const clip = { x: Math.ceil(corner.x), y: Math.ceil(corner.y), width: side, height: side }
    return new Set(coloursOf(await this.#page.screenshot({ clip, scale: 'css' })))
  }

  /** Waits until a cell has a colour. */
  async expectColour(place: Place, colour: string): Promise<void> {
    const message = `colour at (${place.join(', ')})`
    await expect.poll(() => this.colourAt(...place), { message }).toBe(colour)
  }

  async moveTo(...place: Place): Promise<void> {
    const { x, y } = await this.cell(...place)
    await this.#page.mouse.move(x, y, { steps: 5 })
  }

  async press(place: Place, button: Button = 'left'): Promise<void> {
    await this.moveTo(...place)
    await this.#page.mouse.down({ button })
  }

  async release(button: Button = 'left'): Promise<void> {
    await this.#page.mouse.up({ button })
  }

  async click(place: Place, button: Button = 'left'): Promise<void> {
    await this.press(place, button)
    await this.release(button)
  }

  /** Presses at the first place, moves through the others, and releases at the last. */
  async drag(places: readonly [Place, ...Place[]], button: Button = 'left'): Promise<void> {
    const [first, ...rest] = places
    await this.press(first, button)
    for (const place of rest) await this.moveTo(...place)
    await this.release(button)
  }

  /** Turns the wheel over a cell; down is positive. */
  async wheel(place: Place, pixels: number): Promise<void> {
    await this.moveTo(...place)
    await this.#page.mouse.wheel(0, pixels)
  }

  async tap(...place: Place): Promise<void> {
    const { x, y } = await this.cell(...place)
    await this.#page.touchscreen.tap(x, y)
  }

  /**
   * Puts fingers on the map and moves them, each through its own places, all at the same pace. The
   * places are where cells are when the first finger goes down, even if the map then moves.
   */
  async touch(...fingers: readonly (readonly Place[])[]): Promise<void> {
    const tracks = await Promise.all(
      fingers.map((places) => Promise.all(places.map((place) => this.cell(...place)))),
    )
    const client = await this.#page.context().newCDPSession(this.#page)
    const steps = Math.max(...tracks.map((track) => track.length))
    for (let step = 0; step < steps; step++) {
      const touchPoints = tracks.map((track, id) => ({
        ...track[Math.min(step, track.length - 1)],
        id,
      }))
      const type = step === 0 ? 'touchStart' : 'touchMove'
      await client.send('Input.dispatchTouchEvent', { type, touchPoints })
    }
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    await client.detach()
  }
}
