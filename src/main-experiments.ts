import 'materialize-css/dist/css/materialize.min.css'
import './app/styles/experiments-page.css'
import { startExperiments } from './app/experiments/page'

startExperiments()
