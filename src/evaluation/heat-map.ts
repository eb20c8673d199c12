import { document, element, text } from './svg'

export interface HeatMap {
  readonly title: string
  /** What stands above the columns and beside the rows. */
  readonly columns: readonly string[]
  readonly rows: readonly string[]
  /** `shares[row][column]`, from 0 to 1. */
  readonly shares: readonly (readonly number[])[]
}

const CELL = { width: 78, height: 40 }
const LEFT = 120
const TOP = 76

/** Several maps side by side, each cell coloured by its share and labelled with it. */
export function heatMaps(
  title: string,
  columnLabel: string,
  rowLabel: string,
  maps: readonly HeatMap[],
): string {
  const mapWidth = CELL.width * maps[0].columns.length + 40
  const height = TOP + CELL.height * maps[0].rows.length + 20
  const parts = maps.flatMap((map, i) => drawMap(map, LEFT + i * mapWidth, columnLabel, i === 0))
  const label = text(12, TOP - 14, rowLabel)
  return document(LEFT + mapWidth * maps.length - 20, height, title, [label, ...parts])
}

function drawMap(map: HeatMap, left: number, columnLabel: string, isFirst: boolean): string[] {
  const middle = left + (CELL.width * map.columns.length) / 2
  const x = (column: number) => left + column * CELL.width
  const y = (row: number) => TOP + row * CELL.height
  return [
    text(middle, 22, map.title, 'middle', { 'font-weight': 'bold' }),
    text(middle, 42, columnLabel, 'middle'),
    ...map.columns.map((name, i) => text(x(i) + CELL.width / 2, TOP - 14, name, 'middle')),
    ...(isFirst ? map.rows.map((name, i) => text(left - 12, y(i) + 25, name, 'end')) : []),
    ...map.shares.flatMap((row, i) => row.map((share, k) => drawCell(x(k), y(i), share))),
  ]
}

/** From white to dark blue: told apart by lightness alone. */
function drawCell(x: number, y: number, share: number): string {
  const part = (dark: number) => Math.round(255 + (dark - 255) * share)
  const fill = `rgb(${part(0)} ${part(60)} ${part(120)})`
  const cell = element('rect', { x, y, width: CELL.width - 2, height: CELL.height - 2, fill })
  const ink = share > 0.5 ? '#ffffff' : '#333333'
  const words = `${Math.round(100 * share)} %`
  return `${cell}${text(x + CELL.width / 2, y + 25, words, 'middle', { fill: ink })}`
}
