import { inflateSync } from 'node:zlib'

const SIGNATURE_LENGTH = 8

/**
 * The colour, as `#rrggbb`, of a PNG image that is one pixel large. There a whole decoder comes
 * down to two steps, because no filter has anything to the left or above to refer to: join and
 * inflate the data chunks, skip the filter's byte.
 */
export function colourOfPixel(png: Buffer): string {
  const data: Buffer[] = []
  for (let at = SIGNATURE_LENGTH; at < png.length; ) {
    const length = png.readUInt32BE(at)
    const type = png.toString('latin1', at + 4, at + 8)
    const content = png.subarray(at + 8, at + 8 + length)
    if (type === 'IHDR' && (content.readUInt32BE(0) !== 1 || content.readUInt32BE(4) !== 1)) {
      throw new Error('The image is larger than one pixel.')
    }
    if (type === 'IDAT') data.push(content)
    at += length + 12
  }
  return `#${inflateSync(Buffer.concat(data)).toString('hex', 1, 4)}`
}
