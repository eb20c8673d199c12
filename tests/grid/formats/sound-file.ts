/** A sound project file of a 3 × 2 map, with some of its keys changed. */
export const project = (change: object = {}): string =>
  JSON.stringify({
    format: 'path-planner',
    version: 1,
    diagonal: 'if-at-most-one-obstacle',
    start: [0, 0],
    goal: [2, 1],
    rows: ['..#', '#..'],
    ...change,
  })
