import { expect, test } from 'vitest'
import { planners } from '../../src/index'
import { DriveNotes } from '../../src/rover/drive-notes'
import { LONG, must, onEveryMap } from '../reference/cases'
import { Dice } from '../reference/random'
import { anySettings } from '../reference/settings'
import { canSee } from '../reference/sight'
import { reachableFrom, type WatchedRover, watchedRover } from '../reference/watched-rover'
import {
  DIRECTIONS,
  isLegal,
  isWall,
  problemOf,
  steps,
  type World,
  type XY,
} from '../reference/world'

/** Known is what was in the square around a place it sensed from, and in sight from there. */
function mustKnowOnlyWhatItSensed(
  world: World,
  rover: WatchedRover,
  lineOfSight: boolean,
  name: string,
): void {
  const expected = new Map<string, string>()
  const places = new Map(rover.sensedFrom().map((place) => [String(place), place]))
  for (const from of places.values()) {
    for (let y = from[1] - rover.range; y <= from[1] + rover.range; y++) {
      for (let x = from[0] - rover.range; x <= from[0] + rover.range; x++) {
        if (lineOfSight && !canSee(world, from, [x, y])) continue
        expected.set(`${x},${y}`, isWall(world, x, y) ? 'obstacle' : 'free')
      }
    }
  }
  const rim = rover.range + 2
  for (let y = -rim; y < world.height + rim; y++) {
    for (let x = -rim; x < world.width + rim; x++) {
      const known = rover.known(x, y)
      const right = expected.get(`${x},${y}`) ?? 'unknown'
      must(known === right, () => `${name}: (${x},${y}) is known as ${known}, not as ${right}`)
    }
  }
}

test('no online planner ever reads outside the sensed square', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const dice = new Dice(3, index)
    for (const planner of planners) {
      if (planner.family !== 'online') continue
      const params = anySettings(planner.params, dice)
      const name = `${planner.id} ${JSON.stringify(params)}`
      const sensor = planner.sensor(params)
      const rover = watchedRover(problemOf(world), sensor)
      planner.drive(rover, { params, notes: new DriveNotes(rover) })
      mustKnowOnlyWhatItSensed(world, rover, sensor.lineOfSight, name)
    }
  })
})

test('the Bugs feel no farther than range 1', () => {
  for (const id of ['bug1', 'bug2']) {
    const bug = planners.find((planner) => planner.id === id)
    if (bug?.family !== 'online') throw new Error(`${id} is not online`)
    expect(bug.sensor({})).toEqual({ range: 1, lineOfSight: false })
  }
})

test('the rover takes legal steps and refuses all others', { timeout: LONG }, async () => {
  await onEveryMap((world, index) => {
    const dice = new Dice(4, index)
    const sensor = { range: dice.between(1, 6), lineOfSight: dice.onceIn(2) }
    const rover = watchedRover(problemOf(world), sensor)
    for (let d = 0; d < 8; d++) must(!rover.step(d), () => 'it steps before it has sensed anything')
    const trail: XY[] = [world.start]
    for (let moves = 0; moves < 25; moves++) {
      rover.sense()
      const { x, y } = rover.position
      const legal = DIRECTIONS.map(([dx, dy]) => isLegal(world, [x, y], [x + dx, y + dy]))
      const offered = DIRECTIONS.map((_, d) => ((rover.legalSteps() >> d) & 1) === 1)
      must(String(offered) === String(legal), () => `steps ${offered} from (${x},${y})`)
      const felt = DIRECTIONS.map((_, d) => ((rover.obstaclesAround() >> d) & 1) === 1)
      const walls = DIRECTIONS.map(([dx, dy]) => isWall(world, x + dx, y + dy))
      must(String(felt) === String(walls), () => `obstacles ${felt} around (${x},${y})`)
      const d = dice.below(8)
      const [dx, dy] = DIRECTIONS[d]
      must(rover.step(d) === legal[d], () => `step ${d} from (${x},${y})`)
      if (legal[d]) trail.push([x + dx, y + dy])
      const at: XY = [rover.position.x, rover.position.y]
      must(String(at) === String(trail[trail.length - 1]), () => `it is at ${at} after ${trail}`)
    }
    must(rover.steps === trail.length - 1, () => `${rover.steps} steps counted on ${trail}`)
    mustKnowOnlyWhatItSensed(world, rover, sensor.lineOfSight, JSON.stringify(sensor))
  })
})

const ROOM: World = {
  width: 9,
  height: 9,
  rows: [
    '.........',
    '.........',
    '....#....',
    '.........',
    '.........',
    '.........',
    '..###....',
    '.........',
    '.........',
  ],
  start: [4, 4],
  goal: [0, 0],
  rule: 'if-at-most-one-obstacle',
}

test('obstacles hide what is behind them', () => {
  const rover = watchedRover(problemOf(ROOM), { range: 4, lineOfSight: true })
  rover.sense()
  const seen = Array.from({ length: 9 }, (_, y) =>
    Array.from({ length: 9 }, (_, x) => rover.known(x, y)[0]).join(''),
  )
  // The letters of unknown, free and obstacle. Half a cell's shadow grows behind each wall.
  expect(seen).toEqual([
    'ffffuffff',
    'ffffuffff',
    'ffffoffff',
    'fffffffff',
    'fffffffff',
    'fffffffff',
    'ffoooffff',
    'fuuuuffff',
    'uuuuuffff',
  ])
})

test('nothing that a planner is handed leads to the map', () => {
  const problem = problemOf(ROOM)
  const rover = watchedRover(problem, { range: 2, lineOfSight: false })
  const notes = new DriveNotes(rover)
  for (const handed of [rover, notes]) {
    for (const value of reachableFrom(handed)) {
      expect(value).not.toBe(problem)
      expect(value).not.toBe(problem.grid)
      expect(ArrayBuffer.isView(value)).toBe(false)
      expect(value).not.toHaveProperty('walls')
    }
  }
  // The search does find what lies open.
  expect(reachableFrom({ in: { problem } })).toContain(problem.grid.walls)
})

test('who peeks is caught', () => {
  const far = watchedRover(problemOf(ROOM), { range: 1, lineOfSight: false })
  Object.defineProperty(far, 'range', { value: 2 })
  expect(() => far.sense()).toThrow('was read from (4,4), range 1')
})

test('the square is as wide as the range says', () => {
  for (const range of [1, 2, 3, 7]) {
    const rover = watchedRover(problemOf(ROOM), { range, lineOfSight: false })
    rover.sense()
    for (let y = 0; y < 9; y++) {
      for (let x = 0; x < 9; x++) {
        expect(rover.known(x, y) !== 'unknown').toBe(steps([4, 4], [x, y]) <= range)
      }
    }
  }
})
