// Shapes of a mechanism from its document (`prs contact | solve | slip --json`): lengths in mm,
// angles in rad, in the frame of docs/full_mechanism.md: x along the axis from the nut's end at the
// loaded end of the screw, azimuths from y towards z. It draws what the document says and computes
// no contacts, loads or temperatures.

import { factorOf, split } from '../page/quantity.js';

const inUnit = (unit) => (text) => {
  const { number, unit: own } = split(text);
  return number * factorOf(own, unit);
};
/** Of a text as `resolved_input` has it: `0.4 in`, `45 deg`. */
export const length = inUnit('mm');
export const angle = inUnit('rad');

const degree = Math.PI / 180;
const parts = ['screw', 'roller', 'nut'];
const perPart = (value, part) => (value !== null && typeof value === 'object' ? value[part] : value);
const turn = 2 * Math.PI;

/** The part of x that is left in (-period/2, period/2]. */
const wrapped = (x, period) => x - period * Math.ceil(x / period - 0.5);

/** Sizes and places of all parts under one load case of the document. */
export function dimensions({ contact, resolved_input: input, load_cases: cases = [] }, loadCase = 0) {
  const { mechanism, structure, deviations } = input;
  const shown = cases[loadCase];
  const d = { contacts: mechanism.contacts_per_roller, rollers: mechanism.rollers, centreDistance: contact.centre_distance_mm };
  const lead = (part) => Math.PI * contact.pitch_diameter_mm[part] * Math.tan(contact.helix_angle_deg[part] * degree);
  d.pitch = Math.abs(lead('screw')) / mechanism.starts.screw;
  for (const part of parts) {
    const [low, high] = contact.profile_radius_limits_mm[part];
    const slope = Math.tan(angle(perPart(mechanism.flank_angle, part)));
    d[part] = { radius: contact.pitch_diameter_mm[part] / 2, lead: lead(part), low, high, slope, pitch: d.pitch };
  }
  const threaded = (d.contacts - 1) * d.pitch;
  d.nut.length = structure ? length(structure.nut.length) : threaded + 4 * d.pitch;
  d.first = shown?.position_mm ?? (d.nut.length - threaded) / 2;
  d.last = d.first + threaded;
  d.roller.from = d.first - d.pitch / 2 - Math.abs(d.roller.lead) / 4;
  d.roller.to = d.last + d.pitch / 2 + Math.abs(d.roller.lead) / 4;
  d.roller.end = structure ? length(structure.roller.end_length) : 0;
  d.roller.endRadius = structure ? length(structure.roller.end_diameter) / 2 : 0;
  const margin = 0.04 * d.nut.length;
  const loaded = structure ? d.first - length(structure.screw.free_length) : 0;
  d.screw.from = Math.min(loaded, d.roller.from - d.roller.end, 0) - margin;
  d.screw.to = Math.max(d.roller.to + d.roller.end, d.nut.length) + margin;
  d.screw.bore = structure ? length(structure.screw.bore) / 2 : 0;
  d.nut.outer = outerSteps(structure?.nut, d.nut);
  d.direction = shown?.direction ?? 'tension';
  d.isTurned = (shown?.carrier_angle_deg ?? 0) * degree;
  d.missing = new Set(deviations?.missing_rollers ?? []);
  return d;
}

/** The nut's outer radius, step by step along its axis: [from, to, radius]. */
function outerSteps(nut, { length: whole, high, pitch }) {
  if (!nut) return [[0, whole, high + Math.max(2 * pitch, 0.15 * high)]];
  const flanges = (nut.flanges ?? []).map((flange) => ({
    from: length(flange.from), to: length(flange.to), radius: length(flange.outer_diameter) / 2,
  }));
  const faces = [...new Set([0, whole, ...flanges.flatMap(({ from, to }) => [from, to])])].sort((a, b) => a - b);
  return faces.slice(1).map((to, k) => {
    const middle = (faces[k] + to) / 2;
    const flange = flanges.find((f) => f.from < middle && middle < f.to);
    return [faces[k], to, flange?.radius ?? length(nut.outer_diameter) / 2];
  });
}

