// The text of a case: which inputs it states, and edits that leave all else as it stands.
import { isAlias, isMap, isScalar, isSeq, parseDocument } from 'yaml';
import { below, join, skeleton, steps } from './schema.js';

const options = { keepSourceTokens: true, uniqueKeys: false, prettyErrors: false };

/** Bounds of the program's reader (prs/input/document.cpp), which refuses what is beyond them. */
const most = { bytes: 2 ** 20, values: 200000, levels: 64 };

/** The document of a text, the last one kept: whoever changes it parses anew. Empty beyond the bounds. */
const kept = { text: null, document: null };
function parsed(text) {
  if (kept.text === text) return kept.document;
  Object.assign(kept, { text, document: parseDocument(text.length > most.bytes ? '' : text, options) });
  return kept.document;
}

const keyOf = (pair) => (isScalar(pair.key) ? String(pair.key.value) : String(pair.key));

/** The node at a path; undefined where there is none. */
function find(document, path) {
  let node = document.contents;
  for (const step of steps(path)) {
    if (isAlias(node)) node = node.resolve(document);
    if (isMap(node) && typeof step === 'string')
      node = node.items.find((pair) => keyOf(pair) === step)?.value;
    else if (isSeq(node) && typeof step === 'number') node = node.items[step];
    else return undefined;
  }
  return node ?? undefined;
}

const source = (text, node) => (node?.range ? text.slice(node.range[0], node.range[1]).trim() : '');

