import { pseudocode } from './pseudocode'

/** Both variants of Tangent Bug in one list, so that each event's line is found in one place. */
export const { text, line } = pseudocode({
  start: 'sense the square around the start',
  report: 'variant report (Algorithms 3 and 4):',
  follow: '  follow the simplest path to the goal until it is blocked within range',
  loop: '  if the rover was blocked at this place before and has sensed nothing new since: it goes round for ever',
  end: '  end ← of the ends of the sensed obstacle in reach, the one with the least distance rover → end → goal',
  approach: '  go straight to that end',
  turn: '  turn to the side whose first step is nearer to the goal; if both are as near, the obstacle stays on the right',
  followBoundary:
    '  follow the boundary until a free step of the simplest path leads away, with the goal no farther than from the followed obstacle cell',
  closed: '  if that came round once: it goes round for ever',
  depart: '  else leave there and start over',
  classic: 'variant classic (Kamon, Rimon and Rivlin):',
  nodes: '  nodes ← the free way to the goal, and the ends of the sensed obstacles',
  target:
    '  target ← of the nodes nearer to the goal than the start, all targets reached and all obstacles followed before, the one with the least distance rover → node → goal',
  ahead:
    '  if there is none, but a step of the simplest path to the goal is free: target ← the cell it leads to',
  towards: '  motion to goal: a step towards the target',
  hit: '  if there is no target: follow the boundary of the obstacle in the way',
  around:
    '  while d_reach, the distance to the goal of the nearest free place in reach, is not less than d_followed, that of the nearest cell sensed of this obstacle (if equal, by Euclidean distance): a step along the boundary',
  unreachable: '  if that came round once: the goal is unreachable',
  leave: '  else leave for the place in reach and start over',
  reached: 'as soon as the goal is met: done',
})

/** The variables of Tangent Bug, as `value` events count them. */
export const D_REACH = 0
export const D_FOLLOWED = 1
