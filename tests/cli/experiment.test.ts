import { existsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import { describe, expect, test } from 'vitest'
import { mergeShards, readShards } from '../../src/cli/merge'
import { runMaps } from '../../src/cli/pool'
import { openResults, readSettings, runMap } from '../../src/index'
import { timeless } from '../experiments/settings'
import {
  pathOf,
  run,
  runInto,
  runOnto,
  runUntil,
  settingsFile,
  textOf,
  timelessText,
  useProgram,
} from './program'

useProgram()

/** Long enough to be broken off in the middle. */
const LONGER = { mapsPerCombination: 15 }
const lineCount = (text: string) => text.split('\n').length - 1

describe('the rows are the same', () => {
  test('as in this process, in the order of the maps', () => {
    const settings = settingsFile('small.json')
    const { status, stdout } = run(settings, '--workers', '3')
    expect(status).toBe(0)
    const results = openResults(stdout)
    const expected = Array.from({ length: 30 }, (_, map) => runMap(results.settings, map)).flat()
    expect(timeless(results.rows)).toEqual(timeless(expected))
    expect(results.rows.some(({ milliseconds }) => milliseconds > 0)).toBe(true)
  })

  test('with one thread as with three, printed as in a file', () => {
    const settings = settingsFile('small.json')
    const printed = run(settings, '--workers', '1').stdout
    expect(run(settings, '--workers', '3', '--out', 'three.jsonl').stdout).toBe('')
    expect(timelessText(textOf('three.jsonl'))).toBe(timelessText(printed))
  })

  test('in one run and merged from four shards, named in any order', () => {
    const settings = settingsFile('small.json')
    for (const index of [1, 2, 3, 4]) {
      expect(
        run(settings, '--shard', `${index}/4`, '--workers', '1', '--out', `${index}.jsonl`).status,
      ).toBe(0)
    }
    const files = ['3.jsonl', '1.jsonl', '4.jsonl', '2.jsonl']
    const nothing = { status: 0, stdout: '', stderr: '' }
    expect(run('--merge', ...files, '--out', 'merged.jsonl')).toEqual(nothing)
    const merged = textOf('merged.jsonl')
    expect(timelessText(merged)).toBe(timelessText(run(settings).stdout))
    expect(run('--merge', ...files).stdout).toBe(merged)
    expect(existsSync(pathOf('merged.jsonl.part'))).toBe(false)
  })

  test('in folders that were not there, of a run and of a merge', () => {
    const settings = settingsFile('small.json')
    expect(run(settings, '--out', join('new', 'folder', 'rows.jsonl')).status).toBe(0)
    const args = [join('new', 'folder', 'rows.jsonl'), '--out', join('other', 'merged.jsonl')]
    expect(run('--merge', ...args).status).toBe(0)
    expect(textOf('other/merged.jsonl')).toBe(textOf('new/folder/rows.jsonl'))
  })

  test('merged from more shards than there are maps', () => {
    const settings = settingsFile('tiny.json', { mapsPerCombination: 1 })
    const files = Array.from({ length: 12 }, (_, i) => `tiny-${i}.jsonl`)
    files.forEach((file, i) => {
      run(settings, '--shard', `${i + 1}/12`, '--workers', '1', '--out', file)
    })
    const { stdout, stderr } = run('--merge', ...files)
    expect(stderr).toBe('')
    expect(timelessText(stdout)).toBe(timelessText(run(settings).stdout))
  })

  test.each([
    ['SIGKILL', null, '', true],
    ['SIGINT', 130, 'The same command goes on from there.', false],
  ] as const)(
    'after a %s in the middle and another start',
    async (signal, status, words, leavesLock) => {
      const settings = settingsFile('longer.json', LONGER)
      const out = `${signal}.jsonl`
      const broken = await runUntil(60_000, signal, out, [settings, '--workers', '2'])
      expect(broken.status).toBe(status)
      expect(broken.stderr).toContain(words)
      expect(existsSync(pathOf(`${out}.lock`))).toBe(leavesLock)
      const before = lineCount(textOf(out))
      expect(before).toBeGreaterThan(1)
      expect(before).toBeLessThan(1 + 150 * 12)
      // Killed in the middle of a line, too.
      writeFileSync(pathOf(out), `${textOf(out)}{"map":`)
      expect(run(settings, '--out', out).status).toBe(0)
      expect(timelessText(textOf(out))).toBe(timelessText(run(settings).stdout))
    },
  )

  test('of a file that is complete: nothing is run again, and that is said', () => {
    const settings = settingsFile('small.json')
    const words = 'complete.jsonl is complete: nothing is left to run.\n'
    expect(run(settings, '--out', 'complete.jsonl').stderr).not.toContain(words)
    const before = textOf('complete.jsonl')
    expect(run(settings, '--out', 'complete.jsonl')).toEqual({
      status: 0,
      stdout: '',
      stderr: words,
    })
    expect(textOf('complete.jsonl')).toBe(before)
  })
})

describe('an output file with something else in it is refused and left as it is', () => {
  const refuse = (out: string, ...args: string[]) => {
    const before = textOf(out)
    const { status, stderr } = run(...args, '--out', out)
    expect(status).toBe(1)
    expect(textOf(out)).toBe(before)
    return stderr
  }

  test('a folder', () => {
    const { status, stderr } = run(settingsFile('small.json'), '--out', 'dist-lib')
    expect([status, stderr]).toEqual([1, 'dist-lib is no file.\n'])
  })

  test('by a merge, too; the rows of the same maps are written anew', () => {
    const small = settingsFile('small.json')
    run(small, '--out', 'whole.jsonl')
    const text = textOf('whole.jsonl')
    expect(refuse(small, '--merge', 'whole.jsonl')).toContain('has no rows of an experiment in it')
    run(settingsFile('other.json', { seed: 8 }), '--out', 'others.jsonl')
    expect(refuse('others.jsonl', '--merge', 'whole.jsonl')).toContain('has rows of other settings')
    run(small, '--out', 'again.jsonl')
    expect(run('--merge', 'whole.jsonl', '--out', 'again.jsonl').status).toBe(0)
    expect(textOf('again.jsonl')).toBe(text)
  })

  test('one that another run or merge writes to', () => {
    const small = settingsFile('small.json')
    run(small, '--out', 'busy.jsonl')
    writeFileSync(pathOf('busy.jsonl.lock'), String(process.pid))
    expect(refuse('busy.jsonl', small)).toContain(`process ${process.pid}, writes to busy.jsonl`)
    expect(refuse('busy.jsonl', '--merge', 'busy.jsonl')).toContain('writes to busy.jsonl')
  })

  test('rows of other settings, of another shard', () => {
    const small = settingsFile('small.json')
    run(small, '--shard', '1/2', '--out', 'half.jsonl')
    const other = settingsFile('other.json', { seed: 8 })
    expect(refuse('half.jsonl', other, '--shard', '1/2')).toContain('has rows of other settings')
    expect(refuse('half.jsonl', small)).toContain('has the rows of shard 1/2, not of shard 1/1')
  })

  test('a text, a line without an end, rows in the wrong place', () => {
    const small = settingsFile('small.json')
    writeFileSync(pathOf('text.txt'), 'Dear diary,\ntoday')
    expect(refuse('text.txt', small)).toContain('text.txt has no rows of an experiment in it')
    writeFileSync(pathOf('line.txt'), 'Dear diary')
    expect(refuse('line.txt', small)).toContain('line.txt has no rows of an experiment in it')
    run(small, '--out', 'gap.jsonl')
    const lines = textOf('gap.jsonl').split('\n')
    writeFileSync(pathOf('gap.jsonl'), [...lines.slice(0, 4), ...lines.slice(5)].join('\n'))
    expect(refuse('gap.jsonl', small)).toContain('gap.jsonl is damaged: line 5')
  })
})

describe('shards are only merged', () => {
  const shard = (part: string, name: string, fields: object = {}) => {
    run(settingsFile('part.json', fields), '--shard', part, '--workers', '1', '--out', name)
    return name
  }
  const fault = (...files: string[]) => {
    const { status, stderr } = run('--merge', ...files, '--out', 'never.jsonl')
    expect(status).toBe(1)
    expect(existsSync(pathOf('never.jsonl'))).toBe(false)
    return stderr
  }

  test('if all are there, once, complete, and of the same settings', () => {
    const [a, b] = [shard('1/2', 'a.jsonl'), shard('2/2', 'b.jsonl')]
    expect(fault(a)).toContain('Shard 2/2 is missing.')
    expect(fault(a, b, a)).toContain('a.jsonl and a.jsonl are both shard 1/2.')
    expect(fault(a, shard('2/3', 'c.jsonl'))).toContain(
      'a.jsonl is shard 1/2, but c.jsonl is shard 2/3.',
    )
    const other = shard('2/2', 'd.jsonl', { seed: 8 })
    expect(fault(a, other)).toContain('a.jsonl and d.jsonl are of different settings.')
    // Broken off before the end of the last line, which would join it with the first of the next.
    writeFileSync(pathOf(b), textOf(b).slice(0, -1))
    expect(fault(a, b)).toContain('b.jsonl is not complete: 1 of its 15 maps are missing.')
    writeFileSync(pathOf(b), textOf(b).slice(0, -1000))
    expect(fault(a, b)).toMatch(/b\.jsonl is (not complete: 1 of its 15 maps|damaged)|no JSON/)
    expect(fault(a, 'nowhere.jsonl')).toContain('nowhere.jsonl')
    writeFileSync(pathOf('empty.jsonl'), '')
    expect(fault(a, 'empty.jsonl')).toContain('empty.jsonl is empty.')
  })
})

test('a reader that has seen enough ends a run, and nothing is said of it', () => {
  const settings = settingsFile('longer.json', LONGER)
  const { stdout, stderr } = runInto('head -n 1', settings, '--workers', '2')
  expect(JSON.parse(stdout).settings).toMatchObject(LONGER)
  expect(stderr).not.toMatch(/EPIPE|error/i)
})

test.skipIf(!existsSync('/dev/full'))('a full disk ends what is printed, in a sentence', () => {
  const settings = settingsFile('small.json')
  run(settings, '--out', 'printed.jsonl')
  const told = { status: 1, stderr: 'ENOSPC: no space left on device, write\n' }
  for (const args of [[settings], ['--merge', 'printed.jsonl'], ['--help']]) {
    expect(runOnto('/dev/full', ...args)).toEqual(told)
  }
})

test('what cannot be written ends a run, and of a merge nothing is left', async () => {
  const settings = readSettings(textOf(settingsFile('small.json')))
  const program = pathToFileURL(pathOf('dist-lib/experiment.js'))
  const signal = new AbortController().signal
  const job = { settings, maps: { first: 0, end: 30 }, workers: 2, program, signal }
  const isFull = () => {
    throw new Error('no space left on device')
  }
  await expect(runMaps(job, isFull)).rejects.toThrow('no space left on device')

  run('small.json', '--out', 'whole.jsonl')
  const shards = readShards([pathOf('whole.jsonl')])
  // No file can take this name.
  await expect(mergeShards(shards, '')).rejects.toThrow('rename')
  expect(existsSync('.part')).toBe(false)
})

describe('what cannot be run is told before anything is', () => {
  test.each([
    [
      { planners: [{ planner: 'bug2', params: { leave: ['far'] } }] },
      'planners[0].params.leave[0]: ',
    ],
    [{ families: [{ family: 'city' }] }, 'families[0].family: there is no family "city"'],
    [{ mapsPerCombination: 10_000_000 }, 'these settings ask for 1,200,000,000 runs'],
  ])('%j', (fields, message) => {
    const { status, stderr } = run(settingsFile('broken.json', fields), '--out', 'broken.jsonl')
    expect(status).toBe(1)
    expect(stderr.startsWith(message) || stderr.includes(message)).toBe(true)
    expect(stderr.trim().split('\n')).toHaveLength(1)
    expect(existsSync(pathOf('broken.jsonl'))).toBe(false)
  })

  test('and no folder is made for it', () => {
    run(settingsFile('small.json'), '--shard', '1/2', '--out', 'half.jsonl')
    const settings = settingsFile('broken.json', { seed: -1 })
    for (const args of [[settings], ['nowhere.json'], ['--merge', 'half.jsonl', 'nowhere.jsonl']]) {
      expect(run(...args, '--out', join('made', 'for', 'nothing.jsonl')).status).toBe(1)
    }
    expect(run('small.json', '--out', 'made/for/').status).toBe(1)
    expect(existsSync(pathOf('made'))).toBe(false)
  })

  test.each([
    [[], 'The settings file is missing.'],
    [['nowhere.json'], 'nowhere.json'],
    [['a.json', 'b.json'], 'One settings file at a time: what is b.json?'],
    [['a.json', '--shard', '5/4'], 'A shard is written as 2/4'],
    [['a.json', '--workers', '0'], '--workers must be a whole number from 1 to 1024, but is "0".'],
    [['a.json', '--out', ''], '--out must name a file, but is "".'],
    [['a.json', '--out', 'new/'], '--out must name a file, but is "new/".'],
    [['--merge'], '--merge needs the files of the shards.'],
    [['--merge', 'a.jsonl', '--shard', '1/2'], '--merge runs nothing: no --shard.'],
    [['--colour'], "Unknown option '--colour'"],
  ])('%j', (args, message) => {
    const { status, stderr } = run(...args)
    expect(status).toBe(1)
    expect(stderr).toContain(message)
    expect(stderr).not.toContain('    at ')
  })

  test('--help is no fault', () => {
    const { status, stdout } = run('--help')
    expect(status).toBe(0)
    expect(stdout).toContain('--shard')
  })
})
