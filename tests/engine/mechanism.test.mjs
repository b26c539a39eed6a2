// Shapes of the mechanism in three dimensions, from documents of the engine.
import assert from 'node:assert/strict';
import test from 'node:test';

import {
  azimuth, contactPlace, dimensions, nutLine, nutSection, revolvedMesh, rollerLines, rollerTurn, screwLines, screwTooth,
  threadAt, threadMesh, toothProfile,
} from '../../web/src/mechanism/geometry.js';
import {hasRollers, largest, stateOf, temperatures, threadNumber} from '../../web/src/mechanism/numbers.js';
import {factorOf, split} from '../../web/src/page/quantity.js';
import {loadEngine, questionOn, run} from './engine.mjs';

const ask = await loadEngine();
const documentOf = (command, lesson, more) => JSON.parse(ask(JSON.stringify(questionOn(command, lesson, more)))).document;
const turn = 2 * Math.PI;
const near = (a, b, tolerance = 1e-9) => assert.ok(Math.abs(a - b) <= tolerance, `${a} for ${b}`);
/** How far x is from whole periods. */
const offPeriod = (x, period) => Math.abs(x / period - Math.round(x / period)) * period;

test('sizes are those of the file', () => {
  const d = dimensions(documentOf('solve', '05_standard_screw.yaml'));
  assert.deepEqual(d.nut.outer, [[0, 40, 33], [40, 60, 49], [60, 100, 33]]);
  assert.deepEqual([d.first, d.contacts, d.rollers, d.screw.bore, d.roller.end, d.roller.endRadius], [16, 35, 10, 0, 8, 3.5]);
  near(d.pitch, 2);
  for (const [part, lead] of [['screw', 10], ['roller', 2], ['nut', 10]]) near(d[part].lead, lead);
  const inverted = dimensions(documentOf('solve', '01_config_1_to_3.yaml'));
  near(inverted.roller.lead, -5 / 3);  // Of the other hand.
});

test('units are the program\'s', () => {
  const {quantities} = JSON.parse(run('list', 'units', '--json').out);
  const paths = {'a length': ['mechanism.pitch_diameter.screw', 'mm', 30, (contact) => contact.pitch_diameter_mm.screw],
                 'an angle': ['mechanism.flank_angle', 'deg', 44, null]};
  const reference = documentOf('contact', '05_standard_screw.yaml', {set: [['mechanism.flank_angle', '44 deg']]}).contact.screw.normal_angle_deg;
  for (const {quantity, units} of quantities.filter(({quantity}) => quantity in paths)) {
    const [path, shown, value, read] = paths[quantity];
    for (const unit of units.flat()) {
      const text = `${value / factorOf(unit, shown)} ${unit}`;
      const {contact} = documentOf('contact', '05_standard_screw.yaml', {set: [[path, text]]});
      near(read ? read(contact) : contact.screw.normal_angle_deg, read ? value : reference);
    }
  }
  assert.deepEqual(split(' -1.5e3 µm '), {number: -1500, unit: 'µm'});
  assert.equal(split('straight'), null);
});

