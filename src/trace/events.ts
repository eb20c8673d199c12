/**
 * What can happen while a planner works. Every event has a cell, a second whole number and a
 * value; the comments say what they hold. -1 stands for "no cell" and for cells outside the map.
 */
export const EVENT = {
  /** A cell or vertex was reached: cell, parent cell, cost so far. */
  open: 0,
  /** Its shortest path is final: cell, -, cost. */
  close: 1,
  /** A vertex of the roadmap: cell. */
  vertex: 2,
  /** An edge of the roadmap, in a direction whose simplest path is free: cell, other cell, weight. */
  edge: 3,
  /** The potential of a cell: cell, -, potential. */
  potential: 4,
  /** The rover's sensor saw a cell for the first time: cell, 1 if it is an obstacle else 0. */
  sense: 5,
  /** The rover or the agent came to a cell, the start included: cell, cell before. */
  step: 6,
  /** An obstacle stopped the rover (hit point): cell, obstacle cell, its number from 1. */
  hit: 7,
  /** The rover left the boundary (leave point): cell, -, its number from 1. */
  leave: 8,
  /** The obstacle cell that the rover keeps at its side: cell. */
  feel: 9,
  /** Which way round: cell, 0 obstacle on the left, 1 on the right. */
  turn: 10,
  /** A cell of the m-line: cell. */
  mLine: 11,
  /** Where the rover is heading: cell, -, distance rover → cell → goal. */
  target: 12,
  /** A number that the planner decides by: -, which of its variables, its value. */
  value: 13,
  /** A cell of the path that was found, from start to goal: cell. */
  path: 14,
} as const

export type EventKind = (typeof EVENT)[keyof typeof EVENT]

export const EVENT_NAMES = Object.keys(EVENT) as readonly (keyof typeof EVENT)[]
