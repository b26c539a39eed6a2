// Studies of the workbench's page, asked of the engine, against `prs study`.
import assert from 'node:assert/strict';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import test from 'node:test';

import {ends, range, studies} from '../../web/src/studies/study.js';
import {loadEngine, questionOn, run, textOf} from './engine.mjs';

const ask = await loadEngine();
const engine = () => ({ask: async (question) => JSON.parse(ask(JSON.stringify(question)))});
const of = (lesson, more = {}) => studies({question: (asked) => ({...questionOn('solve', lesson), ...asked}), engine, workers: 2, ...more});

/** The designs of a study of the program: numbers of its factors and of its first response. */
function programs(lesson, study) {
  const folder = mkdtempSync(join(tmpdir(), 'prs-studies-'));
  try {
    const file = join(folder, 'case.yaml');
    const bare = (_, value) => typeof value === 'string' && /^[\d.]+$/.test(value) ? Number(value) : value;
    writeFileSync(file, `${textOf(lesson)}\nstudy: ${JSON.stringify(study, bare)}\n`);
    const ended = run('study', file, '--json', '--threads', '1', '--output', join(folder, 'out'));
    assert.equal(ended.status, 0, ended.lines.join('\n'));
    return JSON.parse(ended.out);
  } finally {
    rmSync(folder, {recursive: true});
  }
}

const near = (ours, theirs, what = '') => {
  assert.equal(ours.length, theirs.length, what);
  ours.forEach((value, k) => value === null || theirs[k] === null
      ? assert.equal(value, theirs[k], `${what} ${k}`)
      : assert.ok(Math.abs(value - theirs[k]) <= 1e-10 * Math.abs(theirs[k]), `${what} ${k}: ${value} for ${theirs[k]}`));
};
/** Without the base case. */
const designs = (document) => document.designs.filter(({base}) => !base);
const responses = (document, name) => designs(document).map((design) => design.responses?.[name] ?? null);
const numbers = (document, path) => designs(document).map(({settings}) => settings[path].number);

// A force, a count of which some designs cannot be built, a length on a logarithmic axis, all that slip and life say.
const curves = [
  ['01_config_1_to_3.yaml', 'solve', {path: 'load_cases[0].axial_force', from: '10 kN', to: '44 kN', steps: 6}, 'screw.peak_pressure_MPa.max'],
  ['01_config_1_to_3.yaml', 'solve', {path: 'mechanism.lead', from: '0.2 in', to: '0.3 in', steps: 4}, 'nut.normal_load_N.mean'],
  ['24_misalignment.yaml', 'solve', {path: 'mechanism.rollers', from: '8', to: '14', steps: 4}, 'axial_stiffness_N_per_um'],
  ['05_standard_screw.yaml', 'contact', {path: 'mechanism.pitch_diameter.roller', from: '9 mm', to: '11 mm', steps: 3, spacing: 'logarithmic'}, 'contact.screw.hertz_constant_N_per_mm1_5'],
  ['09_slip_and_dissipation.yaml', 'slip', {path: 'operation.speed', from: '100 rpm', to: '500 rpm', steps: 3}, 'slip.efficiency'],
];
for (const [lesson, command, {path, ...values}, wanted] of curves)
  test(`${wanted} over ${path} of lesson ${lesson} is the program's`, async () => {
    const ours = await of(lesson).study({path, ...values, command}, wanted);
    const document = programs(lesson, {command, plan: 'grid', responses: [wanted], factors: [{path, values}]});
    assert.equal(ours.unit, document.study.factors[0].unit ?? '');
    near(ours.values, numbers(document, path), 'values');
    near(ours.responses, responses(document, wanted), 'responses');
    near([ours.base], [document.designs.find(({base}) => base).responses[wanted]], 'base');
    assert.deepEqual(ours.reasons.map((reason) => reason === null), ours.responses.map((value) => value !== null));
  });

