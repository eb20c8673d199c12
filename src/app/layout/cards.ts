import type { Rect } from '../../render/view'

/** Below this width of the window the cards lie at its bottom, one open at a time. */
const NARROW = '(max-width: 640px)'
/** Below this one of either side they begin folded, so that the map can be seen. */
const SMALL = '(max-width: 640px), (max-height: 560px)'
/** And below this one those that come second. */
const MEDIUM = '(max-width: 1100px), (max-height: 680px)'
/** Within these there is no room for both of two open cards that stand one above the other. */
const LOW = '(max-width: 1100px) and (max-height: 680px), (max-height: 620px)'

const KEY_STEP = 16
const LARGE_KEY_STEP = 96
/** How much of a card always stays on the screen: its header. */
const HEADER = 48
const LEAST_HEIGHT = 160
const EDGE = 12

/** In the header, and not to drag by. */
const CONTROLS = '[data-fold], [data-close]'

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
}

/**
 * Makes the cards movable, by their headers and with the keys of their handles, and foldable.
 * `changed` is called when what they cover may have changed, and told whether by the user's doing.
 */
export class Cards {
  readonly #cards: readonly HTMLElement[]
  /** All that covers the map: the cards, and what floats but does not move. */
  readonly #covers: readonly HTMLElement[]
  readonly #narrow = window.matchMedia(NARROW)
  readonly #small = window.matchMedia(SMALL)
  readonly #medium = window.matchMedia(MEDIUM)
  readonly #low = window.matchMedia(LOW)
  #highest = 10
  readonly #changed: (byUser: boolean) => void

