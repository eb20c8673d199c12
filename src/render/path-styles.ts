/** How one of several paths that are drawn together looks. */
export interface PathStyle {
  /** By the theme's name. */
  readonly colour: { readonly dark: string; readonly light: string }
  /** Lengths of dashes and gaps in line widths; empty for a line without gaps. */
  readonly dash: readonly number[]
  /** Place among the paths, from 0, so that those along the same cells lie side by side. */
  readonly lane: number
}

/** A path as it is drawn with others. */
export interface StyledPath {
  readonly path: ArrayLike<number>
  readonly style: PathStyle
}

/*
 * The hues of M. Okabe and K. Ito, "Color Universal Design", 2008, which people with any kind of
 * colour vision tell apart, as light or as dark as each theme needs them; the dashes differ as well.
 */
const COLOURS_AND_DASHES: readonly (readonly [dark: string, light: string, dash: number[]])[] = [
  ['#ffffff', '#000000', []],
  ['#f0a30a', '#9c6500', [5, 2]],
  ['#6cc4ff', '#0a7fc2', [1.2, 1.4]],
  ['#1fc79a', '#007a58', [5, 1.6, 1.2, 1.6]],
  ['#f7ee5b', '#757000', [5, 1.6, 1.2, 1.6, 1.2, 1.6]],
  ['#8298ff', '#0040b0', [2.4, 2]],
  ['#ff7d45', '#c23b00', [9, 2.4]],
  ['#ee9cc9', '#a83579', [9, 1.6, 2.4, 1.6]],
]

/** They can be told apart by colour, by dashes and by place. */
export const pathStyles: readonly PathStyle[] = COLOURS_AND_DASHES.map(
  ([dark, light, dash], lane) => ({ colour: { dark, light }, dash, lane }),
)
