/**
 * What Posthoc's renderer draws: a primitive (`$`) with its properties. Texts in `${{ }}` are
 * expressions in which `$` is the event. What has `clear: true` is gone with the next event, with a
 * type when an event of that type and the same `id` comes; all else stays.
 */
type Component = Readonly<Record<string, unknown>>

/** The colours say the same as on the page; they must show on a light and on a dark ground. */
const COLOUR = {
  start: '#00bfa5',
  goal: '#f50057',
  open: '#ffd54f',
  current: '#ff7043',
  closed: '#90a4ae',
  path: '#2979ff',
  vertex: '#7e57c2',
  edge: '#9575cd',
  refused: '#e53935',
  passed: '#43a047',
  known: '#26c6da',
  obstacle: '#6d4c41',
  field: '#ab47bc',
  rover: '#304ffe',
  mLine: '#ec407a',
} as const

const expression = (text: string) => `\${{ ${text} }}`
const at = (name: string) => expression(`$.${name}`)
const middle = (name: string) => expression(`$.${name} + 0.5`)

/** The middle of the event's cell, between which Posthoc draws the way from the root to the event. */
export const posthocPivot = { x: middle('x'), y: middle('y'), scale: 1 }

const transient = { clear: true }

/** A square around the middle of the event's cell, as wide as a part of the cell's side. */
function square(fill: string, alpha: number, part = 1, more: object = {}): Component {
  const from = (name: string) =>
    part === 1 ? at(name) : expression(`$.${name} + ${(1 - part) / 2}`)
  return { $: 'rect', x: from('x'), y: from('y'), width: part, height: part, fill, alpha, ...more }
}

function dot(fill: string, radius: number, more: object = {}): Component {
  return { $: 'circle', x: middle('x'), y: middle('y'), radius, fill, alpha: 1, ...more }
}

function line(fill: string, more: object = {}): Component {
  const points = [
    { x: middle('x'), y: middle('y') },
    { x: middle('toX'), y: middle('toY') },
  ]
  return { $: 'path', points, 'line-width': 0.12, fill, alpha: 0.8, ...more }
}

/** A square in another cell than the event's, which the event may not have. */
function squareAt(x: string, y: string, fill: string): Component {
  const here = { x: at(x), y: at(y), width: 1, height: 1 }
  return { $: 'rect', $if: expression(`$.${x} >= 0`), ...here, fill, alpha: 0.6, ...transient }
}

/** The colour of one event that is so, and of one that is not. */
const either = (name: string, yes: string, no: string) =>
  expression(`$.${name} ? '${yes}' : '${no}'`)

/** How each type of event is drawn that is in a place. */
function drawings(width: number, highest: number): Record<string, readonly Component[]> {
  const share = expression(`$.value >= 0 ? 0.1 + 0.8 * Math.min(1, $.value / ${highest}) : 0.9`)
  const row = { $: 'rect', x: 0, y: at('y'), width, height: 1, fill: COLOUR.open, alpha: 0.4 }
  return {
    source: [square(COLOUR.start, 1)],
    destination: [square(COLOUR.goal, 1)],
    row: [{ ...row, ...transient }],
    test: [
      square(either('corner', COLOUR.passed, COLOUR.refused), 0.8, 1, transient),
      squareAt('obstacleX', 'obstacleY', COLOUR.obstacle),
    ],
    vertex: [dot(COLOUR.vertex, 0.3)],
    edge: [line(COLOUR.edge)],
    refuse: [line(COLOUR.refused, transient), squareAt('atX', 'atY', COLOUR.refused)],
    generating: [square(COLOUR.open, 0.8)],
    updating: [square(COLOUR.open, 0.8)],
    expanding: [square(COLOUR.current, 1, 1, { clear: 'closing' })],
    closing: [square(COLOUR.closed, 0.8)],
    path: [square(COLOUR.path, 0.9, 0.6)],
    attraction: [square(COLOUR.field, 0.6, 1, transient)],
    repulsion: [square(COLOUR.field, 0.6, 1, transient)],
    potential: [{ ...square(COLOUR.field, 1), alpha: share }],
    step: [square(COLOUR.path, 0.9, 0.5), dot(COLOUR.rover, 0.45, transient)],
    sense: [
      { ...square(COLOUR.known, 0.3), fill: either('obstacle', COLOUR.obstacle, COLOUR.known) },
    ],
    feel: [square(COLOUR.obstacle, 0.9)],
    'feel-outside': [dot(COLOUR.obstacle, 0.45, transient)],
    target: [dot(COLOUR.goal, 0.35, transient)],
    'target-outside': [dot(COLOUR.goal, 0.45, transient)],
    'm-line': [square(COLOUR.mLine, 0.8, 0.3)],
    hit: [dot(COLOUR.refused, 0.4), squareAt('obstacleX', 'obstacleY', COLOUR.refused)],
    leave: [dot(COLOUR.passed, 0.4)],
    around: [dot(COLOUR.current, 0.45, transient)],
    loop: [dot(COLOUR.mLine, 0.45)],
    scan: [dot(COLOUR.rover, 0.45, transient)],
    node: [dot(COLOUR.vertex, 0.35, transient)],
    'node-outside': [dot(COLOUR.vertex, 0.45, transient)],
    end: [dot(COLOUR.current, 0.3)],
  }
}

/**
 * The `views` of a trace: `main`, which Posthoc draws, calls one view for each type of event that
 * occurs in it, because it tries all that are there on each event.
 * @param types of the events that are in a place
 * @param width cells in a row of the map
 * @param highest the highest finite value of the potential
 */
export function posthocViews(
  types: ReadonlySet<string>,
  width: number,
  highest: number,
): Record<string, readonly Component[]> {
  const drawn = Object.entries(drawings(width, highest)).filter(([type]) => types.has(type))
  // Not called like the types, because a view called "path" would hide the primitive.
  const view = (type: string) => `draw-${type}`
  return {
    main: drawn.map(([type]) => ({ $: view(type), $if: expression(`$.type === '${type}'`) })),
    ...Object.fromEntries(drawn.map(([type, components]) => [view(type), components])),
  }
}