/** A text as one line of a field: comments and line ends of a long list go. */
const oneLine = (text) =>
  text.replace(/(^|\s)#.*$/gm, '').replace(/\s*\n\s*/g, ' ').trim();

/** What a field shows: texts without their quotes. */
const shown = (text, node) =>
  isScalar(node) && typeof node.value === 'string' && /^["']/.test(source(text, node))
    ? node.value
    : oneLine(source(text, node));

/** Lists of scalars whose items are inputs of their own. */
const isPlainList = (node) => isSeq(node) && node.flow && node.items.every(isScalar);

/** Every input that the text states: [{path, text}], as `--set` names them. */
export function statedInputs(text, schema) {
  const document = parsed(text);
  const found = [];
  let values = 0;
  const walk = (node, path, of, level = 0) => {
    if (++values > most.values || level > most.levels) return;
    if (isAlias(node)) node = node.resolve(document);
    if (isMap(node)) {
      // A choice, `{convex: 5 mm}` where `straight` could stand, is an input as a whole, too.
      if (node.flow && of?.oneOf && path) found.push({ path, text: shown(text, node), isWhole: true });
      for (const pair of node.items) walk(pair.value, join(path, keyOf(pair)), of && below(of, keyOf(pair)), level + 1);
    } else if (isSeq(node) && !(isPlainList(node) && of?.oneOf)) {
      node.items.forEach((item, k) => walk(item, join(path, k), of && below(of, k), level + 1));
    } else if (node) {
      found.push({ path, text: shown(text, node) });
    }
  };
  if (document.contents) walk(document.contents, '', schema);
  return values > most.values ? [] : found;
}

/** The text of one input; undefined where it is not stated, or over several lines. */
export function valueAt(text, path) {
  const node = find(parsed(text), path);
  const isBlock = (isMap(node) || isSeq(node)) && !node.flow;
  return node && !isBlock ? shown(text, node) : undefined;
}

/** Keys of the map at a path; null where there is none. */
export function keysAt(text, path) {
  const node = path ? find(parsed(text), path) : parsed(text).contents;
  return isMap(node) ? node.items.map(keyOf) : null;
}

export const lengthAt = (text, path) => {
  const node = find(parsed(text), path);
  return isSeq(node) ? node.items.length : 0;
};

/** A value that may stand in YAML as it was typed, else quoted. */
function writable(value) {
  const document = parseDocument(`[${value}]`, options);
  const whole = document.errors.length === 0 && isSeq(document.contents) && document.contents.items.length === 1;
  if (whole && value.trim() !== '' && !/[\n#]/.test(value)) {
    const item = document.contents.items[0];
    if (isScalar(item) || isMap(item) || isSeq(item)) return value;
  }
  return JSON.stringify(value);
}

/** The text with another value at a path that it states; null where that is not to be done in place. */
export function withValue(text, path, value) {
  const document = parsed(text);
  if (document.errors.length) return null;
  const node = find(document, path);
  if (!node?.range || isAlias(node) || node.anchor || node.tag) return null;
  const inBlock = (isMap(node) || isSeq(node)) && !node.flow;
  if (inBlock) return null;
  if (isScalar(node) && /^[|>]/.test(text.slice(node.range[0]))) return null;
  const written = writable(value);
  const before = text.slice(0, node.range[0]);
  // An empty value stands right behind its colon.
  const gap = node.range[0] === node.range[1] && /:$/.test(before) ? ' ' : '';
  return before + gap + written + text.slice(node.range[1]);
}

/** The text with a block that it lacks, at its end. */
export function withBlock(text, key, node) {
  const lines = [];
  const write = (name, of, indent) => {
    const inner = of?.properties && (of.required?.length ? of.required : Object.keys(of.properties).slice(0, 1));
    if (inner) {
      lines.push(`${indent}${name}:`);
      for (const one of inner) write(one, of.properties[one], `${indent}  `);
    } else {
      lines.push(`${indent}${name}: ${skeleton(of)}`);
    }
  };
  write(key, node, '');
  return `${text.replace(/\s*$/, '\n\n')}${lines.join('\n')}\n`;
}

/** The text with an input in a block that it lacks, at its end; null where that is not to be done. */
export function withNew(text, path, value) {
  const way = steps(path);
  const stands = keysAt(text, '');
  if (!stands || parsed(text).contents.flow || stands.includes(way[0]) || way.some((step) => typeof step === 'number')) return null;
  const lines = way.map((key, k) => `${'  '.repeat(k)}${key}:${k === way.length - 1 ? ` ${writable(value)}` : ''}`);
  return `${text.replace(/\s*$/, '\n\n')}${lines.join('\n')}\n`;
}

/** The text without an input, all else as it stands. */
export function without(text, path) {
  const document = parseDocument(text, options);
  const way = steps(path);
  const last = way.pop();
  const parentPath = way.reduce((at, step) => join(at, step), '');
  const parent = parentPath ? find(document, parentPath) : document.contents;
  if (!parent) return text;
  // The last key of a map goes with the map.
  if ((isMap(parent) || isSeq(parent)) && parent.items.length === 1 && parentPath) return without(text, parentPath);
  if (isMap(parent) && !parent.flow && typeof last === 'string') {
    const pair = parent.items.find((one) => keyOf(one) === last);
    if (!pair) return text;
    let from = pair.key.range[0];
    const end = pair.value?.range ? pair.value.range[2] : pair.key.range[2];
    const lineStart = text.lastIndexOf('\n', from - 1) + 1;
    if (/^\s*$/.test(text.slice(lineStart, from))) from = lineStart;
    else return joined(document, way, last);
    const to = text[end - 1] === '\n' || end >= text.length ? end : text.indexOf('\n', end) + 1 || text.length;
    return text.slice(0, from) + text.slice(to);
  }
  return joined(document, way, last);
}

function joined(document, way, last) {
  document.deleteIn([...way, last]);
  return document.toString({ lineWidth: 0, flowCollectionPadding: false });
}

/** The list at a path with its last item once more; what names it is left to the reader. */
export function withItem(text, path) {
  const document = parseDocument(text, options);
  const node = find(document, path);
  if (!isSeq(node) || node.items.length === 0) return null;
  const copy = node.items.at(-1).clone();
  const name = isMap(copy) && copy.get('name');
  if (name) copy.set('name', `${name}-${node.items.length + 1}`);
  node.items.push(copy);
  return document.toString({ lineWidth: 0, flowCollectionPadding: false });
}
