import { byId } from '../element'
import { type IconName, setIcon } from '../icons'
import type { ThemeChoice } from '../state/preferences'

const NEXT: Readonly<Record<ThemeChoice, ThemeChoice>> = {
  system: 'dark',
  dark: 'light',
  light: 'system',
}

const SIGNS: Readonly<Record<ThemeChoice, IconName>> = {
  system: 'theme-system',
  dark: 'theme-dark',
  light: 'theme-light',
}

/** Binds the button that goes through the themes; returns what shows the choice in it. */
export function themeButton(chosen: (theme: ThemeChoice) => void): (choice: ThemeChoice) => void {
  const button = byId('theme', HTMLButtonElement)
  const sign = button.querySelector('svg')
  let shown: ThemeChoice = 'system'
  button.addEventListener('click', () => chosen(NEXT[shown]))
  return (choice) => {
    shown = choice
    const label = `Theme: ${choice}. Change to ${NEXT[choice]}`
    button.setAttribute('aria-label', label)
    button.title = label
    if (sign) setIcon(sign, SIGNS[choice])
  }
}
