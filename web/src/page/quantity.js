// Numbers with units as cases have them. Units that the program knows are listed by `prs list units`.

const degree = Math.PI / 180;
const tables = [
  { mm: 1, m: 1e3, cm: 10, um: 1e-3, 'µm': 1e-3, 'μm': 1e-3, nm: 1e-6, in: 25.4, ft: 304.8, uin: 25.4e-6, 'µin': 25.4e-6, 'μin': 25.4e-6 },
  { rad: 1, mrad: 1e-3, deg: degree, '°': degree },
];

/** The number and the unit of a text: `-1.5e3 mm`; null where it begins with no number. */
export function split(text) {
  const [, number, unit] = String(text).match(/^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i) ?? [];
  return number === undefined ? null : { number: Number(number), unit };
}

/** How many of a unit another one is: of the same, of lengths and of angles; else NaN. */
export function factorOf(unit, in_) {
  if (unit === in_) return 1;
  const table = tables.find((each) => unit in each && in_ in each);
  return table ? table[unit] / table[in_] : NaN;
}

/** As the program writes values between two ends, with 15 digits. */
export const withUnit = (number, unit) => `${Number(number.toPrecision(15))}${unit ? ` ${unit}` : ''}`;
