import fc from 'fast-check'

fc.configureGlobal({
  // It would choose a seed anew each time; a run that can be repeated is worth more.
  seed: Number(process.env.SEED),
  // Lists as long as they may be: else a list of at most 60 has four entries, most of the time.
  defaultSizeToMaxWhenMaxSpecified: true,
})
