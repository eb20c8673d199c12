import { describe, expect, it } from 'vitest'
import { problemFromText } from '../../src/grid/text-map'
import { dottedRows, latestEdge } from '../../src/render/drawing'
import { testedCells } from '../../src/render/layers/corner-test'
import { railAngle } from '../../src/render/layers/following'
import { EVENT } from '../../src/trace/events'
import { type Frame, firstFrame } from '../../src/trace/frame'
import { Tape } from '../../src/trace/tape'
import { kindsOf } from '../trace/written'
import { momentOf, sceneOf, tapeOf } from './scenes'

const problem = problemFromText('S....\n..#..\n....G')

describe('what is shown only while it is the current thing', () => {
  it('are the dots of the rows, while the map is made a graph', () => {
    const tape = tapeOf(problem, 'decomposition')
    const at = (time: number) => dottedRows(sceneOf(problem, { plan: momentOf(tape, time) }))
    const first = kindsOf(tape).indexOf(EVENT.row)
    expect([at(0), at(first), at(first + 1), at(first + 3)]).toEqual([0, 0, 1, 3])
    expect(at(kindsOf(tape).indexOf(EVENT.open))).toBe(0)
    expect(at(tape.length)).toBe(0)
    expect(dottedRows(sceneOf(problem))).toBe(0)
  })

  it('is the latest edge, until anything else happens', () => {
    const tape = tapeOf(problem, 'visibility-graph')
    const at = (time: number) =>
      Array.from(latestEdge(sceneOf(problem, { plan: momentOf(tape, time) })))
    const first = kindsOf(tape).indexOf(EVENT.edge)
    expect(at(first)).toEqual([])
    expect(at(first + 1)).toEqual([tape.cell(first), tape.other(first)])
    const last = kindsOf(tape).lastIndexOf(EVENT.edge)
    expect(at(last + 1)).toEqual([tape.cell(last), tape.other(last)])
    expect(at(last + 2)).toEqual([])
    expect(at(0)).toEqual([])
  })
})

describe('the three cells of a test for a corner', () => {
  it('are the diagonal one and those that touch both (report, Fig. 4)', () => {
    // On a map 5 cells wide, obstacle (2, 1), the cell north-west of it, and the one south-east.
    expect(testedCells(5, 1, 7).sort()).toEqual([1, 2, 6])
    expect(testedCells(5, 13, 7).sort((a, b) => a - b)).toEqual([8, 12, 13])
  })

  it('are all free if and only if the test says so', () => {
    const tape = tapeOf(problem, 'visibility-graph')
    let tests = 0
    for (let i = 0; i < tape.length; i++) {
      if (tape.kind(i) !== EVENT.test) continue
      tests++
      const cells = testedCells(5, tape.cell(i), tape.other(i))
      const free = cells.every((cell) => problem.grid.walls[cell] === 0)
      expect(free ? 1 : 0).toBe(tape.value(i))
    }
    expect(tests).toBe(4)
  })
})

describe('the rail beside a rover that follows a boundary', () => {
  const frameWith = (changes: Partial<Frame>): Frame => {
    const tape = new Tape()
    tape.begin(5, 5)
    return { ...firstFrame(tape), rover: 12, following: true, ...changes }
  }
  const degrees = (changes: Partial<Frame>, heading = 0) => {
    const turned = (railAngle(5, frameWith(changes), heading) * 180) / Math.PI
    return Math.round((turned + 360) % 360)
  }

  it('leads where the obstacle is on the left, or on the right', () => {
    // North, east, south and west of the rover: clockwise angles from east.
    expect([7, 13, 17, 11].map((atSide) => degrees({ atSide, turn: 0 }))).toEqual([0, 90, 180, 270])
    expect([7, 13, 17, 11].map((atSide) => degrees({ atSide, turn: 1 }))).toEqual([180, 270, 0, 90])
  })

  it('lies along the heading if the border of the map is at its side', () => {
    expect(degrees({ atSide: -1 }, Math.PI / 2)).toBe(90)
  })
})
