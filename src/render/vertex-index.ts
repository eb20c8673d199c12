import type { Cell } from '../grid/grid'
import type { Cells } from '../trace/frame'
import { BlockIndex } from './block-index'
import { boxInView, isVisible, MOST_IN_VIEW, type Placement, reachOf } from './placement'
import type { Indexer } from './sliced-index'
import type { Work } from './work'

/** So many vertices are taken in within a fraction of a frame. */
const AT_ONCE = 1 << 16

/** The vertices of a roadmap. Those on the screen are found quickly, even among millions. */
export class VertexIndex implements Indexer<VertexIndex> {
  readonly #blocks: BlockIndex
  #vertices: Cells = []

  constructor(columns: number, rows: number) {
    this.#blocks = new BlockIndex(columns, rows)
  }

  /** The index grows itself: what is in it so far can be shown meanwhile. */
  *take(vertices: Cells, length: number): Work<VertexIndex> {
    const blocks = this.#blocks
    this.#vertices = vertices
    while (blocks.length < length) {
      const to = Math.min(length, blocks.length + AT_ONCE)
      while (blocks.length < to) blocks.add(vertices[blocks.length])
      if (to < length) yield
    }
    return this
  }

  /** The vertices that can be seen; `null` if they are too many to be told apart. */
  inView(place: Placement): Cell[] | null {
    const box = boxInView(place, reachOf(place))
    if (this.#blocks.estimate(box) > MOST_IN_VIEW) return null
    const cells: Cell[] = []
    const vertices = this.#vertices
    this.#blocks.visit(box, (i) => {
      if (isVisible(place, vertices[i])) cells.push(vertices[i])
    })
    return cells
  }
}
