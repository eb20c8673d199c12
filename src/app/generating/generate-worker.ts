import { answerWithMap } from '../files/map-worker'
import { makeMap, type WantedMap } from './wanted-map'

answerWithMap((wanted: WantedMap) => ({ problem: makeMap(wanted), notes: [] }))
