import { Picture } from '../render/picture'
import type { Scene } from '../render/scene'
import { themes } from '../render/theme'
import { Cards } from './layout/cards'
import { PageTheme } from './page-theme'
import { type Moment, Moments } from './playback/moment'
import { Playback } from './playback/playback'
import { played } from './playback/transport'
import { sceneOf } from './scene'
import { type State, visiblePlan } from './state/state'
import type { Store } from './state/store'
import { crowd, layOut } from './state/transitions'
import { mapAttributes, mapLabel } from './words/map-attributes'

/** Shows a state, and the plan at the moment at which its cursor stands. */
export type Panel = (state: State, moment: Moment | null) => void

/** So long may be painted in one frame: what is left of a large map is painted in the next ones. */
const PAINTING_MS = 4
/** So long may be looked in one frame for a moment that lies far away on its tape. */
const SEEKING_MS = 6

/**
 * What is seen: in the one animation frame of the page the playback goes on, the panels show the
 * state, the layout is measured, and the picture is drawn.
 */
export class Stage {
  readonly #store: Store<State>
  readonly #map: HTMLElement
  readonly #picture: Picture
  readonly #cards: Cards
  readonly #theme: PageTheme
  /** Called first in every frame. */
  readonly #tick: () => void
  readonly #moments = new Moments()
  #panels: readonly Panel[] = []
  #playback: Playback | null = null
  #rendered: State | null = null
  #layout: 'measured' | 'grown' | 'rearranged' = 'rearranged'
  #isRequested = false
  #isOpen = false

  constructor(store: Store<State>, map: HTMLElement, tick: () => void) {
    this.#store = store
    this.#map = map
    this.#tick = tick
    this.#picture = new Picture(map)
    this.#cards = new Cards(document, (byUser) => this.coversChanged(byUser))
    window.addEventListener('resize', () => this.#resize())
    this.#theme = new PageTheme(() => {
      this.#rendered = null
      this.#request()
    })
    store.subscribe(() => {
      if (!this.#isOpen) return
      this.#describe()
      this.#request()
    })
  }

  /** From now on there are frames. */
  open(panels: readonly Panel[]): void {
    this.#panels = panels
    this.#isOpen = true
    this.#resize()
  }

  /** What is drawn of the state as it is now. */
  scene(): Scene {
    const { state } = this.#store
    const theme = this.#theme.for(state.preferences.theme)
    return sceneOf(state, this.#moments.of(state), themes[theme])
  }

  /** Something that floats above the map has another size or place. */
  coversChanged(byUser: boolean): void {
    if (byUser) this.#layout = 'rearranged'
    else if (this.#layout === 'measured') this.#layout = 'grown'
    this.#request()
  }

  #request(): void {
    if (this.#isRequested || !this.#isOpen) return
    this.#isRequested = true
    requestAnimationFrame((now) => this.#draw(now))
  }

  #draw(now: number): void {
    this.#isRequested = false
    this.#tick()
    this.#play(now)
    if (this.#isSeeking()) {
      this.#request()
      return
    }
    // With the first plan the cards come to their usual size: only then the page is as it was meant.
    if (this.#rendered?.shown === null && this.#store.state.shown) this.#layout = 'rearranged'
    if (this.#store.state !== this.#rendered) this.#showPanels(this.#store.state)
    if (this.#layout !== 'measured') this.#measure()
    const { state } = this.#store
    this.#rendered = state
    const isPainted = this.#picture.draw(this.scene(), state.view, paintingTime())
    this.#map.dataset.painted = String(isPainted)
    this.#store.update((before) => crowd(before, this.#picture.isCrowded))
    if (state.playing || state.run.kind === 'running' || !isPainted) this.#request()
  }

  /**
   * Whether the moment will be shown in a later frame only, because it takes a while to be found. That
   * is so for jumps on a tape, and never for edits of the map or for a plan that is played.
   */
  #isSeeking(): boolean {
    const { state } = this.#store
    const before = this.#rendered
    const isJump = before && state.shown === before.shown && state.setup === before.setup
    if (!isJump || state.time === before.time || state.playing) return false
    const end = performance.now() + SEEKING_MS
    const isTimeUp = () => performance.now() > end
    return !this.#moments.seek(state, isTimeUp) || isTimeUp()
  }

  #play(now: number): void {
    const { state } = this.#store
    const tape = visiblePlan(state)?.tape
    if (!tape || !state.playing) {
      this.#playback = null
      return
    }
    const playing = { tape, tempo: state.playing, time: state.time }
    if (!this.#playback?.isPlaying(playing)) this.#playback = new Playback(playing)
    const time = this.#playback.timeAt(now)
    this.#store.update((before) => played(before, time))
  }

  #showPanels(state: State): void {
    this.#theme.show(state.preferences.theme)
    const moment = this.#moments.of(state)
    for (const show of this.#panels) show(state, moment)
    this.#map.setAttribute('aria-label', mapLabel(state))
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
    const attributes = mapAttributes(this.#store.state)
    Object.assign(this.#map.dataset, attributes)
  }
}

/**
 * Says whether the time to paint in this frame is up. It runs from the first time that this is asked,
 * so that even the slowest machine paints something in each frame.
 */
function paintingTime(): () => boolean {
  let end: number | null = null
  return () => {
    const now = performance.now()
    end ??= now + PAINTING_MS
    return now > end
  }
}
