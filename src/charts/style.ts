/** Colours of a chart, all opaque: a chart that was saved stands alone. */
export interface ChartTheme {
  readonly surface: string
  readonly ink: string
  readonly faint: string
  /** Of series, told apart by people with any kind of colour vision, and never by colour alone. */
  readonly series: readonly string[]
}

/** As the page has them. */
export type ThemeName = 'dark' | 'light'

// After M. Okabe and K. Ito, "Color universal design", 2008; lighter or darker where it was needed
// to stand out on the surface.
export const chartThemes = {
  dark: {
    surface: '#101935',
    ink: '#e7ebfa',
    faint: '#4a5a8c',
    series: [
      '#56b4e9',
      '#e69f00',
      '#19b98b',
      '#f0e442',
      '#e8713c',
      '#d98db8',
      '#8c9eff',
      '#e7ebfa',
    ],
  },
  light: {
    surface: '#fcfcfe',
    ink: '#161c2d',
    faint: '#aab2c6',
    series: [
      '#0072b2',
      '#b86e00',
      '#007a5a',
      '#7a6a00',
      '#c23b00',
      '#a8487f',
      '#4a3fb0',
      '#161c2d',
    ],
  },
} as const satisfies Record<ThemeName, ChartTheme>

const SYMBOLS = ['circle', 'square', 'triangle', 'diamond', 'star', 'cross', 'wye'] as const
const DASHES = ['', '6 3', '2 3', '9 3 2 3', '12 4'] as const

export interface SeriesStyle {
  readonly colour: string
  readonly symbol: (typeof SYMBOLS)[number]
  /** Lengths of dashes and gaps in pixels; empty for a full line. */
  readonly dash: string
}

/**
 * How series number `style` looks. The numbers of colours, symbols and dashes (8, 7 and 5) have no
 * common factor, so that 280 series all differ, and neighbours differ in all three.
 */
export const seriesStyle = (theme: ChartTheme, style: number): SeriesStyle => ({
  colour: theme.series[style % theme.series.length],
  symbol: SYMBOLS[style % SYMBOLS.length],
  dash: DASHES[style % DASHES.length],
})
