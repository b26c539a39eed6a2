// The engine of scripts/web.sh, as a page has it, and the program that it is compared with. Where it is absent or
// of other sources than the program, nothing is compared.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const program = process.env.PRS ?? `${root}/build/release/prs/cli/prs`;
const script = readFileSync(`${root}/prs/page/live/engine.js`, 'utf8');
const packed = process.env.PRS_ENGINE ?? `${root}/build/web/engine.wasm.lzma`;

const load = new Function(`${script}; return {unpackEngine, loadEngine};`);
export const {unpackEngine} = load();
export const loadEngine = () => load().loadEngine(unpackEngine(readFileSync(packed)));

export const textOf = (lesson) => readFileSync(`${root}/configs/${lesson}`, 'utf8');

export const lessons = readdirSync(`${root}/configs`).filter((name) => name.endsWith('.yaml'));

const histories = Object.fromEntries(readdirSync(`${root}/configs`)
                                         .filter((name) => name.endsWith('.csv'))
                                         .map((name) => [name, textOf(name)]));

/** A question on a lesson by the name that the program is given. */
export function questionOn(command, lesson, more = {}) {
  const yaml = textOf(lesson);
  const named = Object.entries(histories).filter(([name]) => yaml.includes(`file: ${name}`));
  const question = {command, yaml, file: `configs/${lesson}`, ...more};
  return named.length === 0 ? question : {...question, histories: Object.fromEntries(named)};
}

/** The program without what earlier runs have kept of bodies. */
export function run(...words) {
  const ended = spawnSync(program, words, {
    cwd: root,
    env: {...process.env, PRS_CACHE_DIR: ''},
    encoding: 'utf8',
    maxBuffer: 1 << 30,
  });
  if (ended.error) throw ended.error;
  return {status: ended.status, out: ended.stdout, lines: ended.stderr.split('\n').filter((line) => line)};
}

/** The commands that one case answers. */
export const commandsFor = (lesson) => run('list', 'commands', `configs/${lesson}`)
                                           .out.trim().split('\n')
                                           .filter((name) => !['study', 'optimize'].includes(name));

/** What the program says where it has no engine of its sources. */
function absent() {
  const folder = mkdtempSync(join(tmpdir(), 'prs-engine-'));
  try {
    return run('workbench', '--quiet', '--output', join(folder, 'page.html')).lines.join('\n');
  } finally {
    rmSync(folder, {recursive: true});
  }
}

const reason = process.env.PRS_ENGINE ? '' : absent();
if (reason) {
  writeSync(1, `skipped: ${reason}\n`);
  process.exit();
}
