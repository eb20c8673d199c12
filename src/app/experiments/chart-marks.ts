import type { Mark } from '../../charts/chart'
import { MARK_ATTRIBUTE } from '../../charts/marks'

/** How far from a mark a press still counts, in pixels. */
const REACH = 22

const marksIn = (frame: Element): SVGElement[] => [
  ...frame.querySelectorAll<SVGElement>(`[${MARK_ATTRIBUTE}]`),
]

const numberOf = (element: Element | null): number =>
  Number(element?.getAttribute(MARK_ATTRIBUTE) ?? Number.NaN)

/** The number of the mark that has the focus, if it is one of this chart's. */
export function focusedMark(frame: Element): number | null {
  const { activeElement } = document
  return activeElement && frame.contains(activeElement) ? numberOf(activeElement) : null
}

/** Tab leads to one of the marks, the arrow keys to the others. */
export function makeReachable(frame: Element, focused: number | null): void {
  const elements = marksIn(frame)
  const entry = elements.find((element) => numberOf(element) === focused) ?? elements[0]
  entry?.setAttribute('tabindex', '0')
  if (focused !== null) entry?.focus()
}

/** Marks open by a press on or near them, by Enter and by Space; arrows go from one to the next. */
export function bindMarks(
  frame: HTMLElement,
  marks: readonly Mark[],
  opened: (mark: Mark) => void,
): void {
  const open = (element: Element | null) => {
    const mark = marks[numberOf(element)]
    if (mark) opened(mark)
  }
  frame.addEventListener('click', ({ target, clientX, clientY }) => {
    // Of marks that lie upon each other the one that is seen.
    const pressed = target instanceof Element ? target.closest(`[${MARK_ATTRIBUTE}]`) : null
    open(pressed ?? nearestMark(frame, clientX, clientY))
  })
  frame.addEventListener('keydown', (event) => {
    const here = document.activeElement
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault()
      return open(here)
    }
    const elements = marksIn(frame)
    const from = elements.findIndex((element) => numberOf(element) === numberOf(here))
    const to = elements[indexAfter(event.key, from, elements.length)]
    if (from < 0 || !to || to === here || !(event.key in STEPS)) return
    event.preventDefault()
    here?.setAttribute('tabindex', '-1')
    to.setAttribute('tabindex', '0')
    to.focus()
  })
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowDown: 1,
  ArrowLeft: -1,
  ArrowUp: -1,
  Home: Number.NEGATIVE_INFINITY,
  End: Number.POSITIVE_INFINITY,
}

const indexAfter = (key: string, from: number, length: number): number =>
  Math.min(length - 1, Math.max(0, from + (STEPS[key] ?? 0)))

function nearestMark(frame: Element, x: number, y: number): Element | null {
  let nearest: Element | null = null
  let least = REACH
  for (const element of marksIn(frame)) {
    const { left, right, top, bottom } = element.getBoundingClientRect()
    // The distance is 0 inside a mark. Between marks that overlap, the nearer middle decides.
    const dx = Math.max(left - x, 0, x - right)
    const dy = Math.max(top - y, 0, y - bottom)
    const distance =
      Math.hypot(dx, dy) + Math.hypot(x - (left + right) / 2, y - (top + bottom) / 2) / 1e4
    if (distance >= least) continue
    least = distance
    nearest = element
  }
  return nearest
}
