import { mapsOf, type Results } from '../../experiments/results'
import {
  type ExperimentSettings,
  GIVEN_MAPS,
  type GivenMap,
  plannerSettings,
  settingName,
} from '../../experiments/settings'
import { groupBy } from '../../experiments/summary/groups'
import { durationInWords } from '../../experiments/time-left'
import { withoutErrors } from '../state/messages'
import { countInWords, numberInWords } from '../words/numbers'
import { type Draft, draftOf, type Entry, type List, newEntry } from './draft'
import { checkDraft } from './faults'
import type { PageState, Run } from './state'

/** An edit that the form shows already, because it was made there. */
export const edit = (state: PageState, change: Partial<Draft>): PageState => {
  const draft = { ...state.draft, ...change }
  return { ...state, draft, checked: checkDraft(draft) }
}

/** A change for which the form has to be made anew. */
const remake = (state: PageState, change: Partial<Draft>): PageState => ({
  ...edit(state, change),
  formMade: state.formMade + 1,
})

export const openSettings = (state: PageState, settings: ExperimentSettings): PageState => ({
  ...remake(state, draftOf(settings)),
  messages: withoutErrors(state.messages),
})

type Group = 'families' | 'planners'

export const addEntry = (state: PageState, group: Group, id: string): PageState =>
  remake(state, { [group]: [...state.draft[group], newEntry(id)] })

export const removeEntry = (state: PageState, group: Group, key: number): PageState =>
  remake(state, { [group]: state.draft[group].filter((entry) => entry.key !== key) })

export const editList = (
  state: PageState,
  group: Group,
  key: number,
  name: string,
  list: List,
): PageState =>
  edit(state, {
    [group]: withEntry(state.draft[group], key, (entry) => ({
      ...entry,
      lists: { ...entry.lists, [name]: list },
    })),
  })

/** Adds maps to the family of opened maps, which is made if there is none. */
export function addMaps(state: PageState, maps: readonly GivenMap[]): PageState {
  const { families } = state.draft
  const own = families.find(({ id }) => id === GIVEN_MAPS)
  if (!own) return remake(state, { families: [...families, newEntry(GIVEN_MAPS, {}, maps)] })
  const added = (entry: Entry) => ({ ...entry, maps: [...entry.maps, ...maps] })
  return remake(state, { families: withEntry(families, own.key, added) })
}

const withEntry = (
  entries: readonly Entry[],
  key: number,
  change: (entry: Entry) => Entry,
): Entry[] => entries.map((entry) => (entry.key === key ? change(entry) : entry))

export const runStarted = (state: PageState, total: number): PageState => ({
  ...state,
  run: { kind: 'running', done: 0, total, left: null },
  messages: withoutErrors(state.messages),
  said: `Running ${countInWords(total, 'map')}.`,
})

export function runProgressed(state: PageState, done: number, left: number | null): PageState {
  const { run } = state
  if (run.kind !== 'running') return state
  const quarter = (maps: number) => Math.floor((4 * maps) / run.total)
  const isNews = quarter(done) > quarter(run.done) && done < run.total
  const said = isNews ? progressInWords({ ...run, done, left }) : state.said
  return { ...state, run: { ...run, done, left }, said }
}

/** "1,200 of 10,000 maps, 3 min 20 s left". */
export function progressInWords({ done, total, left }: Extract<Run, { kind: 'running' }>): string {
  const maps = `${numberInWords(done)} of ${countInWords(total, 'map')}`
  return left === null ? maps : `${maps}, ${durationInWords(left)} left`
}

/**
 * Shows results, of all maps or of some: a run may have been cancelled, and of a file rows may have been
 * taken out. A run goes on meanwhile.
 */
export function showResults(state: PageState, results: Results): PageState {
  const { rows } = results
  const { first, end } = mapsOf(results)
  const maps = rows.filter(({ map }, i) => map !== rows[i - 1]?.map).length
  const last = rows.at(-1)?.map ?? -1
  const text = `Results of ${countInWords(maps, 'map')}.`
  return {
    ...state,
    shown: { results, maps, areFirst: last === first + maps - 1, total: end - first },
    hidden: namesLeftOut(results.settings),
    said: text,
  }
}

/** Nobody can follow more lines than this. */
const MOST_SERIES = 14

/**
 * The series that are hidden at first: none, or if there are too many, all but the first of each planner
 * with more than two.
 */
function namesLeftOut(settings: ExperimentSettings): ReadonlySet<string> {
  const all = plannerSettings(settings)
  if (all.length <= MOST_SERIES) return new Set()
  const left = [...groupBy(all, ({ planner }) => planner).values()].flatMap((own) =>
    own.length > 2 ? own.slice(1) : [],
  )
  return new Set(left.map(settingName))
}

/** A run that ended before its first map leaves the results of the one before. */
export const runEnded = (state: PageState, results: Results): PageState => ({
  ...(results.rows.length > 0
    ? showResults(state, results)
    : { ...state, said: 'No map was done.' }),
  run: { kind: 'idle' },
})

export function toggleSeries({ hidden, ...state }: PageState, name: string): PageState {
  const next = new Set(hidden)
  if (!next.delete(name)) next.add(name)
  return { ...state, hidden: next }
}
