import { openMap } from '../../grid/formats/open-map'
import { answerWithMap } from './map-worker'

answerWithMap(async (file: Blob) => openMap(await file.text()))
