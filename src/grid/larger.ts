/** A larger array that begins with these values. */
export function larger<A extends { set(values: A): void }>(values: A, empty: A): A {
  empty.set(values)
  return empty
}
