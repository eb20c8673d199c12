import { withEndsMadeFree } from './ends-made-free'
import { generator } from './generator'

export const random = generator({
  id: 'random',
  title: 'Random obstacles',
  help: 'Every cell is an obstacle with the same chance, whatever its neighbours are.',
  params: [
    {
      name: 'density',
      label: 'Density',
      kind: 'integer',
      min: 0,
      max: 90,
      default: 25,
      unit: '%',
      help: 'Share of the cells that are obstacles; from about 40 % the goal is mostly cut off.',
    },
  ],

  build(size, { density }, random) {
    const walls = new Uint8Array(size.width * size.height)
    for (let i = 0; i < walls.length; i++) walls[i] = random() * 100 < density ? 1 : 0
    return withEndsMadeFree(size, walls)
  },
})
