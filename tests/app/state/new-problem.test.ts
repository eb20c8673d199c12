import { describe, expect, it } from 'vitest'
import { emptyProblem, resizedProblem } from '../../../src/app/state/new-problem'
import { pointOf } from '../../../src/grid/grid'
import { checkProblem } from '../../../src/grid/problem'
import { problemFromText, problemToText } from '../../../src/grid/text-map'

const RULE = 'if-at-most-one-obstacle'

describe('new maps', () => {
  it.each([
    [2, 2],
    [2, 2048],
    [3, 7],
    [60, 40],
  ])(
    'of %d × %d cells are empty, with the start at the left and the goal at the right',
    (width, height) => {
      const problem = emptyProblem(width, height, RULE)
      checkProblem(problem)
      expect(problem.grid.walls.includes(1)).toBe(false)
      const [start, goal] = [problem.start, problem.goal].map((cell) => pointOf(width, cell))
      expect(start.x).toBeLessThan(goal.x)
      expect(start.x + goal.x).toBe(width - 1)
      const middle = Math.floor((height - 1) / 2)
      expect([start.y, goal.y]).toEqual([middle, middle])
    },
  )

  it('that are too small or too large are refused in words', () => {
    expect(() => emptyProblem(1, 5, RULE)).toThrow("The map's width is 1")
    expect(() => emptyProblem(5, 2049, RULE)).toThrow("The map's height is 2049")
  })

  it('keep the drawing where it was', () => {
    const drawn = problemFromText('S.#\n.G.')
    expect(problemToText(resizedProblem(drawn, 5, 3))).toBe('S.#..\n.G...\n.....\n')
  })

  it('move a start or goal that is cut off to the nearest free cell', () => {
    const drawn = problemFromText('..#S\n.#..\n...G')
    const cut = resizedProblem(drawn, 3, 2)
    checkProblem(cut)
    expect([cut.start, cut.goal]).toEqual([1, 5])
    // From the edge, not from where it was: of the cells around (1, 1) the first, above it.
    const below = resizedProblem(problemFromText('S..\n.#.\n.G.'), 3, 2)
    expect(below.goal).toBe(1)
  })

  it('without a free cell are refused in words', () => {
    const drawn = problemFromText('##S\n##G')
    expect(() => resizedProblem(drawn, 2, 2)).toThrow('no cell is free')
  })
})
