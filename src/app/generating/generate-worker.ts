import { messageOf } from '../../grid/errors'
import { send } from '../planning/asked-worker'
import { type GeneratingAnswer, makeMap, type WantedMap } from './wanted-map'

self.onmessage = ({ data }: MessageEvent<WantedMap>) => {
  try {
    const problem = makeMap(data)
    send<GeneratingAnswer>({ kind: 'generated', problem }, [problem.grid.walls.buffer])
  } catch (error) {
    send<GeneratingAnswer>({ kind: 'refused', message: messageOf(error) })
  }
}
