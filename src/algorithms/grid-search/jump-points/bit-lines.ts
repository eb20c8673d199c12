/**
 * The obstacles of a map as lines of bits, 32 places in a word; what is off the map counts as
 * obstacle. Lines are rows or columns, and their places may be counted from either end.
 */
export interface BitLines {
  readonly words: Int32Array
  /** How many lines there are, and words in each. */
  readonly lines: number
  readonly wordsEach: number
}

/** The rows of a map, from west to east. */
export function rowLines(walls: Uint8Array, width: number): BitLines {
  const lines = walls.length / width
  const wordsEach = (width + 31) >> 5
  const words = new Int32Array(wordsEach * lines)
  for (let y = 0; y < lines; y++) {
    const row = y * width
    for (let i = 0; i < wordsEach; i++) {
      const first = 32 * i
      const places = Math.min(32, width - first)
      let word = places < 32 ? -1 << places : 0
      for (let p = 0; p < places; p++) word |= walls[row + first + p] << p
      words[y * wordsEach + i] = word
    }
  }
  return { words, lines, wordsEach }
}

/** The same lines with their places counted from the other end of their last word. */
export function reversed({ words, lines, wordsEach }: BitLines): BitLines {
  const back = new Int32Array(words.length)
  for (let line = 0; line < lines; line++) {
    const first = line * wordsEach
    const last = first + wordsEach - 1
    for (let i = 0; i < wordsEach; i++) back[last - i] = reversedWord(words[first + i])
  }
  return { words: back, lines, wordsEach }
}

/** The columns of what these are the rows of. @param lines how many columns there are */
export function transposed(rows: BitLines, lines: number): BitLines {
  const wordsEach = (rows.lines + 31) >> 5
  const words = new Int32Array(wordsEach * lines)
  const block = new Int32Array(32)
  for (let down = 0; down < wordsEach; down++) {
    const height = Math.min(32, rows.lines - 32 * down)
    for (let across = 0; across < rows.wordsEach; across++) {
      for (let y = 0; y < height; y++) {
        block[y] = rows.words[(32 * down + y) * rows.wordsEach + across]
      }
      block.fill(-1, height)
      transpose(block)
      const width = Math.min(32, lines - 32 * across)
      for (let x = 0; x < width; x++) words[(32 * across + x) * wordsEach + down] = block[x]
    }
  }
  return { words, lines, wordsEach }
}

/** Halves change places, then halves of halves. (H. S. Warren, "Hacker's Delight", 7.) */
function reversedWord(word: number): number {
  let w = word
  w = ((w >>> 1) & 0x55555555) | ((w & 0x55555555) << 1)
  w = ((w >>> 2) & 0x33333333) | ((w & 0x33333333) << 2)
  w = ((w >>> 4) & 0x0f0f0f0f) | ((w & 0x0f0f0f0f) << 4)
  w = ((w >>> 8) & 0x00ff00ff) | ((w & 0x00ff00ff) << 8)
  return (w >>> 16) | (w << 16)
}

/** Bit x of word y becomes bit y of word x: the squares off the diagonal change places, ever smaller ones. */
function transpose(block: Int32Array): void {
  for (let half = 16, mask = 0x0000ffff; half > 0; half >>= 1, mask ^= mask << half) {
    for (let i = 0; i < 32; i = (i + half + 1) & ~half) {
      const changed = ((block[i] >>> half) ^ block[i + half]) & mask
      block[i] ^= changed << half
      block[i + half] ^= changed
    }
  }
}