test('a map is a grid of the program', async () => {
  const [lesson, wanted] = ['05_standard_screw.yaml', 'axial_stiffness_N_per_um'];
  const inputs = [{path: 'structure.nut.outer_diameter', from: '60 mm', to: '70 mm', steps: 3},
                  {path: 'load_cases[0].axial_force', from: '20 kN', to: '80 kN', steps: 4}];
  const ours = await of(lesson).map(inputs, wanted);
  const factors = inputs.map(({path, ...values}) => ({path, values}));
  const document = programs(lesson, {command: 'solve', plan: 'grid', responses: [wanted], factors});
  near(ours.responses.flat(), responses(document, wanted));
  near(ours.rows.flatMap((value) => ours.columns.map(() => value)), numbers(document, inputs[0].path));
  near(ours.rows.flatMap(() => ours.columns), numbers(document, inputs[1].path));
});

test('tolerances have the ends and the responses of the program', async () => {
  const [lesson, wanted] = ['05_standard_screw.yaml', 'axial_stiffness_N_per_um'];
  const inputs = [{path: 'mechanism.flank_angle', within: '2 %'}, {path: 'structure.nut.outer_diameter', within: '20 um'},
                  {path: 'mechanism.profile.roller.convex', within: '[-0.1 mm, 0.3 mm]'}, {path: 'materials.youngs_modulus', within: '0.01'}];
  const ours = await of(lesson).tornado(inputs, wanted);
  const sampled = programs(lesson, {command: 'solve', plan: 'latin_hypercube', samples: 2, responses: [wanted], factors: inputs.map((input) =>
    ({...input, within: input.within.startsWith('[') ? ['-0.1 mm', '0.3 mm'] : input.within}))});
  const uniform = new Map(sampled.study.factors.map(({path, distribution}) => [path, distribution.uniform]));
  for (const {path, texts} of ours.bars)
    near(texts.map((text) => range({from: text, to: text, steps: 2}).numbers[0]), [uniform.get(path).from, uniform.get(path).to], path);
  const document = programs(lesson, {command: 'solve', plan: 'one_at_a_time', responses: [wanted],
                                     factors: ours.bars.map(({path, texts}) => ({path, values: texts}))});
  near(ours.bars.flatMap((bar) => bar.responses), responses(document, wanted));
  const swings = ours.bars.map((bar) => Math.max(...bar.responses.map((value) => Math.abs(value - ours.base))));
  assert.deepEqual(swings, swings.toSorted ? swings.toSorted((a, b) => b - a) : [...swings].sort((a, b) => b - a));
});

test('the command is the first that has the response', async () => {
  const study = {path: 'load_cases[0].axial_force', from: '10 kN', to: '20 kN', steps: 2};
  assert.equal((await of('09_slip_and_dissipation.yaml').study(study, 'slip.efficiency')).command, 'slip');
  assert.equal((await of('01_config_1_to_3.yaml').study(study, 'axial_stiffness_N_per_um')).command, 'solve');
  await assert.rejects(of('01_config_1_to_3.yaml').study(study, 'no.such_number'), /no\.such_number/);
});

test('what cannot be a study is refused with what was expected', () => {
  for (const wrong of [{from: '1 mm', to: '2 um', steps: 3}, {from: 'a', to: '2 mm', steps: 3}, {from: '1 mm', to: '2 mm', steps: 1.5},
                       {from: '0 mm', to: '2 mm', steps: 3, spacing: 'logarithmic'}])
    assert.throws(() => range(wrong), /expected/);
  for (const [value, within] of [['straight', '1 %'], ['0 mm', '1 %'], ['5 mm', '1 kN'], ['5 mm', '[1 mm, -1 mm]'], ['20 degC', '1 %']])
    assert.throws(() => ends(value, within), /expected/);
  near(ends('20 degC', '5 K').texts.map(parseFloat), [15, 25]);
});

test('a cancelled study ends its workers and says so', async () => {
  let ended = 0, asked = 0;
  const cancel = new AbortController();
  const slow = () => ({
    ask: (question) => ++asked > 2 ? new Promise(() => {}) : engine().ask(question),
    end: () => ++ended,
  });
  const promise = of('01_config_1_to_3.yaml', {engine: slow}).study(
      {path: 'load_cases[0].axial_force', from: '10 kN', to: '20 kN', steps: 9}, 'axial_stiffness_N_per_um',
      {signal: cancel.signal, onProgress: () => cancel.abort()});
  await assert.rejects(promise, {name: 'AbortError'});
  assert.equal(ended, 2);
});
