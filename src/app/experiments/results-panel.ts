import type { Mark } from '../../charts/chart'
import type { ThemeName } from '../../charts/style'
import { csvInParts } from '../../experiments/results-csv'
import { jsonInParts } from '../../experiments/results-json'
import { messageOf } from '../../grid/errors'
import { byId, setText } from '../element'
import { fetchedPart } from '../fetched-part'
import { blobInSlices } from '../files/in-slices'
import { saveFiles } from '../files/save-files'
import { tell } from '../state/messages'
import type { Store } from '../state/store'
import { countInWords, numberInWords } from '../words/numbers'
import type { ChartsPanel } from './charts-panel'
import { showSummary } from './results-table'
import { runsDialog } from './runs-dialog'
import type { PageState, Shown } from './state'
import { summarize } from './summary-table'
import { toggleSeries } from './transitions'

/** Binds the results; returns what shows a state in them. */
export function resultsPanel(
  store: Store<PageState>,
): (state: PageState, theme: ThemeName) => void {
  const panel = byId('results', HTMLElement)
  const about = byId('results-about', HTMLParagraphElement)
  const table = byId('summary', HTMLTableElement)
  const openRuns = runsDialog()
  const charts = lazyCharts(store, (shown, mark) => openRuns(shown.results.settings, mark))
  bindDownloads(store)
  let seen: Shown | null = null

  return (state, theme) => {
    const { shown } = state
    panel.hidden = shown === null
    if (shown && shown !== seen) {
      const { settings, rows } = shown.results
      setText(about, aboutInWords(shown))
      showSummary(table, summarize(settings, rows), ({ name, failures }) =>
        openRuns(settings, {
          label: `${name}, goals that can be reached and were not`,
          runs: [{ title: 'Failed', rows: failures }],
        }),
      )
    }
    seen = shown
    charts(state, theme)
  }
}

function aboutInWords({ results: { settings, shard, rows }, ...shown }: Shown): string {
  const all = countInWords(shown.total, 'map')
  const some = `${shown.areFirst ? 'The first ' : ''}${numberInWords(shown.maps)} of ${all}`
  const part = shown.maps < shown.total ? some : all
  const whose = shard.of > 1 ? ` of shard ${shard.index}/${shard.of}` : ''
  return `${part}${whose}, ${countInWords(rows.length, 'run')}, seed ${settings.seed}.`
}

/** The charts, and the library that draws them, are loaded with the first results. */
function lazyCharts(store: Store<PageState>, opened: (shown: Shown, mark: Mark) => void) {
  const container = byId('charts', HTMLDivElement)
  let panel: { readonly shown: Shown; readonly charts: ChartsPanel } | null = null
  let asked: Shown | null = null

  const load = async (shown: Shown, theme: ThemeName) => {
    try {
      const { ChartsPanel } = await fetchedPart(import('./charts-panel'))
      if (store.state.shown !== shown) return
      panel?.charts.dispose()
      const charts = new ChartsPanel(container, shown.results, {
        opened: (mark) => opened(shown, mark),
        toggled: (series) => store.update((state) => toggleSeries(state, series)),
      })
      panel = { shown, charts }
      charts.show(theme, store.state.hidden)
    } catch (error) {
      store.update((state) =>
        tell(state, 'error', `The charts could not be drawn. ${messageOf(error)}`),
      )
    }
  }
  return ({ shown, hidden }: PageState, theme: ThemeName) => {
    if (!shown) return
    if (shown !== asked) {
      asked = shown
      void load(shown, theme)
    } else if (panel?.shown === shown) panel.charts.show(theme, hidden)
  }
}

function bindDownloads(store: Store<PageState>): void {
  const save = (id: string, ending: string, inParts: typeof csvInParts) => {
    byId(id, HTMLButtonElement).addEventListener('click', () => {
      const { shown } = store.state
      if (!shown) return
      const name = `path-planner-results.${ending}`
      void saveFiles(store, async ({ progress, signal }) => [
        { name, content: await blobInSlices(inParts(shown.results, progress), signal) },
      ])
    })
  }
  save('save-csv', 'csv', csvInParts)
  save('save-json', 'json', jsonInParts)
}
