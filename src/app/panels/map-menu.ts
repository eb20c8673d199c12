import { byId } from '../element'

export type MapAction =
  | 'new'
  | 'scenarios'
  | 'generate'
  | 'open'
  | 'save'
  | 'save-map'
  | 'save-trace'
  | 'save-png'
  | 'save-svg'
  | 'clear-obstacles'
  | 'clear-path'

/** Binds the map menu: a popover whose entries are gone through with the arrow keys. */
export function mapMenu(actions: Readonly<Record<MapAction, () => void>>): void {
  const button = byId('map-menu-button', HTMLButtonElement)
  const menu = byId('map-menu', HTMLDivElement)
  const entries = [...menu.querySelectorAll<HTMLElement>('[role=menuitem]')]

  button.popoverTargetElement = menu
  menu.addEventListener('toggle', (event) => {
    const isOpen = event instanceof ToggleEvent && event.newState === 'open'
    button.setAttribute('aria-expanded', String(isOpen))
    if (!isOpen) return
    placeBelow(menu, button)
    entries[0].focus()
  })
  menu.addEventListener('keydown', (event) => {
    const here = entries.findIndex((entry) => entry.matches(':focus'))
    const to = nextEntry(event.key, here, entries.length)
    if (event.key === 'Tab') menu.hidePopover()
    if (to < 0) return
    event.preventDefault()
    entries[to].focus()
  })
  for (const entry of entries) {
    entry.tabIndex = -1
    entry.addEventListener('click', () => {
      menu.hidePopover()
      button.focus()
      const action = entry.dataset.action
      if (isAction(actions, action)) actions[action]()
    })
  }
}

const isAction = (actions: object, name: string | undefined): name is MapAction =>
  name !== undefined && name in actions

function nextEntry(key: string, here: number, count: number): number {
  switch (key) {
    case 'ArrowDown':
      return (here + 1) % count
    case 'ArrowUp':
      return (here + count - 1) % count
    case 'Home':
      return 0
    case 'End':
      return count - 1
    default:
      return -1
  }
}

function placeBelow(menu: HTMLElement, button: HTMLElement): void {
  const { left, bottom, top } = button.getBoundingClientRect()
  const { offsetWidth: width, offsetHeight: height } = menu
  const fitsBelow = bottom + 8 + height <= window.innerHeight
  menu.style.left = `${Math.max(8, Math.min(left, window.innerWidth - width - 8))}px`
  menu.style.top = `${fitsBelow ? bottom + 8 : Math.max(8, top - height - 8)}px`
}
