import type { Problem } from '../../src/index'
import { must } from '../reference/cases'
import type { Component, PosthocEvent, Trace } from './posthoc-trace'

/** What a property says for an event, as Posthoc reckons it. */
function evaluate(property: unknown, event: PosthocEvent): unknown {
  if (Array.isArray(property)) return property.map((part) => evaluate(part, event))
  if (typeof property === 'object' && property !== null) {
    return Object.fromEntries(Object.entries(property).map(([k, v]) => [k, evaluate(v, event)]))
  }
  if (typeof property !== 'string') return property
  must(property !== '', () => 'Posthoc cannot read an empty text')
  const expression = /^\$\{\{ (.*) \}\}$/.exec(property)?.[1]
  if (expression === undefined) return property
  must(!expression.includes('}}'), () => `${property} ends too early`)
  let reckon = expressions.get(expression)
  if (!reckon) {
    reckon = new Function('$', `return ${expression}`) as (event: PosthocEvent) => unknown
    expressions.set(expression, reckon)
  }
  return reckon(event)
}

const expressions = new Map<string, (event: PosthocEvent) => unknown>()

const PRIMITIVES = ['rect', 'circle', 'path']

const shows = (component: Component, event: PosthocEvent) =>
  component.$if === undefined || evaluate(component.$if, event) === true

/** Every event in a place is drawn, by primitives that lie on the map and have all they need. */
export function mustBeDrawn({ grid }: Problem, { views, pivot, events }: Trace): void {
  for (const name of PRIMITIVES) must(!(name in views), () => `a view hides the primitive ${name}`)
  const used = new Set<string>()
  const isOn = ({ x, y }: { x?: unknown; y?: unknown }, width = 0, height = 0) =>
    Number(x) >= 0 &&
    Number(y) >= 0 &&
    Number(x) + width <= grid.width &&
    Number(y) + height <= grid.height
  for (const event of events) {
    const called = views.main.filter((component) => shows(component, event))
    must(event.x === undefined || called.length > 0, () => `${event.type} is not drawn`)
    if (event.x !== undefined) {
      const { x, y, scale } = evaluate(pivot, event) as Record<string, unknown>
      must(x === event.x + 0.5 && y === Number(event.y) + 0.5 && scale === 1, () => `pivot ${x}`)
    }
    for (const { $ } of called) {
      used.add(String($))
      for (const component of views[String($)]) {
        if (!shows(component, event)) continue
        const drawn = evaluate(component, event) as Component
        const shown = () => `${JSON.stringify(event)} is drawn as ${JSON.stringify(drawn)}`
        must(/^#[0-9a-f]{6}$/.test(String(drawn.fill)), shown)
        must(Number(drawn.alpha) > 0 && Number(drawn.alpha) <= 1, shown)
        if (drawn.$ === 'rect') {
          must(isOn(drawn, Number(drawn.width), Number(drawn.height)), shown)
        } else if (drawn.$ === 'circle') {
          must(isOn(drawn) && Number(drawn.radius) > 0, shown)
        } else {
          must(drawn.$ === 'path' && Number(drawn['line-width']) > 0, shown)
          const points = drawn.points as { x?: unknown; y?: unknown }[]
          must(points.length === 2 && points.every((point) => isOn(point)), shown)
        }
      }
    }
  }
  const idle = Object.keys(views).filter((name) => name !== 'main' && !used.has(name))
  must(idle.length === 0, () => `no event uses ${idle}`)
}