/** Azimuth of a roller, from 0. */
export const azimuth = (d, roller) => d.isTurned + (turn * roller) / d.rollers;

/**
 * How far a roller is turned about its axis so that its thread stands in the nut's: at the azimuth
 * phi the middle of a groove of the nut is at first + lead phi/turn, whole pitches apart.
 */
export const rollerTurn = (d, roller) => azimuth(d, roller) * (1 - d.nut.lead / d.roller.lead);

/** Where the screw's groove is at the azimuth 0: there a roller's thread, half a turn from the nut. */
export const screwTooth = (d) => d.first + d.roller.lead / 2 + d.pitch / 2;

/** How far the contacts of a roller stand from whole pitches after its first thread, along the axis. */
export const contactShift = (d, side, roller) =>
  wrapped((d.nut.lead * azimuth(d, roller)) / turn + (side === 'screw' ? d.roller.lead / 2 : 0), d.pitch);

/** Place of a contact, and the direction along its flank: x and radially outwards. */
export function contactPlace(d, side, roller, thread) {
  const phi = azimuth(d, roller);
  const outwards = side === 'nut' ? 1 : -1; // Of the roller's tooth.
  const flank = (side === 'screw') === (d.direction === 'tension') ? 1 : -1;
  const x = d.first + thread * d.pitch + contactShift(d, side, roller) + (flank * d.pitch) / 4;
  const norm = Math.hypot(1, d.roller.slope);
  return {
    x, phi, radius: d.centreDistance + outwards * d.roller.radius,
    along: [(-flank * outwards * d.roller.slope) / norm, 1 / norm],
  };
}

/** The roller's thread that is nearest to a place along its axis. */
export const threadAt = (d, x) => Math.max(0, Math.min(d.contacts - 1, Math.round((x - d.first) / d.pitch)));

// Meshes -----------------------------------------------------------------------------------------

/**
 * Triangles of strips about the axis, each between two circles or helices, with normals of their own on
 * each side of an edge. `start` and `end` are azimuths.
 */
class Mesh {
  constructor(strips, { start = 0, end = turn, segments, flipped = false }) {
    const points = 2 * (segments + 1) * strips;
    this.positions = new Float32Array(3 * points);
    this.normals = new Float32Array(3 * points);
    this.index = new Uint32Array(6 * segments * strips);
    this.azimuths = Array.from({ length: segments + 1 }, (_, j) => start + ((end - start) * j) / segments);
    this.cos = this.azimuths.map(Math.cos);
    this.sin = this.azimuths.map(Math.sin);
    this.flipped = flipped;
    this.point = 0;
    this.corner = 0;
  }

  /** From (x, r) to (x, r), by `place(x, j)` on the helix; the normal: along the axis, outwards, around. */
  strip(rows, [nx, nr, nt], place = (x) => x) {
    const { cos, sin, positions, normals, index } = this;
    const count = cos.length;
    const first = this.point;
    for (const [x, r] of rows)
      for (let j = 0; j < count; j++) {
        const at = 3 * this.point++;
        positions[at] = place(x, j);
        positions[at + 1] = r * cos[j];
        positions[at + 2] = r * sin[j];
        normals[at] = nx;
        normals[at + 1] = nr * cos[j] - nt * sin[j];
        normals[at + 2] = nr * sin[j] + nt * cos[j];
      }
    for (let j = 0; j + 1 < count; j++) {
      const [a, b, c, d] = [first + j, first + j + 1, first + count + j, first + count + j + 1];
      for (const corner of this.flipped ? [a, c, b, b, c, d] : [a, b, c, b, d, c]) index[this.corner++] = corner;
    }
  }

  arrays() {
    return { positions: this.positions, normals: this.normals, index: this.index };
  }
}

/**
 * Profile of a tooth about its middle: (x, radius), with straight flanks. A crest or a root that is
 * narrower than this share of the pitch is an edge.
 */
export function toothProfile({ pitch, radius, low, high, slope }, narrow = 0.01) {
  const edge = (narrow * pitch) / 2;
  const half = (r) => {
    const width = pitch / 4 - (r - radius) * slope;
    return width < edge ? 0 : width > pitch / 2 - edge ? pitch / 2 : width;
  };
  return [[-half(low), low], [-half(high), high], [half(high), high], [half(low), low]];
}

