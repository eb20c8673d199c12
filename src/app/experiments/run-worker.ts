import type { Row } from '../../experiments/row'
import { runMap } from '../../experiments/run-map'
import type { ExperimentSettings } from '../../experiments/settings'
import { messageOf } from '../../grid/errors'
import type { Order, Report } from './protocol'

const clock = () => performance.now()

let settings: ExperimentSettings | null = null

self.onmessage = ({ data }: MessageEvent<Order>) => {
  if (data.kind === 'settings') {
    settings = data.settings
    return
  }
  if (!settings) throw new Error('Maps were ordered before there were settings.')
  const { range } = data
  const began = clock()
  const rows: Row[][] = []
  for (let map = range.first; map < range.end; map++) {
    try {
      rows.push(runMap(settings, map, clock))
    } catch (error) {
      return send({ kind: 'failed', message: `Map ${map}: ${messageOf(error)}` })
    }
  }
  send({ kind: 'done', range, rows, milliseconds: clock() - began })
}

const send = (report: Report): void => self.postMessage(report)
