// The engine of live pages against the program; both must have been built.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import test from 'node:test';

import {commandsFor, lessons, loadEngine, questionOn, run, textOf, unpackEngine} from './engine.mjs';

const ask = await loadEngine();
const answerTo = (question) => JSON.parse(ask(JSON.stringify(question)));

// What is left over after a solution, and the way to it.
const ofTheWay = new Set(['newton_history', 'factorization', 'iterations', 'relative_residual', 'relative_residue',
                          'interpolation_error', 'axial_error_um', 'rounds', 'change']);
// How far numbers may differ, by their path.
const tolerances = [
  [/depth/, 1e-7],  // Where a curve is flat, its highest point moves by the root of its values.
  [/heat_cycle/, 1e-11],  // A cycle that repeats itself to 1e-10 K.
  [/\.(travel|modes)\./, 1e-10],  // Loads of threads that open and close over the travel.
  // Of loads of threads, each good to 1e-12 of the force.
  [/^\.candidates\.\d+\.computed\.static_safety$/, 1e-11],
  [/./, 1e-12],
];

const largest = (value) => typeof value === 'number' ? Math.abs(value)
    : value !== null && typeof value === 'object'
    ? Math.max(0, ...Object.values(value).map(largest)) : 0;

/** Where two documents differ by more than they may, a line each. */
function differences(ours, theirs, path = '', scale = 0) {
  if (typeof ours === 'number' && typeof theirs === 'number') {
    const tolerance = tolerances.find(([where]) => where.test(path))[1];
    const most = tolerance * Math.max(scale, Math.abs(theirs));
    return Math.abs(ours - theirs) <= most
        ? [] : [`${path}: ${ours} for ${theirs}, ${Math.abs(ours - theirs) / Math.abs(theirs)}`];
  }
  if (ours === null || theirs === null || typeof ours !== 'object' || typeof theirs !== 'object')
    return ours === theirs ? [] : [`${path}: ${ours} for ${theirs}`];
  const keys = new Set([...Object.keys(ours), ...Object.keys(theirs)]);
  // Of the threads of a roller, they count together; sums of loads that nearly cancel are small
  // against the largest of them, friction of contacts that roll is rounding of their loads;
  // deviations of a travel are differences of displacements of some 50 um.
  const ofList = Array.isArray(theirs) ? Math.max(scale, largest(theirs)) : undefined;
  const all = (key) => ofList !== undefined ? ofList
      : key === 'reactions' ? largest(theirs[key])
      : key === 'friction_force_N' ? largest(theirs.normal_load_N)
      : key === 'travel' || key === 'modes' ? 50
      : /\.reactions|\.friction_force_N$|\.(travel|modes)\b/.test(path) ? scale : 0;
  return [...keys].filter((key) => !ofTheWay.has(key))
      .flatMap((key) => key in ours && key in theirs
          ? differences(ours[key], theirs[key], `${path}.${key}`, all(key))
          : [`${path}.${key}: only ${key in ours ? 'here' : 'there'}`]);
}

// In the quick run every third question, of every lesson some.
const thorough = process.env.PRS_THOROUGH !== undefined;
let questions = 0;
const leftOut = () => !thorough && questions++ % 3 !== 0;
for (const lesson of lessons)
  for (const command of commandsFor(lesson))
    test(`${command} of lesson ${lesson} is the program's`, {skip: leftOut()}, async () => {
      // `compare` takes what is kept of bodies: as the program that has just started.
      const engine = command === 'compare' ? await loadEngine() : ask;
      const answer = JSON.parse(engine(JSON.stringify(questionOn(command, lesson))));
      const program = run(command, `configs/${lesson}`, '--json');
      assert.equal(answer.status, program.status, answer.messages.join('\n'));
      assert.deepEqual(answer.messages, program.lines);
      const document = JSON.parse(program.out);
      // The verdict says that this module is not in the engine.
      const ours = JSON.parse(JSON.stringify(answer.document).replaceAll(', without `response`', ''));
      // The engine knows the name of a history, not its place.
      const history = document.resolved_input?.life?.history;
      if (history) history.file = history.file.split('/').pop();
      assert.deepEqual(differences(ours, document).slice(0, 5), []);
    });

const xz = (input, ...words) => spawnSync('xz', ['--format=lzma', '-c', ...words], {input}).stdout;

test('what xz packs is unpacked', {skip: xz('') === null}, () => {
  const numbers = Buffer.from(Float64Array.from({length: 20_000}, (_, k) => Math.sin(k)).buffer);
  const texts = [Buffer.alloc(0), Buffer.from('a'), Buffer.alloc(100_000), numbers,
                 Buffer.concat(lessons.map((name) => Buffer.from(textOf(name)))),
                 Buffer.concat([numbers, Buffer.alloc(5_000_000, numbers.subarray(9, 300)), numbers])];
  for (const text of texts)
    for (const how of ['lc=4,pb=0', 'lc=0,lp=2,pb=3', 'lc=3,lp=1,pb=2'])
      assert.ok(text.equals(unpackEngine(xz(text, `--lzma1=preset=6,${how}`))), `${text.length} ${how}`);
  const packed = xz(numbers);
  assert.throws(() => unpackEngine(packed.subarray(0, packed.length / 2)), /cut off/);
});

