import { Picture } from '../render/picture'
import { Cards } from './layout/cards'
import { mapAttributes, mapLabel } from './map-attributes'
import { Playback, type PlaybackSettings } from './playback'
import { sceneOf } from './scene'
import type { Shown, State } from './state'
import type { Store } from './store'
import { layOut } from './transitions'

/**
 * What is seen: in the one animation frame of the page the panels show the state, the layout is
 * measured, the playback goes on, and the picture is drawn.
 */
export class Stage {
  readonly #store: Store<State>
  readonly #map: HTMLElement
  readonly #picture: Picture
  readonly #cards: Cards
  readonly #lightness = window.matchMedia('(prefers-color-scheme: light)')
  /** Called first in every frame. */
  readonly #tick: () => void
  #panels: readonly ((state: State) => void)[] = []
  #playback: Playback | null = null
  #rendered: State | null = null
  #layout: 'measured' | 'grown' | 'rearranged' = 'rearranged'
  #isRequested = false

  constructor(store: Store<State>, map: HTMLElement, tick: () => void) {
    this.#store = store
    this.#map = map
    this.#tick = tick
    this.#picture = new Picture(map)
    this.#cards = new Cards(document, (byUser) => this.coversChanged(byUser))
    window.addEventListener('resize', () => this.#resize())
    this.#lightness.addEventListener('change', () => {
      this.#rendered = null
      this.#request()
    })
    store.subscribe(() => {
      this.#describe()
      this.#request()
    })
  }

  /** The first frame comes next. */
  open(panels: readonly ((state: State) => void)[]): void {
    this.#panels = panels
    this.#resize()
  }

  play(shown: Shown, settings: PlaybackSettings): void {
    this.#playback = new Playback(shown, settings)
    this.#describe()
    this.#request()
  }

  /** What is being played is at its end at once. */
  stop(): void {
    this.#playback = null
    this.#describe()
    this.#request()
  }

  /** Something that floats above the map has another size or place. */
  coversChanged(byUser: boolean): void {
    if (byUser) this.#layout = 'rearranged'
    else if (this.#layout === 'measured') this.#layout = 'grown'
    this.#request()
  }

  #request(): void {
    if (this.#isRequested) return
    this.#isRequested = true
    requestAnimationFrame((now) => this.#draw(now))
  }

  #draw(now: number): void {
    this.#isRequested = false
    this.#tick()
    if (this.#store.state !== this.#rendered) this.#showPanels(this.#store.state)
    if (this.#layout !== 'measured') this.#measure()
    const { state } = this.#store
    this.#rendered = state
    const frame = this.#playback?.frameAt(now) ?? null
    if (!frame) this.#playback = null
    this.#picture.draw(sceneOf(state, this.#isDark(state), frame), state.view)
    this.#describe()
    if (this.#playback || state.run.kind === 'running') this.#request()
  }

  #showPanels(state: State): void {
    document.documentElement.setAttribute('theme', this.#isDark(state) ? 'dark' : 'light')
    for (const show of this.#panels) show(state)
    this.#map.setAttribute('aria-label', mapLabel(state))
  }

  #isDark({ preferences }: State): boolean {
    return preferences.theme === 'system' ? !this.#lightness.matches : preferences.theme === 'dark'
  }

  #measure(): void {
    const screen = { width: window.innerWidth, height: window.innerHeight }
    const byUser = this.#layout === 'rearranged'
    this.#layout = 'measured'
    this.#store.update((state) => layOut(state, screen, this.#cards.rects(), byUser))
  }

  #resize(): void {
    this.#picture.resize(window.innerWidth, window.innerHeight, window.devicePixelRatio)
    this.#cards.keepOnScreen()
    this.coversChanged(true)
  }

  #describe(): void {
    const attributes = mapAttributes(this.#store.state, this.#playback !== null)
    Object.assign(this.#map.dataset, attributes)
  }
}
