import type { Scene } from './scene'

/**
 * The picture of the whole map as a PNG.
 * @param cellSize side of a cell in pixels; less if a side of the picture would pass 8192 pixels
 */
export async function pictureAsPng(scene: Scene, cellSize?: number): Promise<Blob> {
  throw new Error(`Not drawn yet: ${scene.problem.grid.width} ${cellSize}`)
}

/**
 * The picture of the whole map as a standalone SVG file.
 * @throws InputError if the map is too large for that
 */
export function pictureAsSvg(scene: Scene): string {
  throw new Error(`Not drawn yet: ${scene.problem.grid.width}`)
}
