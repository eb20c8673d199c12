import { InputError } from '../grid/errors'
import { cellName } from '../grid/grid'
import { firstIllegalStep, measurePath, type PathMeasure } from '../grid/path'
import { checkProblem, type Problem } from '../grid/problem'
import { randomNumbers } from '../grid/random'
import { DriveNotes } from '../rover/drive-notes'
import { SimulatedRover } from '../rover/simulated-rover'
import { EVENT, STATUSES, type Status } from '../trace/events'
import { Tape } from '../trace/tape'
import { diagonalCost } from './costs'
import { completeParams, type ParamSettings } from './params'
import type { Answer, AnyPlanner, Context, Values } from './planner'
import { planners } from './planners'

/** How to plan. All of it may be left out. */
export interface PlanOptions {
  readonly params?: ParamSettings
  /** Seed of all that is random; 1 if none is given. A whole number. */
  readonly seed?: number
  /** To be filled with what the planner does. */
  readonly tape?: Tape
  /** Called now and then by work that takes long, with what is done, from 0 to 1. It may not plan. */
  readonly progress?: (done: number) => void
}

/** What came of a plan. */
export interface Outcome {
  readonly status: Status
  /** One sentence: how it ended, or what the proof is. */
  readonly reason: string
  /** From start to goal if the status is `reached`, else the cells walked so far. */
  readonly path: Int32Array
  /** Cost of `path`, each step 1, or √2 for a diagonal one if the parameter `cost` is `euclidean`. */
  readonly cost: number
  readonly measure: PathMeasure
  /** Cells (or roadmap vertices) whose shortest path became final; 0 for planners without search. */
  readonly expanded: number
  /** Cells of the map that the rover sensed; 0 for planners that see the whole map. */
  readonly sensed: number
}

/** @throws InputError if there is no such planner. */
export function plannerById(id: string): AnyPlanner {
  const planner = planners.find((candidate) => candidate.id === id)
  if (planner) return planner
  const known = planners.map((candidate) => candidate.id).join(', ')
  throw new InputError(`There is no planner "${id}" (there are: ${known}).`)
}

/** Searches share their working memory, so that no two of them may go on at the same time. */
let isUnderWay = false

/**
 * Checks the problem and the parameters, runs the planner, and checks what it answers.
 * @throws InputError that says what is wrong with the problem, the planner or a parameter, and where.
 */
export function plan(problem: Problem, plannerId: string, options: PlanOptions = {}): Outcome {
  if (isUnderWay) throw new InputError('Another plan is under way: its "progress" may not plan.')
  checkProblem(problem)
  const planner = plannerById(plannerId)
  const params = completeParams(planner, options.params ?? {}, problem)
  const { seed = 1, tape, progress = () => {} } = options
  if (!Number.isSafeInteger(seed)) throw new InputError(`The seed ${seed} is not a whole number.`)
  if (tape !== undefined && !(tape instanceof Tape)) throw new InputError('The tape is no Tape.')
  // Without that parameter every step counts the same.
  const costOfSteps = params.cost === 'euclidean' ? 'euclidean' : 'cells'
  tape?.begin(problem.grid.width, problem.grid.height, diagonalCost(costOfSteps))
  const context = { params, random: randomNumbers(seed), tape, progress }
  isUnderWay = true
  let answer: ReturnType<typeof run>
  try {
    answer = run(problem, planner, context)
  } finally {
    isUnderWay = false
  }
  const { status, reason, path, expanded, sensed } = answer
  checkAnswer(problem, planner, params, answer)
  tape?.write(EVENT.end, path.at(-1), STATUSES.indexOf(status))
  const measure = measurePath(problem.grid.width, path)
  const cost = costOfSteps === 'euclidean' ? measure.length : Math.max(0, path.length - 1)
  return { status, reason, path, cost, measure, expanded, sensed }
}

function run(
  problem: Problem,
  planner: AnyPlanner,
  context: Context<Values>,
): Answer & { sensed: number } {
  if (planner.family === 'offline') {
    // Spreading the answer would take longer than many a search.
    const { status, reason, path, expanded } = planner.plan(problem, context)
    return { status, reason, path, expanded, sensed: 0 }
  }
  const rover = new SimulatedRover(problem, planner.sensor(context.params), context.tape)
  const { status, reason } = planner.drive(rover, {
    params: context.params,
    notes: new DriveNotes(rover, context.tape),
  })
  return { status, reason, path: rover.trail(), expanded: 0, sensed: rover.sensed }
}

/** A planner that answers what is not true has a bug: better no answer than a wrong one. */
function checkAnswer(problem: Problem, planner: AnyPlanner, params: Values, answer: Answer): void {
  const { path, status } = answer
  const bug = (what: string) => new Error(`Bug in planner ${planner.id}: ${what}.`)
  if (path.length > 0 && path[0] !== problem.start)
    throw bug('the path does not begin at the start')
  const illegal = firstIllegalStep(problem, path)
  if (illegal > 0) {
    const { width } = problem.grid
    const step = `${cellName(width, path[illegal - 1])} to ${cellName(width, path[illegal])}`
    throw bug(`the step from ${step} is illegal`)
  }
  if ((status === 'reached') !== (path.at(-1) === problem.goal)) {
    throw bug(`it says ${status}, but the path ends elsewhere`)
  }
  if (status === 'unreachable' && !planner.complete(params)) {
    throw bug('it is not complete and says unreachable')
  }
}