  constructor(root: ParentNode, changed: (byUser: boolean) => void) {
    this.#cards = [...root.querySelectorAll<HTMLElement>('[data-card]')]
    this.#covers = [...root.querySelectorAll<HTMLElement>('[data-card], [data-cover]')]
    this.#changed = changed
    for (const card of this.#cards) this.#bind(card)
    const observer = new ResizeObserver(() => changed(false))
    for (const cover of this.#covers) observer.observe(cover)
    for (const media of [this.#narrow, this.#small, this.#medium, this.#low]) {
      media.addEventListener('change', () => this.#rearrange())
    }
    this.#rearrange()
  }

  /** What is covered of the window, in CSS pixels. */
  rects(): Rect[] {
    return this.#covers
      .map((cover) => this.#rectOf(cover))
      .filter(({ width, height }) => width > 0 && height > 0)
  }

  /** What is seen of a cover: the cards at the bottom of a narrow window scroll if it is low. */
  #rectOf(cover: HTMLElement): Rect {
    const { left, top, width, bottom } = cover.getBoundingClientRect()
    const scrolls = this.#narrow.matches && 'card' in cover.dataset
    const sheet = scrolls ? cover.closest('[data-sheet]')?.getBoundingClientRect() : undefined
    const seenFrom = Math.max(top, sheet?.top ?? top)
    const seenTo = Math.min(bottom, sheet?.bottom ?? bottom)
    return { left, top: seenFrom, width, height: seenTo - seenFrom }
  }

  /** Brings cards that were moved back into a window that has become smaller. */
  keepOnScreen(): void {
    for (const card of this.#cards) if (card.dataset.moved) this.#moveBy(card, 0, 0)
  }

  #bind(card: HTMLElement): void {
    const handle = card.querySelector<HTMLElement>('[data-handle]')
    const grip = card.querySelector<HTMLElement>('[data-header]') ?? handle
    const fold = card.querySelector<HTMLElement>('[data-fold]')
    fold?.addEventListener('click', () => {
      const isOpen = fold.getAttribute('aria-expanded') === 'true'
      this.#fold(card, isOpen)
      if (isOpen) return
      this.#foldOthers(card)
      if (this.#narrow.matches) card.scrollIntoView({ block: 'nearest' })
    })
    // A finger hits the whole bar more easily than the button at its end.
    grip?.addEventListener('click', ({ target }) => {
      const isButton = target instanceof Element && target.closest('button')
      if (this.#narrow.matches && !isButton) fold?.click()
    })
    handle?.addEventListener('keydown', (event) => this.#handleKey(event, card))
    for (const touch of ['pointerdown', 'focusin']) {
      card.addEventListener(touch, () => this.#raise(card))
    }
    if (grip) this.#dragBy(grip, card)
  }

  /** The card that was used last lies on the others. */
  #raise(card: HTMLElement): void {
    this.#highest++
    card.style.zIndex = String(this.#highest)
  }

  #handleKey(event: KeyboardEvent, card: HTMLElement): void {
    if (this.#narrow.matches) return
    const arrow = ARROWS[event.key]
    if (event.key === 'Home') this.#putBack(card)
    else if (arrow) {
      const step = event.shiftKey ? LARGE_KEY_STEP : KEY_STEP
      this.#moveBy(card, arrow[0] * step, arrow[1] * step)
    } else return
    event.preventDefault()
    this.#changed(true)
  }

  #dragBy(grip: HTMLElement, card: HTMLElement): void {
    let last: { x: number; y: number } | null = null
    grip.addEventListener('pointerdown', (event) => {
      const control = event.target instanceof Element && event.target.closest(CONTROLS)
      if (control || event.button !== 0 || this.#narrow.matches) return
      last = { x: event.clientX, y: event.clientY }
      grip.setPointerCapture(event.pointerId)
    })
    grip.addEventListener('pointermove', (event) => {
      if (!last) return
      this.#moveBy(card, event.clientX - last.x, event.clientY - last.y)
      last = { x: event.clientX, y: event.clientY }
    })
    // Safari selects the text that a quick pointer runs over, even if no text can be selected in the header.
    document.addEventListener('selectstart', (event) => {
      if (last) event.preventDefault()
    })
    const end = () => {
      if (last) this.#changed(true)
      last = null
    }
    grip.addEventListener('pointerup', end)
    grip.addEventListener('pointercancel', end)
    grip.addEventListener('dblclick', (event) => {
      if (event.target instanceof Element && event.target.closest(CONTROLS)) return
      this.#putBack(card)
      this.#changed(true)
    })
  }

  #moveBy(card: HTMLElement, dx: number, dy: number): void {
    const { left, top, width } = card.getBoundingClientRect()
    const within = (value: number, most: number) => Math.max(0, Math.min(value, most))
    const newTop = within(top + dy, window.innerHeight - HEADER)
    if (!card.dataset.moved) card.style.width = `${width}px`
    card.dataset.moved = 'true'
    card.style.left = `${within(left + dx, window.innerWidth - width)}px`
    card.style.top = `${newTop}px`
    card.style.maxHeight = `${Math.max(LEAST_HEIGHT, window.innerHeight - newTop - EDGE)}px`
  }

  #putBack(card: HTMLElement): void {
    delete card.dataset.moved
    for (const property of ['left', 'top', 'width', 'max-height'])
      card.style.removeProperty(property)
  }

  #fold(card: HTMLElement, folded: boolean): void {
    const button = card.querySelector('[data-fold]')
    card.classList.toggle('folded', folded)
    button?.setAttribute('aria-expanded', String(!folded))
    this.#changed(true)
  }

  /** Folds the cards for which one that was opened leaves no room. */
  #foldOthers(open: HTMLElement): void {
    const inTheWay = (card: HTMLElement) =>
      this.#narrow.matches || (this.#low.matches && isStacked(card) && isStacked(open))
    for (const card of this.#cards) {
      if (card !== open && card.classList.contains('panel') && inTheWay(card))
        this.#fold(card, true)
    }
  }

  #rearrange(): void {
    for (const card of this.#cards) {
      this.#putBack(card)
      const beginsFolded = 'second' in card.dataset ? this.#medium : this.#small
      // What is not there is opened when it comes, so that others make room for it.
      const isFolded = beginsFolded.matches || card.hidden !== false
      if (card.classList.contains('panel')) this.#fold(card, isFolded)
    }
  }
}

/** Whether it stands above or below others, where it was put at first. */
const isStacked = ({ dataset }: HTMLElement): boolean => 'stacked' in dataset && !dataset.moved
