import type { DiagonalRule } from '../../grid/steps'

export const DIAGONAL_RULE_WORDS: Readonly<
  Record<DiagonalRule, { readonly title: string; readonly help: string }>
> = {
  'if-at-most-one-obstacle': {
    title: 'If at most one obstacle',
    help: 'Legal unless both cells beside the step are obstacles (PathFinding.js: IfAtMostOneObstacle).',
  },
  'only-when-no-obstacles': {
    title: 'Only when no obstacles',
    help: 'Legal only if both cells beside the step are free (PathFinding.js: OnlyWhenNoObstacles).',
  },
}
