import type { Row } from '../row'
import { type ExperimentSettings, plannerSettings, settingName } from '../settings'

/** Values in the order in which their keys come first. */
export function groupBy<Item, Key>(
  items: readonly Item[],
  keyOf: (item: Item) => Key,
): Map<Key, Item[]> {
  const groups = new Map<Key, Item[]>()
  for (const item of items) {
    const key = keyOf(item)
    const group = groups.get(key)
    if (group) group.push(item)
    else groups.set(key, [item])
  }
  return groups
}

/** The rows of each number, by increasing number. */
export function groupByNumber(
  rows: readonly Row[],
  numberOf: (row: Row) => number,
): (readonly [number, Row[]])[] {
  return [...groupBy(rows, numberOf)].sort(([a], [b]) => a - b)
}

/** The points of one planner setting, in a chart with a line for each. */
export interface Series<Point> {
  /** Number of the planner setting. */
  readonly setting: number
  readonly name: string
  readonly points: readonly Point[]
}

/** A series for each planner setting that has rows. */
export function seriesOf<Point>(
  settings: ExperimentSettings,
  rows: readonly Row[],
  pointsOf: (rows: readonly Row[]) => readonly Point[],
): Series<Point>[] {
  const names = plannerSettings(settings).map(settingName)
  return groupByNumber(rows, ({ setting }) => setting).map(([setting, own]) => ({
    setting,
    name: names[setting],
    points: pointsOf(own),
  }))
}
