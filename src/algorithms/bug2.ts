import { stepped } from '../grid/directions'
import { isSamePlace, type Point, placeName } from '../grid/grid'
import { indexOnSimplestPath, simplestStep } from '../grid/simplest-path'
import type { DriveNotes } from '../rover/drive-notes'
import { afterSteps, boxedIn, hitObstacle, turnParam } from './boundary'
import { onlinePlanner } from './planner'
import { pseudocode } from './pseudocode'

const { text, line } = pseudocode({
  mLine: 'm-line ← the simplest path from start to goal',
  follow: 'follow the m-line towards the goal',
  hit: 'if an obstacle refuses a step at the i-th cell of the m-line: here is a hit point',
  loop: 'if it was a hit point before: the rover goes round for ever',
  around:
    'follow the boundary until the m-line is met at another cell (closer: further along than i)',
  closed:
    'if it comes round without one: closer proves the goal unreachable, report goes round for ever',
  leave: 'leave there and follow the m-line again',
  reached: 'as soon as the goal is met: done',
})

const INDEX = 0
const HIT_INDEX = 1

export const bug2 = onlinePlanner({
  id: 'bug2',
  title: 'Bug2',
  summary:
    'Follows the m-line, the simplest path from start to goal; at an obstacle it follows the boundary until it meets the m-line again.',
  promise:
    'With leave closer complete: it arrives whenever there is a path, and else proves that there is none. With leave report it can go round for ever, and says so.',
  complete: ({ leave }) => leave === 'closer',
  optimal: () => false,
  params: [
    {
      name: 'leave',
      label: 'Leave the boundary',
      kind: 'choice',
      choices: ['report', 'closer'],
      default: 'report',
      help: 'report: at any other cell of the m-line; closer: only further along it (Lumelsky and Stepanov).',
    },
    turnParam,
  ],
  variables: ['cell of the m-line', 'cell of the m-line at the hit point'],
  pseudocode: text,
  source:
    'Report, IV.E.2 and Algorithm 2; V. J. Lumelsky and A. A. Stepanov, "Path-planning strategies for a point mobile automaton moving amidst unknown obstacles of arbitrary shape", 1987',
  sensor: () => ({ range: 1, lineOfSight: false }),

  drive(rover, { params, notes }) {
    const { goal } = rover
    const start = rover.position
    const isAtGoal = () => isSamePlace(rover.position, goal)
    const mLineIndex = () => indexOnSimplestPath(start, goal, rover.position)
    const mayLeave = (met: number, hit: number) =>
      params.leave === 'closer' ? met > hit : met >= 0 && met !== hit
    const stepsAtHit = new Map<number, number>()
    noteMLine(start, goal, notes.at(line.mLine))
    notes.value(INDEX, 0)
    rover.sense()
    while (!isAtGoal()) {
      const ahead = simplestStep(rover.position, goal)
      notes.at(line.follow)
      if (rover.step(ahead)) {
        rover.sense()
        notes.value(INDEX, mLineIndex())
        continue
      }
      const hitPoint = rover.position
      const hit = mLineIndex()
      const before = stepsAtHit.get(hit)
      if (before !== undefined) {
        notes.at(line.loop).loop(before)
        const reason = `hit point ${placeName(hitPoint)} again, in the same state as ${afterSteps(before)}`
        return { status: 'loop', reason }
      }
      stepsAtHit.set(hit, rover.steps)
      const walk = hitObstacle(rover, ahead, params.turn, notes.at(line.hit))
      notes.value(HIT_INDEX, hit)
      const isProof = params.leave === 'closer'
      if (walk.isBoxedIn) return boxedIn(isProof ? 'unreachable' : 'dead-end', hitPoint)
      notes.at(line.around)
      do {
        walk.step()
        notes.value(INDEX, mLineIndex())
        if (walk.isAround) {
          notes.at(line.closed).around(walk.taken.length)
          const reason = `went round the obstacle once from hit point ${placeName(hitPoint)} without meeting the m-line again`
          if (!isProof) notes.loop(rover.steps - walk.taken.length)
          return isProof
            ? { status: 'unreachable', reason: `${reason} further along` }
            : {
                status: 'loop',
                reason: `${reason}, so the state ${afterSteps(rover.steps - walk.taken.length)} came back`,
              }
        }
      } while (!mayLeave(mLineIndex(), hit))
      if (!isAtGoal()) notes.at(line.leave).leave('m-line')
    }
    notes.at(line.reached)
    return { status: 'reached', reason: 'the rover is at the goal' }
  },
})

function noteMLine(start: Point, goal: Point, notes: DriveNotes): void {
  for (let place = start; ; place = stepped(place, simplestStep(place, goal))) {
    notes.mLine(place)
    if (isSamePlace(place, goal)) return
  }
}
