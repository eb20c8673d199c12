import { blocks } from './blocks'
import type { Generator } from './generator'
import { maze } from './maze'
import { random } from './random'
import { rooms } from './rooms'

export type { Generator, GeneratorParam } from './generator'

/** All map generators. */
export const generators: readonly Generator[] = [random, blocks, rooms, maze]
