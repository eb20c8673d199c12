import type { Theme } from '../render/theme'
import type { ThemeChoice } from './state/preferences'

/** The theme that the page is in: the one that was chosen, or else the one that the browser asks for. */
export class PageTheme {
  readonly #asksForLight = window.matchMedia('(prefers-color-scheme: light)')

  /** @param changed called when the browser asks for the other one */
  constructor(changed: () => void) {
    this.#asksForLight.addEventListener('change', changed)
  }

  for(choice: ThemeChoice): Theme['name'] {
    if (choice !== 'system') return choice
    return this.#asksForLight.matches ? 'light' : 'dark'
  }

  /** Puts the page in it. */
  show(choice: ThemeChoice): void {
    document.documentElement.setAttribute('theme', this.for(choice))
  }
}
