import type { Param, ParamSettings } from '../../src/index'
import type { Dice } from './random'

/** Any values that a planner declares to be possible, so that a new planner is tested too. */
export function anySettings(
  params: readonly Param[],
  dice: Dice,
): Record<string, ParamSettings[string]> {
  return Object.fromEntries(params.map((param) => [param.name, anyValue(param, dice)]))
}

function anyValue(param: Param, dice: Dice): number | string | boolean {
  switch (param.kind) {
    case 'boolean':
      return dice.onceIn(2)
    case 'choice':
      return dice.pick(param.choices)
    default: {
      // The first few: they are the ones that are used, and large ones take long.
      const most = Math.min(param.max, param.min + dice.pick([3, 3, 3, 12]))
      return param.kind === 'integer'
        ? dice.between(param.min, most)
        : param.min + (most - param.min) * (dice.below(1000) / 1000)
    }
  }
}
