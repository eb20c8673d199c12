/** The same bytes, four in a number; none if they do not begin where such a number may. */
export function int32View({ buffer, byteOffset, length }: Uint8Array): Int32Array {
  return byteOffset % 4 === 0 ? new Int32Array(buffer, byteOffset, length >> 2) : new Int32Array(0)
}
