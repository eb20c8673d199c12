import 'materialize-css/dist/css/materialize.min.css'
import './app/styles/page.css'
import { startApp } from './app/app'

startApp()
