import { isWall, type World, type XY } from './world'

/**
 * Whether a cell can be seen from another: no obstacle on the line between their centres, row by
 * row or column by column along its longer axis. Halfway between two cells it takes both to hide.
 */
export function canSee(world: World, [ax, ay]: XY, [bx, by]: XY): boolean {
  const dx = bx - ax
  const dy = by - ay
  const across = Math.abs(dx) >= Math.abs(dy)
  const long = across ? Math.abs(dx) : Math.abs(dy)
  const short = across ? dy : dx
  const forward = Math.sign(across ? dx : dy)
  const isHidden = (i: number, j: number) =>
    across ? isWall(world, ax + forward * i, ay + j) : isWall(world, ax + j, ay + forward * i)
  for (let i = 1; i < long; i++) {
    // The line is at short * i / long beside its start; in whole numbers, to be exact at the half.
    const below = Math.floor((short * i) / long)
    const rest = short * i - below * long
    const hidden =
      rest * 2 === long
        ? isHidden(i, below) && isHidden(i, below + 1)
        : isHidden(i, rest * 2 < long ? below : below + 1)
    if (hidden) return false
  }
  return true
}
