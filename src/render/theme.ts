/**
 * The colours of the map. Those of cells are opaque `#rrggbb`, because cells are painted pixel by
 * pixel; the others are any CSS colour.
 */
export interface Theme {
  readonly name: 'dark' | 'light'
  /** Around the map, and the line around it. */
  readonly outside: string
  readonly border: string
  readonly gridLine: string
  readonly cell: {
    readonly free: string
    readonly open: string
    readonly closed: string
    /** Free cells of a planner with a rover: sensed, and not sensed so far. */
    readonly sensed: string
    readonly unsensed: string
  }
  readonly obstacle: {
    /** Seen by the planner: all of them, or those that the rover has sensed. */
    readonly seen: string
    readonly unsensed: string
    /** Along the boundary that the rover follows. */
    readonly felt: string
  }
  readonly rim: string
  readonly unsensedRim: string
  readonly feltMark: string
  /** Heat map of the potential, from the lowest to the highest, in even steps. */
  readonly heat: readonly string[]
  /** What is written on a cell: the one of the two that can be read there. */
  readonly ink: { readonly dark: string; readonly light: string }
  readonly start: string
  readonly goal: string
  readonly markRim: string
  readonly markGlyph: string
  readonly roadmap: string
  readonly vertex: string
  readonly mLine: string
  readonly path: string
  /** Under lines and marks, so that they stand out on any cell. */
  readonly casing: string
  readonly hit: string
  readonly leave: string
  readonly rover: string
  readonly sensor: string
  readonly sensorArea: string
  readonly cursor: string
  /** A test or a try that succeeded, or failed; never told by these colours alone. */
  readonly passed: string
  readonly failed: string
}

const dark: Theme = {
  name: 'dark',
  outside: '#070c1a',
  border: '#3a4a78',
  gridLine: 'rgba(122, 136, 176, 0.22)',
  cell: {
    free: '#101c3d',
    open: '#2a6a8f',
    closed: '#1c3868',
    sensed: '#22386f',
    unsensed: '#0c142c',
  },
  obstacle: { seen: '#dcbf8f', unsensed: '#84735a', felt: '#f59a4a' },
  rim: '#ffffff',
  unsensedRim: '#a39a8c',
  feltMark: '#5c2a00',
  heat: ['#0a1130', '#1f1a5c', '#422483', '#6a2e9c', '#913ba3', '#b34ea0'],
  ink: { dark: '#0a1130', light: '#ffffff' },
  start: '#3ddc84',
  goal: '#ff5f6b',
  markRim: '#ffffff',
  markGlyph: '#08122b',
  roadmap: '#a78bfa',
  vertex: '#c4b1ff',
  mLine: '#9fdcff',
  path: '#4ade80',
  casing: '#070f26',
  hit: '#ffd166',
  leave: '#7ff0ff',
  rover: '#f4f8ff',
  sensor: '#8fd3ff',
  sensorArea: 'rgba(143, 211, 255, 0.12)',
  cursor: '#ffffff',
  passed: '#4ade80',
  failed: '#ff7b72',
}

const light: Theme = {
  name: 'light',
  outside: '#e3e6ee',
  border: '#7f8aa6',
  gridLine: 'rgba(60, 70, 104, 0.16)',
  cell: {
    free: '#fdfdfb',
    open: '#9fd6e2',
    closed: '#d6e4f7',
    sensed: '#fdfdfb',
    unsensed: '#ccd2e0',
  },
  obstacle: { seen: '#9c753e', unsensed: '#786d5f', felt: '#cf6a1c' },
  rim: '#6b4b1e',
  unsensedRim: '#615748',
  feltMark: '#fff3e6',
  heat: ['#fffdf5', '#ebe9fb', '#d9d4f8', '#cbbef2', '#c8b0ec', '#c29fe2'],
  ink: { dark: '#1b1440', light: '#ffffff' },
  start: '#0b7a3e',
  goal: '#d0182f',
  markRim: '#ffffff',
  markGlyph: '#ffffff',
  roadmap: '#6d3fe0',
  vertex: '#4c1fc0',
  mLine: '#0b5fae',
  path: '#0b7836',
  casing: '#ffffff',
  hit: '#8a4b00',
  leave: '#00677a',
  rover: '#10204a',
  sensor: '#1f5fae',
  sensorArea: 'rgba(31, 95, 174, 0.10)',
  cursor: '#10204a',
  passed: '#0b7836',
  failed: '#c0182b',
}

/** By name. */
export const themes = { dark, light } as const
