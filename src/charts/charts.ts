import type { Row } from '../experiments/row'
import type { ExperimentSettings } from '../experiments/settings'
import type { Chart } from './chart'
import { fieldChart } from './field-chart'
import { ratioChart } from './ratio-chart'
import { samplesChart } from './samples-chart'
import { successChart } from './success-chart'
import { timeChart } from './time-chart'

/** All charts of an experiment. */
export const chartsOf = (settings: ExperimentSettings, rows: readonly Row[]): Chart[] => [
  successChart(settings, rows),
  ratioChart(settings, rows),
  timeChart(settings, rows),
  samplesChart(rows),
  fieldChart(rows),
]
