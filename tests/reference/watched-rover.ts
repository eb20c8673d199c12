import type { Grid, Problem } from '../../src/index'
import { SimulatedRover } from '../../src/rover/simulated-rover'
import { must } from './cases'
import { steps, type XY } from './world'

type SensorSettings = ConstructorParameters<typeof SimulatedRover>[1]

/** A rover that is told on: each cell of the map that is read, and each place it senses from. */
export class WatchedRover extends SimulatedRover {
  readonly #sensedFrom: XY[] = []

  /** The places from which it sensed, in turn. */
  sensedFrom(): readonly XY[] {
    return this.#sensedFrom
  }

  override sense(): void {
    this.#sensedFrom.push([this.position.x, this.position.y])
    super.sense()
  }
}

/**
 * A rover on a map whose every reading is watched: to read a cell outside the square that it can
 * sense from where it is at that moment is a fault, and so is to read the map in any other way.
 */
export function watchedRover(problem: Problem, sensor: SensorSettings): WatchedRover {
  const { width } = problem.grid
  let rover: WatchedRover | undefined
  const onRead = (cell: number): void => {
    const from = rover?.position ?? {
      x: problem.start % width,
      y: Math.floor(problem.start / width),
    }
    const place: XY = [cell % width, Math.floor(cell / width)]
    const distance = steps([from.x, from.y], place)
    must(
      distance <= sensor.range,
      () => `(${place}) was read from (${from.x},${from.y}), range ${sensor.range}`,
    )
  }
  rover = new WatchedRover({ ...problem, grid: watchedGrid(problem.grid, onRead) }, sensor)
  return rover
}

function watchedGrid(grid: Grid, onRead: (cell: number) => void): Grid {
  const refuse = (): never => {
    throw new Error('the map was read other than cell by cell')
  }
  const walls = new Proxy(grid.walls, {
    get(target, key) {
      if (key === 'length') return target.length
      if (typeof key !== 'string' || !/^\d+$/.test(key)) return refuse()
      onRead(Number(key))
      return target[Number(key)]
    },
    has: refuse,
    ownKeys: refuse,
    getOwnPropertyDescriptor: refuse,
  })
  return { ...grid, walls }
}

/** All that properties lead to from an object, getters and prototypes included. */
export function reachableFrom(root: object): Set<unknown> {
  const seen = new Set<unknown>()
  const waiting: unknown[] = [root]
  while (waiting.length > 0) {
    const value = waiting.pop()
    const isObject = (typeof value === 'object' && value !== null) || typeof value === 'function'
    if (!isObject || seen.has(value)) continue
    seen.add(value)
    for (let owner: object | null = value; owner; owner = Reflect.getPrototypeOf(owner)) {
      for (const key of Reflect.ownKeys(owner)) {
        const { value: held, get } = Reflect.getOwnPropertyDescriptor(owner, key) ?? {}
        waiting.push(held, get && owner !== Function.prototype ? readGetter(value, get) : undefined)
      }
    }
  }
  return seen
}

function readGetter(receiver: object, get: () => unknown): unknown {
  try {
    return get.call(receiver)
  } catch {
    // A getter of some built-in object that is not for this receiver.
    return undefined
  }
}