test('values are set as by --set', () => {
  const set = [['mechanism.rollers', '9'], ['load_cases[0].axial_force', '20 kN']];
  const answer = answerTo(questionOn('solve', '01_config_1_to_3.yaml', {set}));
  const words = set.flatMap(([path, value]) => ['--set', `${path}=${value}`]);
  const program = run('solve', 'configs/01_config_1_to_3.yaml', '--json', ...words);
  assert.deepEqual(differences(answer.document, JSON.parse(program.out)), []);
});

test('figures are those of --figures', () => {
  const answer = answerTo(questionOn('contact', '07_contact_geometry.yaml', {figures: true}));
  const program = run('contact', 'configs/07_contact_geometry.yaml', '--json', '--figures');
  assert.notEqual(answer.figures.length, 0);
  assert.deepEqual(differences(answer.figures, JSON.parse(program.out).figures), []);
});

test('wrong input has the lines and the status of the program', () => {
  const wrong = [
    ['mechanism.rollers', 'no'], ['mechanism.rollers', '1e9'], ['mechanism.lead', '5 parsec'],
    ['structure.nut.length', 'nan'], ['structure.nut.bore', '3'], ['load_cases', '[]'],
    ['load_cases[9].axial_force', '1 kN'], ['life', '{history: {file: no.csv}}'],
  ];
  for (const [path, value] of wrong) {
    const answer = answerTo(questionOn('solve', '01_config_1_to_3.yaml', {set: [[path, value]]}));
    const program = run('solve', 'configs/01_config_1_to_3.yaml', '--json', '--set',
                        `${path}=${value}`);
    assert.equal(program.status, 2, program.out);
    assert.deepEqual(answer, {status: 2, document: null, figures: [], messages: program.lines});
  }
});

test('hostile texts are refused, and the next question is answered', () => {
  const lesson = textOf('01_config_1_to_3.yaml');
  const hostile = {
    'nothing': '',
    'no text': '\u0000\u0001\uFFFE',
    'a deep list': '['.repeat(1 << 19),
    'a deep map': '{a: '.repeat(1 << 17),
    'deep dashes': '- '.repeat(1 << 18),
    'much nesting by columns': Array.from({length: 900}, (_, k) => `${' '.repeat(k)}a:`).join('\n'),
    'aliases that multiply': 'a: &a [x, x, x, x, x, x, x, x, x]\n' +
        'bcdefghi'.split('').map((name, k) =>
          `${name}: &${name} [${Array(9).fill(`*${'abcdefgh'[k]}`).join(', ')}]`).join('\n'),
    'an alias of itself': 'mechanism: &a {b: *a}',
    'a tag': `${lesson}\nextra: !!python/object:os.system x`,
    'two documents': `${lesson}\n---\n${lesson}`,
    'a long key': `${'k'.repeat(900_000)}: 1`,
    'more than a file may have': ' '.repeat((1 << 20) + 1),
    'a tab': 'mechanism:\n\ttype: standard',
    'an open quote': 'mechanism: "',
    'half of a pair of surrogates': 'mechanism: \uD800',
  };
  for (const [name, yaml] of Object.entries(hostile)) {
    const answer = answerTo({command: 'solve', yaml});
    assert.equal(answer.status, 2, `${name}: ${answer.messages}`);
    assert.match(answer.messages[0], /^(case\.yaml:\d+:\d+|prs): error: /, name);
  }
  for (const text of ['', '{', '[]', 'null', '{"command": "study", "yaml": ""}', '['.repeat(1 << 20)])
    assert.equal(JSON.parse(ask(text)).status, 2, text.slice(0, 40));
  assert.equal(answerTo(questionOn('solve', '01_config_1_to_3.yaml')).status, 0);
});

test('a page keeps the section of a command that needs a module', () => {
  const {document} = answerTo(questionOn('report', '34_reversal.yaml', {report: {}}));
  assert.deepEqual(document.kept, ['response']);
  assert.equal(document.all_follow, false);
  assert.ok(!('response' in document.sections));
  assert.ok(document.sections.preload.length > 0);
});

test('a case is known by its SHA-256, whatever its length', () => {
  const text = textOf('01_config_1_to_3.yaml');
  for (let length = 0; length <= 128; ++length) {
    const yaml = `${text}#${'x'.repeat(length)}\n`;
    const {document} = answerTo({command: 'check', yaml});
    assert.equal(document.input_sha256, createHash('sha256').update(yaml).digest('hex'));
  }
});

test('answers leave no memory behind', () => {
  const questions = [
    ...['contact', 'solve', 'slip', 'measures', 'life'].map(
        (command) => questionOn(command, '14_flight_spectrum.yaml', {figures: true})),
    questionOn('solve', '25_side_load.yaml'), questionOn('preload', '12_preload.yaml'),
    {command: 'solve', yaml: 'mechanism: 1'}, {command: 'none'},
    questionOn('slip', '30_duty_cycle.yaml', {load_cases: ['pull']}),
  ];
  const askAll = () => questions.forEach((question) => ask(JSON.stringify(question)));
  askAll();
  askAll();
  const before = ask.used(), rounds = thorough ? 100 : 10;
  for (let k = 0; k < rounds; ++k) askAll();
  // What the engine keeps may lie in a longer block than before; the shortest block has 16 bytes.
  assert.ok(ask.used() - before < 16 * rounds, `${ask.used() - before} bytes more`);
});
