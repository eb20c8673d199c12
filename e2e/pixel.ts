import { inflateSync } from 'node:zlib'

const SIGNATURE_LENGTH = 8
const TRUE_COLOUR = 2
const TRUE_COLOUR_AND_ALPHA = 6

/**
 * The colours of a screenshot, as `#rrggbb`, pixel by pixel. Screenshots are PNG images of eight
 * bits a channel, so that a whole decoder comes down to two steps: join and inflate the data
 * chunks, and undo each row's filter (PNG specification, section 9).
 */
export function coloursOf(png: Buffer): string[] {
  const data: Buffer[] = []
  let [width, channels] = [0, 0]
  for (let at = SIGNATURE_LENGTH; at < png.length; ) {
    const length = png.readUInt32BE(at)
    const type = png.toString('latin1', at + 4, at + 8)
    const content = png.subarray(at + 8, at + 8 + length)
    if (type === 'IHDR') {
      width = content.readUInt32BE(0)
      channels = channelsOf(content[9])
    }
    if (type === 'IDAT') data.push(content)
    at += length + 12
  }
  const bytes = unfiltered(inflateSync(Buffer.concat(data)), width * channels, channels)
  const colours: string[] = []
  for (let at = 0; at < bytes.length; at += channels) {
    colours.push(`#${bytes.toString('hex', at, at + 3)}`)
  }
  return colours
}

function channelsOf(colourType: number): number {
  if (colourType === TRUE_COLOUR) return 3
  if (colourType === TRUE_COLOUR_AND_ALPHA) return 4
  throw new Error(`The image has the colour type ${colourType}.`)
}

/** The rows without the filter byte that each begins with. */
function unfiltered(filtered: Buffer, rowLength: number, channels: number): Buffer {
  const rows = filtered.length / (rowLength + 1)
  const bytes = Buffer.alloc(rows * rowLength)
  for (let row = 0; row < rows; row++) {
    const filter = filtered[row * (rowLength + 1)]
    for (let i = 0; i < rowLength; i++) {
      const at = row * rowLength + i
      const left = i >= channels ? bytes[at - channels] : 0
      const above = row > 0 ? bytes[at - rowLength] : 0
      const corner = row > 0 && i >= channels ? bytes[at - rowLength - channels] : 0
      const guess = [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter]
      bytes[at] = filtered[row * (rowLength + 1) + 1 + i] + guess
    }
  }
  return bytes
}

function paeth(left: number, above: number, corner: number): number {
  const estimate = left + above - corner
  const [a, b, c] = [left, above, corner].map((value) => Math.abs(estimate - value))
  if (a <= b && a <= c) return left
  return b <= c ? above : corner
}