/** Middles of teeth of which a part lies between two places. */
function teeth(tooth, pitch, from, to) {
  const middles = [];
  for (let k = Math.floor((from - tooth) / pitch - 0.5); tooth + (k - 0.5) * pitch < to; k++) middles.push(tooth + k * pitch);
  return middles;
}

/**
 * The surface of a thread, cut off at both ends; `tooth`: the middle of one at the azimuth 0. Of a nut
 * (`inward`) the teeth are those of the air.
 */
export function threadMesh(thread, { tooth, from, to, start = 0, end = turn, segments, narrow, inward = false }) {
  const { pitch, lead } = thread;
  const [a, b, c, d] = toothProfile(thread, narrow);
  const edges = [[a, b], [b, c], [c, d], [d, [a[0] + pitch, a[1]]]].filter(([p, q]) => Math.hypot(q[0] - p[0], q[1] - p[1]) > 1e-6 * pitch);
  const shifts = [(lead * start) / turn, (lead * end) / turn].sort((p, q) => p - q);
  const middles = teeth(tooth, pitch, from - shifts[1], to - shifts[0]);
  const mesh = new Mesh(middles.length * edges.length, { start, end, segments, flipped: inward });
  const along = mesh.azimuths.map((phi) => (lead * phi) / turn);
  const place = (x, j) => Math.max(from, Math.min(to, x + along[j]));
  for (const middle of middles)
    for (const [p, q] of edges) {
      const [dx, dr] = [q[0] - p[0], q[1] - p[1]];
      const normal = [-dr, dx, (dr * lead) / (Math.PI * (p[1] + q[1]))];
      const size = Math.hypot(...normal) * (inward ? -1 : 1);
      mesh.strip([[middle + p[0], p[1]], [middle + q[0], q[1]]], normal.map((n) => n / size), place);
    }
  return mesh.arrays();
}

/** The surface of revolution of a line (x, radius), whose outside is to the left of its direction. */
export function revolvedMesh(line, { start, end, segments }) {
  const mesh = new Mesh(line.length - 1, { start, end, segments });
  for (let k = 1; k < line.length; k++) {
    const [p, q] = [line[k - 1], line[k]];
    const size = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
    mesh.strip([p, q], [-(q[1] - p[1]) / size, (q[0] - p[0]) / size, 0]);
  }
  return mesh.arrays();
}

/** Both ends of the screw and its bore, a line each. */
export const screwLines = ({ screw: { from, to, bore, low } }) => [
  [[from, bore], [from, low]],
  [[to, low], [to, bore], ...(bore > 0 ? [[from, bore]] : [])],
];

/** Both ends of a roller, a line each. */
export function rollerLines({ roller: { from, to, end, endRadius, low } }) {
  const collar = end > 0 ? endRadius : 0;
  return [
    [[from - end, 0], [from - end, collar], [from, collar], [from, low]],
    [[to, low], [to, collar], [to + end, collar], [to + end, 0]],
  ];
}

/** The outside of the nut with its faces. */
export function nutLine({ nut: { outer, high } }) {
  const line = [[outer[0][0], high]];
  for (const [from, to, radius] of outer) line.push([from, radius], [to, radius]);
  return [...line, [outer.at(-1)[1], high]];
}

/** The nut cut at an azimuth: a closed outline (x, radius). */
export function nutSection(d, phi) {
  const { nut, pitch } = d;
  const profile = toothProfile(nut);
  const within = (x) => Math.max(0, Math.min(nut.length, x));
  const inside = teeth(d.first + (nut.lead * phi) / turn, pitch, 0, nut.length)
    .flatMap((middle) => profile.map(([x, r]) => [within(middle + x), r]));
  const outside = nut.outer.flatMap(([from, to, radius]) => [[from, radius], [to, radius]]).reverse();
  const outline = [...inside, ...outside];
  return outline.filter(([x, r], k) => {
    const [px, pr] = outline[(k + outline.length - 1) % outline.length];
    return Math.hypot(x - px, r - pr) > 1e-9;
  });
}
