/**
 * What can happen while a planner works. Every event has a cell, a second whole number and a
 * value; the comments say what they hold. -1 stands for "no cell" and for cells outside the map.
 * Whole numbers lie between -2^23 and 2^23: more than there are cells on any map.
 */
export const EVENT = {
  /** A phase of the planner's work begins: -, which of its phases. */
  phase: 0,
  /** The run is over: the cell where it ended, its place in STATUSES. */
  end: 1,

  // Searches.
  /** The free cells of a row became vertices of the grid's graph: first cell of the row, their number. */
  row: 2,
  /** A cell was tested for being the corner of an obstacle: cell, obstacle cell, 1 if it is else 0. */
  test: 3,
  /** A vertex of the roadmap: cell. */
  vertex: 4,
  /** An edge of the roadmap, whose simplest path is free: from cell, to cell, weight. */
  edge: 5,
  /** No edge: both simplest paths are refused. From cell, to cell, where the first one is. */
  refuse: 6,
  /** A cell or vertex was reached: cell, parent cell, cost so far. */
  open: 7,
  /**
   * The way to it is final. In a search over cells: cell, directions of the neighbours that become
   * open or get a shorter way with it; its cost is that of the way (`costAt`). Where all that is opened
   * has events of its own: cell, -1, cost.
   */
  close: 8,
  /** A cell of the path that was found, from start to goal: cell. */
  path: 9,

  // Potential fields.
  /** The parts of the potential of a cell, and their sum: cell, -, value. */
  attraction: 10,
  repulsion: 11,
  potential: 12,

  // Rovers and agents.
  /** The rover or the agent came to a cell, the start included: cell, cell before. */
  step: 13,
  /** The rover's sensor saw a cell for the first time: cell, 1 if it is an obstacle else 0. */
  sense: 14,
  /** The rover or the agent heads for a cell: cell, -, distance or potential by which it was chosen. */
  target: 15,
  /** A cell of the m-line: cell. */
  mLine: 16,
  /** An obstacle stopped the rover (hit point): cell, obstacle cell, its number from 1. */
  hit: 17,
  /** Which way round: cell, 0 obstacle on the left, 1 on the right. */
  turn: 18,
  /** The obstacle cell that the rover keeps at its side: cell. */
  feel: 19,
  /** The rover came round the obstacle once: cell, -, steps of the round. */
  around: 20,
  /** The rover left the boundary (leave point): cell, its place in LEAVES, its number from 1. */
  leave: 21,
  /** The same state came back: cell, -, the step at which the rover was in it before. */
  loop: 22,
  /** The local tangent graph is drawn up anew: cell of the rover. */
  scan: 23,
  /** A node of the local tangent graph: cell, -, distance over it to the goal. */
  node: 24,
  /** A number that the planner decides by: cell, which of its variables, its value. */
  value: 25,
  /** Too many edges to write them all down: those from this cell on are missing. Cell, -, how many are there. */
  cut: 26,
  /**
   * From here on what is left from a closed cell is reckoned to be the simplest path's cost to this
   * cell: the goal, which of the planner's variables is a closed cell's cost and that together.
   */
  estimate: 27,
} as const

/** One of EVENT. */
export type EventKind = (typeof EVENT)[keyof typeof EVENT]

/** The names of the kinds in EVENT, each at the place of its number. */
export const EVENT_NAMES = Object.keys(EVENT) as readonly (keyof typeof EVENT)[]

/**
 * How a run ends. `unreachable` is a proof that no path exists; `not-found` only says that this
 * planner gave up; `loop` that the same state came back.
 */
export const STATUSES = [
  'reached',
  'unreachable',
  'not-found',
  'local-minimum',
  'dead-end',
  'loop',
] as const

/** One of STATUSES. */
export type Status = (typeof STATUSES)[number]

/**
 * Why a rover leaves a boundary: it meets the m-line; it is where the boundary is nearest to the goal;
 * a step of the simplest path is free; or it has a place in reach that is nearer to the goal.
 */
export const LEAVES = ['m-line', 'nearest', 'free-step', 'place-in-reach'] as const

/** One of LEAVES. */
export type Leave = (typeof LEAVES)[number]
