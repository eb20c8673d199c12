/** Where the map lies on the screen, in CSS pixels: the side of a cell, and the map's top left. */
export interface View {
  readonly scale: number
  readonly left: number
  readonly top: number
}