/** Volume inside closed surfaces, by the divergence of (x, y, z)/3. */
function volume(meshes) {
  let sum = 0;
  for (const {positions: p, index} of meshes)
    for (let k = 0; k < index.length; k += 3) {
      const [a, b, c] = [0, 1, 2].map((j) => p.subarray(3 * index[k + j], 3 * index[k + j] + 3));
      sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
  return sum;
}
/** Of a body of revolution under a closed line (x, r): its frustums. */
const revolved = (line) => line.reduce((sum, [x, r], k) => {
  const [px, pr] = line[(k + line.length - 1) % line.length];
  return sum + (Math.PI / 3) * (x - px) * (r * r + r * pr + pr * pr);
}, 0);

const lessons = ['01_config_1_to_3.yaml', '05_standard_screw.yaml', '08_design_by_backlash.yaml'];
for (const lesson of lessons) {
  const d = dimensions(documentOf('contact', lesson));
  const segments = 180;

  test(`threads of lesson ${lesson} lie on their helix and look outwards`, () => {
    for (const part of ['screw', 'roller', 'nut']) {
      const {pitch, lead, low, high} = d[part];
      const [from, to, inward] = [3, 3 + 12 * pitch, part === 'nut'];
      const profile = toothProfile(d[part]);
      const {positions: p, normals: n, index} = threadMesh(d[part], {tooth: 1, from, to, segments: 24, inward});
      for (let k = 0; k < p.length; k += 3) {
        const [x, r, phi] = [p[k], Math.hypot(p[k + 1], p[k + 2]), Math.atan2(p[k + 2], p[k + 1])];
        assert.ok(r > low - 1e-4 && r < high + 1e-4);
        if (x <= from + 1e-5 || x >= to - 1e-5) continue;
        assert.ok(profile.some(([at, radius]) => Math.abs(radius - r) < 1e-4 && offPeriod(x - 1 - at - (lead * phi) / turn, pitch) < 1e-4));
      }
      for (let k = 0; k < index.length; k += 3) {
        const [a, b, c] = [0, 1, 2].map((j) => [0, 1, 2].map((i) => p[3 * index[k + j] + i]));
        const [u, v] = [b, c].map((q) => q.map((value, i) => value - a[i]));
        const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        const isFlat = [a, b, c].some(([x]) => x <= from + 1e-5 || x >= to - 1e-5);
        const towards = cross.reduce((sum, value, i) => sum + value * n[3 * index[k] + i], 0);
        assert.ok(isFlat || towards > 0, `${part}, triangle ${k / 3}`);
      }
    }
  });

  test(`bodies of lesson ${lesson} are closed and have the volume of their sections`, () => {
    // Over whole pitches a helix has the volume of rings. A polygon is smaller than its circle.
    const polygon = Math.sin(turn / segments) / (turn / segments);
    const roller = {...d.roller, from: 0, to: 10 * d.pitch};
    const rings = toothProfile(roller);
    const pitches = [[rings[0][0], 0], ...rings, [rings[0][0] + d.pitch, roller.low], [rings[0][0] + d.pitch, 0]];
    const ends = 2 * Math.PI * roller.endRadius ** 2 * roller.end;
    const whole = [threadMesh(roller, {tooth: 0.3, from: roller.from, to: roller.to, segments}),
                   ...rollerLines({...d, roller}).map((line) => revolvedMesh(line, {segments}))];
    near(volume(whole) / ((10 * revolved(pitches) + ends) * polygon), 1, 1e-3);

    const screw = {...d.screw, from: 0, to: 20 * d.pitch};
    const teeth = toothProfile(screw);
    const ring = [[teeth[0][0], screw.bore], ...teeth, [teeth[0][0] + d.pitch, screw.low], [teeth[0][0] + d.pitch, screw.bore]];
    const body = [threadMesh(screw, {tooth: screwTooth(d), from: screw.from, to: screw.to, segments}), ...screwLines({screw}).map((line) => revolvedMesh(line, {segments}))];
    near(volume(body) / (20 * revolved(ring) * polygon), 1, 1e-3);
  });

  test(`threads of lesson ${lesson} stand in each other's grooves`, () => {
    for (let roller = 0; roller < d.rollers; roller++) {
      const phi = azimuth(d, roller);
      const tooth = (at) => d.first + (d.roller.lead * (at - rollerTurn(d, roller))) / turn;
      const groove = d.first + (d.nut.lead * phi) / turn;
      assert.ok(offPeriod(tooth(phi) - groove, d.pitch) < 1e-6);
      const ofScrew = screwTooth(d) + (d.screw.lead * phi) / turn;
      assert.ok(Math.abs(offPeriod(tooth(phi + Math.PI) - ofScrew, d.pitch) - d.pitch / 2) < 1e-6);
      for (const side of ['screw', 'nut'])
        for (let thread = 0; thread < d.contacts; thread++) {
          const {x, radius, along} = contactPlace(d, side, roller, thread);
          // A quarter of a pitch from the middle of the roller's tooth, where tooth and groove are as wide.
          const middle = tooth(side === 'nut' ? phi : phi + Math.PI);
          near(offPeriod(x - middle, d.pitch), d.pitch / 4, 1e-6);
          near(radius, d.centreDistance + (side === 'nut' ? 1 : -1) * d.roller.radius);
          near(Math.hypot(...along), 1);
          assert.ok(Math.abs(threadAt(d, x) - thread) <= 1);
        }
    }
  });

  test(`the nut of lesson ${lesson} is cut where its thread is`, () => {
    for (const phi of [0, 1, 4]) {
      const section = nutSection(d, phi);
      const area = section.reduce((sum, [x, r], k) => {
        const [px, pr] = section[(k + section.length - 1) % section.length];
        return sum + (px * r - x * pr) / 2;
      }, 0);
      // Per pitch, what is below the teeth of air, and these, which are trapezoids.
      const [, , [half, high], [foot, low]] = toothProfile(d.nut);
      const perPitch = (half + foot) * (high - low) + low * d.pitch;
      const outer = d.nut.outer.reduce((sum, [from, to, radius]) => sum + (to - from) * radius, 0);
      near(area / (outer - (perPitch * d.nut.length) / d.pitch), 1, 0.02);
    }
    assert.deepEqual(nutLine(d)[0], [0, d.nut.high]);
  });
}

test('numbers are the document\'s', () => {
  const full = documentOf('solve', '24_misalignment.yaml');
  const tilted = full.load_cases[1];
  assert.ok(hasRollers(tilted));
  assert.equal(threadNumber(tilted, 'nut', 'normal_load_N', 6, 3), tilted.nut.normal_load_N[6][3]);
  const most = largest(tilted, 'normal_load_N', 11, 20);
  assert.equal(most.value, Math.max(tilted.screw.largest_normal_load_N, tilted.nut.largest_normal_load_N));
  assert.equal(tilted[most.side].largest_roller - 1, most.roller);
  assert.equal(tilted[most.side].largest_thread - 1, most.thread);
  const sector = documentOf('slip', '30_duty_cycle.yaml');
  assert.equal(threadNumber(sector.load_cases[0], 'screw', 'peak_pressure_MPa', 8, 3), sector.load_cases[0].screw.peak_pressure_MPa[3]);
  assert.deepEqual(temperatures(sector, sector.load_cases[0]), sector.load_cases[0].heat.temperature_degC);
  assert.equal(stateOf(sector.load_cases[0]), 'running');
  assert.equal(stateOf(tilted), 'at rest');
  assert.equal(stateOf(undefined), '');
  assert.equal(threadNumber(undefined, 'screw', 'normal_load_N', 0, 0), null);
});
