import fc from 'fast-check'

// fast-check would choose a seed anew each time; a run that can be repeated is worth more.
fc.configureGlobal({ seed: Number(process.env.SEED) })
