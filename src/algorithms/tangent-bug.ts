import { turnParam } from './boundary'
import { onlinePlanner } from './planner'
import { driveClassic } from './tangent-bug-classic'
import { text } from './tangent-bug-lines'
import { driveAsInReport } from './tangent-bug-report'

export const tangentBug = onlinePlanner({
  id: 'tangent-bug',
  title: 'Tangent Bug',
  summary:
    'Senses obstacles before it touches them: it heads for the end of the obstacle that promises the shortest way, and follows the boundary where none gets it nearer.',
  promise:
    'The classic variant is complete for every sensor range: it arrives whenever there is a path, and else proves that there is none. The report’s variant often walks less than Bug2, but can go round for ever, and says so.',
  complete: ({ variant }) => variant === 'classic',
  optimal: () => false,
  params: [
    {
      name: 'range',
      label: 'Sensor range',
      kind: 'integer',
      min: 1,
      max: 50,
      unit: 'cells',
      default: 2,
      help: 'The rover senses the square of so many cells around it.',
    },
    {
      name: 'variant',
      label: 'Variant',
      kind: 'choice',
      choices: ['report', 'classic'],
      default: 'report',
      help: 'report: its Algorithms 3 and 4; classic: Kamon, Rimon and Rivlin’s, with d_reach and d_followed.',
    },
    {
      ...turnParam,
      help: `${turnParam.help} Classic only: the report’s variant chooses for itself.`,
    },
    {
      name: 'lineOfSight',
      label: 'Line of sight',
      kind: 'boolean',
      default: false,
      help: 'Obstacles hide what is behind them from the sensor.',
    },
  ],
  variables: ['d_reach', 'd_followed'],
  pseudocode: text,
  source:
    'Report, IV.E.3 and Algorithms 3 and 4; I. Kamon, E. Rimon and E. Rivlin, "TangentBug: a range-sensor-based navigation algorithm", 1998',
  sensor: ({ range, lineOfSight }) => ({ range, lineOfSight }),

  drive(rover, { params, notes }) {
    return params.variant === 'classic'
      ? driveClassic(rover, params.turn, notes)
      : driveAsInReport(rover, notes)
  },
})
