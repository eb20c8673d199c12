import {
  mdiAlert,
  mdiBookOpenVariant,
  mdiBrightness4,
  mdiChartBoxOutline,
  mdiCheckCircle,
  mdiChevronDown,
  mdiClose,
  mdiContentSaveOutline,
  mdiDice5Outline,
  mdiDownloadOutline,
  mdiDrag,
  mdiEraser,
  mdiFastForward,
  mdiFileExportOutline,
  mdiFilePlusOutline,
  mdiFitToScreenOutline,
  mdiFolderOpenOutline,
  mdiHelpCircleOutline,
  mdiImageOutline,
  mdiInformationOutline,
  mdiMapMarkerPath,
  mdiMapOutline,
  mdiMinus,
  mdiPause,
  mdiPlay,
  mdiPlus,
  mdiRedo,
  mdiRewind,
  mdiScaleBalance,
  mdiShieldCheck,
  mdiSkipBackward,
  mdiSkipForward,
  mdiStepBackward,
  mdiStepForward,
  mdiTimerSand,
  mdiUndo,
  mdiWall,
  mdiWeatherNight,
  mdiWeatherSunny,
} from '@mdi/js'
import { createSvg } from './element'

/** Outlines of 24 × 24 icons by the name that `data-icon` gives. */
const ICONS = {
  map: mdiMapOutline,
  new: mdiFilePlusOutline,
  scenarios: mdiBookOpenVariant,
  generate: mdiWall,
  open: mdiFolderOpenOutline,
  save: mdiContentSaveOutline,
  export: mdiFileExportOutline,
  'clear-obstacles': mdiEraser,
  'clear-path': mdiMapMarkerPath,
  undo: mdiUndo,
  redo: mdiRedo,
  'zoom-in': mdiPlus,
  'zoom-out': mdiMinus,
  fit: mdiFitToScreenOutline,
  'theme-system': mdiBrightness4,
  'theme-dark': mdiWeatherNight,
  'theme-light': mdiWeatherSunny,
  compare: mdiScaleBalance,
  help: mdiHelpCircleOutline,
  about: mdiInformationOutline,
  move: mdiDrag,
  fold: mdiChevronDown,
  close: mdiClose,
  dice: mdiDice5Outline,
  good: mdiCheckCircle,
  proof: mdiShieldCheck,
  bad: mdiAlert,
  busy: mdiTimerSand,
  'to-first': mdiSkipBackward,
  'landmark-before': mdiRewind,
  'step-back': mdiStepBackward,
  play: mdiPlay,
  pause: mdiPause,
  'step-forward': mdiStepForward,
  'next-landmark': mdiFastForward,
  'to-last': mdiSkipForward,
  picture: mdiImageOutline,
  experiments: mdiChartBoxOutline,
  run: mdiPlay,
  download: mdiDownloadOutline,
} as const

export type IconName = keyof typeof ICONS

const isIconName = (name: string | undefined): name is IconName =>
  name !== undefined && name in ICONS

export function icon(name: IconName): SVGSVGElement {
  const svg = createSvg('svg', { class: 'icon', 'aria-hidden': 'true' })
  setIcon(svg, name)
  return svg
}

export function setIcon(svg: SVGSVGElement, name: IconName): void {
  if (svg.dataset.icon === name && svg.firstChild) return
  svg.dataset.icon = name
  svg.setAttribute('viewBox', '0 0 24 24')
  svg.replaceChildren(createSvg('path', { d: ICONS[name] }))
}

/** Draws the icons that the page names with `data-icon`. */
export function drawIcons(root: ParentNode): void {
  for (const svg of root.querySelectorAll<SVGSVGElement>('svg[data-icon]')) {
    const { icon: name } = svg.dataset
    if (isIconName(name)) setIcon(svg, name)
  }
}
