import type { Size } from '../grid'
import { randomInteger } from '../random'
import { withEndsMadeFree } from './ends-made-free'
import { generator } from './generator'

export const blocks = generator({
  id: 'blocks',
  title: 'Blocks',
  help: 'Rectangles strewn over the map, some of them hollow: rooms with a few doors.',
  params: [
    {
      name: 'density',
      label: 'Density',
      kind: 'integer',
      min: 0,
      max: 60,
      default: 20,
      unit: '%',
      help: 'Share of the cells that are obstacles, as closely as whole blocks allow.',
    },
    {
      name: 'largest',
      label: 'Largest block',
      kind: 'integer',
      min: 1,
      max: 200,
      default: 8,
      unit: 'cells',
      help: 'Greatest number of cells on a side of a block.',
    },
    {
      name: 'hollow',
      label: 'Hollow blocks',
      kind: 'integer',
      min: 0,
      max: 100,
      default: 30,
      unit: '%',
      help: 'Share of the blocks from 3 cells wide that are hollow, with one to three doors in their walls.',
    },
  ],

  build(size, { density, largest, hollow }, random) {
    const walls = new Uint8Array(size.width * size.height)
    const wanted = (walls.length * density) / 100
    // A block may lie on others and add nothing, so their number is bounded too.
    for (let built = 0, tries = 4 * walls.length; built < wanted && tries > 0; tries--) {
      const block = randomBlock(size, largest, random)
      const isHollow = random() * 100 < hollow && block.right - block.left > 1
      built += isHollow ? buildRoom(size, walls, block, random) : fill(size, walls, block)
    }
    return withEndsMadeFree(size, walls)
  },
})

/** A rectangle of cells, its last column and row included. */
interface Block {
  readonly left: number
  readonly top: number
  readonly right: number
  readonly bottom: number
}

/** Of any size up to `largest`; it may stick out of the map, so that cells at the border are not rarer. */
function randomBlock({ width, height }: Size, largest: number, random: () => number): Block {
  const across = 1 + randomInteger(random, Math.min(largest, width))
  const down = 1 + randomInteger(random, Math.min(largest, height))
  const left = randomInteger(random, width + across - 1) - across + 1
  const top = randomInteger(random, height + down - 1) - down + 1
  return { left, top, right: left + across - 1, bottom: top + down - 1 }
}

/** Makes the cells of a block obstacles; returns how many of them were free. */
function fill(size: Size, walls: Uint8Array, block: Block): number {
  let added = 0
  const right = Math.min(block.right, size.width - 1)
  const bottom = Math.min(block.bottom, size.height - 1)
  for (let y = Math.max(0, block.top); y <= bottom; y++) {
    for (let x = Math.max(0, block.left); x <= right; x++) {
      const cell = y * size.width + x
      added += 1 - walls[cell]
      walls[cell] = 1
    }
  }
  return added
}

/** Four walls with one to three doors, which are not at the corners; returns the obstacles gained. */
function buildRoom(size: Size, walls: Uint8Array, block: Block, random: () => number): number {
  const { left, top, right, bottom } = block
  const sides: Block[] = [
    { left, top, right, bottom: top },
    { left, top: bottom, right, bottom },
    { left, top, right: left, bottom },
    { left: right, top, right, bottom },
  ]
  let added = 0
  for (const side of sides) added += fill(size, walls, side)
  for (let doors = 1 + randomInteger(random, 3); doors > 0; doors--) {
    const side = sides[randomInteger(random, 4)]
    const x = inside(side.left, side.right, random)
    const y = inside(side.top, side.bottom, random)
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) continue
    const cell = y * size.width + x
    added -= walls[cell]
    walls[cell] = 0
  }
  return added
}

/** A whole number between two others; neither of the two, if any number lies between them. */
function inside(from: number, to: number, random: () => number): number {
  return to - from < 2 ? from : from + 1 + randomInteger(random, to - from - 1)
}
