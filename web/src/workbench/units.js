// How quantities are shown: digits and units, as in reports (prs/report/tables.cpp,
// prs/model/units.h), and inputs in the other system.

import { page } from './store.js';

/** Units of documents with the US ones that take their place: {text: [US text, factor]}. */
const us = Object.fromEntries(page.units.map((unit) => [unit.text, [unit.us_text, unit.factor]]));

const digitsIn = (unit) =>
  ['mm', 'deg', 'in'].includes(unit) ? 5 : ['h', 'km', '°C', 'degC', '°F', 'rev', '10^6 rev', '10^6 in'].includes(unit) ? 3 : 4;

/** In what a number of a document is shown: {unit, convert}. */
export function shownIn(path, unit, system, largest = Infinity) {
  if (!unit && /efficiency|critical_speed_share/.test(path)) return { unit: '%', convert: (x) => 100 * x };
  if (unit === 'degC' || unit === '°C')
    return system === 'us'
      ? { unit: '°F', convert: (x) => 1.8 * x + 32 }
      : { unit: '°C', convert: (x) => x };
  if (system === 'us' && us[unit]) return { unit: us[unit][0], convert: (x) => x * us[unit][1] };
  if (unit === 'MPa') return { unit: 'GPa', convert: (x) => x / 1000 };
  if (unit === 'N' && Math.abs(largest) >= 1000) return { unit: 'kN', convert: (x) => x / 1000 };
  return { unit, convert: (x) => x };
}

/** A sentence of the engine with the signs of print: `2 µm`, `80 °C`, `kg/m³`, `C₀`, and without backquotes. */
export const prose = (text) =>
  text.replace(/\bum\b/g, 'µm').replace(/\bdeg([CF])\b/g, '°$1').replace(/([a-z)])\^([23])(?![\d.])/gi, (_, unit, n) => unit + '⁰¹²³'[n]).replace(/(\d) deg\b/g, '$1°').replace(/\b([A-Z])_([a0])\b/g, (_, letter, index) => letter + { a: 'ₐ', 0: '₀' }[index]).replaceAll('`', '');

const superscript = (n) => [...String(n)].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('');

/** With an engineer's digits, never with a separator of thousands. */
export function number(value, unit = '', digits = digitsIn(unit)) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  let text;
  if (unit === 'N/µm') text = value.toFixed(1);
  else if (size === 0) text = '0';
  else if (size >= 1e6 || size < 1e-4) {
    const [head, exponent] = value.toExponential(digits - 1).split('e');
    text = `${head} × 10${superscript(Number(exponent))}`;
  } else if (size >= 10 ** digits - 0.5) text = value.toFixed(0);
  else text = String(Number(value.toPrecision(digits)));
  return text.replace(/^-/, '−').replace(/(× 10)/, '$1');
}

/** A quantity of a document as it is shown: '596.9 N/µm'. */
export function quantity(value, path, unit, system) {
  const how = shownIn(path, unit, system, value);
  return { text: number(how.convert(value), how.unit), unit: how.unit };
}

// Inputs in the other system ----------------------------------------------------------------------

const perInch = us.mm[1]; // Of millimetres.
const toUs = {
  ...us,
  um: ['uin', us.µm[1]], µm: ['uin', us.µm[1]], cm: ['in', 10 * perInch], 'N/um': ['lbf/uin', us['N/µm'][1]],
  'N/mm': ['lbf/in', us.N[1] / perInch], 'mm/min': ['in/min', perInch], 'm/min': ['in/min', 1000 * perInch],
};
const toSi = {
  ft: ['mm', 12 / perInch], psi: ['MPa', 1 / us.MPa[1] / 1000], uin: ['um', 1 / us.µm[1]],
  'lbf/uin': ['N/um', 1 / us['N/µm'][1]], 'lbf/in': ['N/mm', perInch / us.N[1]],
  ...Object.fromEntries(['mm', 'N', 'MPa', 'kg', 'N m', 'mm/s'].map((si) => [us[si][0], [si, 1 / us[si][1]]])),
};

/** '30 mm' in US units, '1.181 in'; null where it is the same there. */
export function inSystem(text, system) {
  const [, value, unit] = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(\S.*?)\s*$/i.exec(text) ?? [];
  if (!unit) return null;
  if (system === 'us' && unit === 'degC') return `${number(1.8 * value + 32, '', 4)} degF`;
  if (system === 'si' && unit === 'degF') return `${number((value - 32) / 1.8, '', 4)} degC`;
  const found = (system === 'us' ? toUs : toSi)[unit];
  return found ? `${number(value * found[1], '', 5)} ${found[0]}` : null;
}
