// What the schema of inputs says of a path, `load_cases[0].axial_force`.

/** Keys and places of a path: ['load_cases', 0, 'axial_force']. */
export const steps = (path) =>
  [...path.matchAll(/([^.[\]]+)|\[(\d+)\]/g)].map(([, key, place]) => key ?? Number(place));

export const join = (path, step) =>
  typeof step === 'number' ? `${path}[${step}]` : path ? `${path}.${step}` : step;

const alternatives = (node) => node.oneOf ?? node.anyOf ?? [node];

/** The node of a key or place; undefined where the schema has none. */
export function below(node, step) {
  for (const one of alternatives(node)) {
    if (typeof step === 'number') {
      if (one.items) return one.items;
    } else if (one.properties?.[step]) {
      return one.properties[step];
    } else if (typeof one.additionalProperties === 'object') {
      return one.additionalProperties;
    }
    if (one.oneOf || one.anyOf) {
      const found = below(one, step);
      if (found) return found;
    }
  }
  return undefined;
}

export function nodeAt(schema, path) {
  let node = schema;
  for (const step of steps(path)) node = node && below(node, step);
  return node;
}

/** Words to choose from, where a value is one of few and nothing else. */
export const choices = (node) =>
  node?.enum ?? (node?.oneOf?.every((one) => one.enum) ? node.oneOf.flatMap((one) => one.enum) : null);

export const meaning = (node) => node?.['x-meaning'] ?? node?.description ?? '';

/** What a reader may write there, and under which condition. */
export const help = (node) => [node?.['x-value'], node?.['x-condition']].filter(Boolean).join('; ');

/** Whether a text is a whole value of it, so that it can be computed while somebody types. */
export function isWhole(node, text) {
  return alternatives(node ?? {}).some((one) => {
    if (one.enum) return one.enum.includes(text);
    if (one.pattern) return new RegExp(one.pattern, 'u').test(text);
    if (one.type === 'integer') return /^[-+]?\d+$/.test(text) && within(one, Number(text));
    if (one.type === 'number') return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) && within(one, Number(text));
    return false;
  });
}

const within = (node, value) =>
  value >= (node.minimum ?? -Infinity) &&
  value <= (node.maximum ?? Infinity) &&
  value > (node.exclusiveMinimum ?? -Infinity);

/** A value to begin with, as it stands in a flow of YAML. */
export function skeleton(node) {
  if (!node) return '~';
  if (node.default !== undefined && typeof node.default !== 'object') return String(node.default);
  if (node.examples?.length) return String(node.examples[0]);
  if (node.enum) return node.enum[0];
  if (node.oneOf || node.anyOf) return skeleton(alternatives(node)[0]);
  if (node.type === 'array') return `[${skeleton(node.items)}]`;
  if (node.properties) {
    const keys = node.required?.length ? node.required : Object.keys(node.properties).slice(0, 1);
    return `{${keys.map((key) => `${key}: ${skeleton(node.properties[key])}`).join(', ')}}`;
  }
  if (node.type === 'integer' || node.type === 'number')
    return String(node.minimum ?? (node.exclusiveMinimum === undefined ? 0 : 1));
  if (node.type === 'boolean') return 'true';
  return 'name';
}

/** Keys that a map of the case may have and has not, with their nodes. */
export function missingKeys(node, stated) {
  const keys = {};
  for (const one of alternatives(node ?? {}))
    for (const [key, value] of Object.entries(one.properties ?? {}))
      if (!stated.includes(key)) keys[key] ??= value;
  return keys;
}
