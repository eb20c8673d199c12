import { messageOf } from '../../grid/errors'
import { type GeneratingAnswer, makeMap, type WantedMap } from './wanted-map'

self.onmessage = ({ data }: MessageEvent<WantedMap>) => {
  try {
    const problem = makeMap(data)
    send({ kind: 'generated', problem }, [problem.grid.walls.buffer])
  } catch (error) {
    send({ kind: 'refused', message: messageOf(error) })
  }
}

function send(message: GeneratingAnswer, buffers: ArrayBufferLike[] = []): void {
  self.postMessage(message, { transfer: buffers as ArrayBuffer[] })
}
