// What the workbench knows: variants with their texts and undo, answers of the engine, choices of the
// reader. Views are drawn anew after each `changed()`.
import { Engine } from '../page/engine.js';
import { unpacked } from '../page/packed.js';
import { statedInputs, valueAt, withNew, withValue } from './case_text.js';
import { nodeAt } from './schema.js';

export const mostVariants = 4;
const mostUndo = 200;
const storageKey = 'prs-workbench';
const previousKey = 'prs-workbench-before';

/** Lists and lessons that the page carries. */
export const page = await unpacked(document.getElementById('data').textContent, 'deflate').json();

const lessonFiles = Object.fromEntries(
  page.lessons.filter((l) => !l.name.match(/^\d+_[^.]*$/) || !l.title).map((l) => [l.name, l.text]),
);
export const lessons = page.lessons.filter((l) => l.title);

export const state = {
  variants: [],
  current: 0,
  units: 'si',
  files: { ...lessonFiles }, // Texts of files that cases name.
  view: 'results',
  open: new Set(['mechanism', 'loads']), // Sections.
  loadCase: 0,
  busy: false,
  trouble: '',
  note: '',
};

let draw = () => {};
export const onChange = (call) => (draw = call);
let waits = false;
export function changed() {
  if (waits) return;
  waits = true;
  queueMicrotask(() => {
    waits = false;
    draw();
  });
}

export const current = () => state.variants[state.current];

/** The file that is no case, by its keys: a requirement; undefined for a case. */
export const otherFile = (text) =>
  /^mechanism\s*:/m.test(text)
    ? undefined
    : page.commands.find((c) => c.key && new RegExp(`^${c.key}\\s*:`, 'm').test(text));

export const schemaOf = (text) => {
  const other = otherFile(text);
  return other ? page.schemas[Object.keys(page.schemas).find((name) => name !== 'case')] : page.schemas.case;
};

// The engine -------------------------------------------------------------------------------------

/** Headlines in one worker, verdict and pictures in another, what the reader asks for in a third. */
let engines = {};
const engine = (name) => (engines[name] ??= new Engine());

/** Texts of the files that a case names, by their names there; undefined of those that the page lacks. */
const filesOf = ({ inputs }) =>
  Object.fromEntries(
    inputs
      .filter(({ path }) => /(^|\.)file(\.name)?$/.test(path))
      .map(({ text }) => [text, state.files[text] ?? state.files[text.replace(/^.*[\\/]/, '')]]),
  );

/** Names of files that have to be opened too. */
export const lacking = (variant) =>
  Object.entries(filesOf(variant)).filter(([, text]) => text === undefined).map(([name]) => name);

export const questionOf = (variant, more) => ({
  yaml: variant.text,
  file: variant.file,
  histories: filesOf(variant),
  set: [],
  ...more,
});

const nothing = { status: 2, document: null, figures: [], messages: ['prs: error: no case is open; open one first'] };

const send = (more, v, name) => engine(name).ask(questionOf(v, more));

/** The answer on a case as it stands, which is asked once. */
function answerOf(command, v) {
  if (v.asked?.text !== v.text || v.asked.files !== state.files) v.asked = { text: v.text, files: state.files, answers: {} };
  return (v.asked.answers[command] ??= send({ command }, v, command === 'check' ? 'pictures' : 'numbers'));
}

/** What a reader or a script asks, apart from what the views show. */
export async function ask(more, v = current()) {
  if (more.command === 'new') return engine('asked').ask(more);
  if (!v) return nothing;
  const same = Object.keys(more).length === 1 && v.asked?.text === v.text && v.asked.files === state.files;
  const answer = same ? await v.asked.answers[more.command] : undefined;
  return answer && !answer.ended ? answer : send(more, v, 'asked');
}

/** What computes values that are gone for long goes as well. */
function endStale() {
  const patience = 250;
  for (const name of ['numbers', 'pictures'])
    if (engines[name]?.busySince != null && performance.now() - engines[name].busySince > patience) {
      engines[name].end();
      delete engines[name];
    }
}

/** Ends a long computation: its worker goes, the next question starts another. */
export function stop() {
  for (const each of Object.values(engines)) each.end();
  engines = {};
  for (const v of state.variants) v.asked = null;
  state.busy = false;
  refreshing += 1;
  changed();
}

/** Ready before somebody asks. */
export const warm = () => ['numbers', 'pictures', 'asked'].forEach(engine);

// Variants ---------------------------------------------------------------------------------------

const variant = (name, file, text) => ({
  name, file, text,
  undone: [], done: [],
  documents: {}, // Of commands, by their names: of this text, or while it is computed of the one before.
  before: {}, // Of the last text that could be read.
  sections: {}, // Null where the text cannot be read.
  inputs: statedInputs(text, schemaOf(text)),
  messages: [], status: 0, answered: '',
});

const nameOf = (file) => file.replace(/^.*[\\/]/, '').replace(/\.ya?ml$/i, '') || 'case';

/** Begins anew with a text. */
export function open(text, file = 'case.yaml') {
  keep(previousKey);
  state.variants = [variant(nameOf(file), file, text)];
  state.current = 0;
  state.loadCase = 0;
  state.note = '';
  return refresh();
}

export function addVariant(name, text = current()?.text, file = current()?.file) {
  if (!current()) throw new Error('no case is open; open one first');
  if (state.variants.length >= mostVariants)
    throw new Error(`got a fifth variant; expected at most ${mostVariants}; remove one first`);
  const taken = new Set(state.variants.map((v) => v.name));
  let own = String(name ?? '').trim() || `${current().name} ${state.variants.length + 1}`;
  while (taken.has(own)) own += '′';
  state.variants.push(variant(own, file === current().file ? `${own}.yaml` : file, text));
  state.current = state.variants.length - 1;
  return refresh();
}

export function chooseVariant(k) {
  state.current = k;
  changed();
  if (current().answered !== current().text || current().units !== state.units) refresh();
}

export function removeVariant(k) {
  if (state.variants.length < 2) return;
  state.variants.splice(k, 1);
  state.current = Math.min(state.current, state.variants.length - 1);
  save();
  changed();
}

// Edits ------------------------------------------------------------------------------------------

let lastEdit = { key: null, at: 0 };

/** Another text of the case at hand; edits of one `key` in a row, within two seconds, are one step. */
export function edit(text, key = null) {
  const v = current();
  if (!v || text === v.text) return Promise.resolve();
  const now = Date.now();
  const goesOn = key !== null && key === lastEdit.key && now - lastEdit.at < 2000 && v.done.length > 0;
  lastEdit = { key, at: now };
  if (!goesOn) v.done.push(v.text);
  if (v.done.length > mostUndo) v.done.shift();
  v.undone = [];
  takeText(v, text);
  return refresh();
}

function takeText(v, text) {
  v.text = text;
  v.inputs = statedInputs(text, schemaOf(text));
  state.note = '';
}

const turn = (from, to) => {
  const v = current();
  if (!v || v[from].length === 0) return false;
  v[to].push(v.text);
  takeText(v, v[from].pop());
  lastEdit = { key: null, at: 0 };
  refresh();
  return true;
};
export const undo = () => turn('done', 'undone');
export const redo = () => turn('undone', 'done');

/** The text with an input, as `--set` has it: {text}, or {messages} where that cannot be. */
async function textWith(path, value) {
  const v = current();
  const inPlace = valueAt(v.text, path) === undefined ? withNew(v.text, path, value) : withValue(v.text, path, value);
  if (inPlace !== null) return { text: inPlace };
  for (const written of [value, JSON.stringify(value)]) {
    const answer = await ask({ command: 'write', set: [[path, written]] }, v);
    if (answer.document) return { text: answer.document.yaml };
    if (written !== value || answer.messages.some((line) => !/cannot be written/.test(line))) return answer;
  }
}

/** A number alone has the unit of the value that stands there. */
export function withUnit(path, typed) {
  const shown = current() ? valueAt(current().text, path) : undefined;
  const [, unit] = shown?.match(/^[-+]?[\d.,]+(?:e[-+]?\d+)?\s*([^\d\s.,].*)$/i) ?? [];
  return unit && /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(typed) ? `${typed} ${unit}` : typed;
}

/** Sets an input; the answer has the status and messages of `prs check`. */
export async function set(path, value, key = null) {
  if (!current()) return nothing;
  const typed = String(value).trim();
  if (!nodeAt(schemaOf(current().text), path)) {
    const refused = await ask({ command: 'check', set: [[path, typed]] });
    if (refused.status === 2) return { status: 2, messages: refused.messages };
  }
  const { text, messages, status } = await textWith(path, typed);
  if (text === undefined) return { status: status || 2, messages };
  await edit(text, key);
  const v = current();
  return { status: v.status, messages: v.messages };
}

// Answers ----------------------------------------------------------------------------------------

const singles = ['solve', 'contact', 'slip', 'life', 'measures', 'preload'];
let refreshing = 0;

/** Asks anew what the views show. Resolves when all numbers are there, or after some seconds. */
export function refresh() {
  save();
  const round = ++refreshing;
  const v = current();
  endStale();
  if (v.documents.check) v.before = v.documents;
  state.busy = true;
  changed();
  // The numbers that a reader waits for come first.
  const settled = Promise.all([
    askNumbers(v, round),
    answerOf('solve', v).then(() => Promise.all([askCheck(v, round), askSections(v, round)])),
  ]).then(() => {
    if (round !== refreshing) return;
    state.busy = false;
    changed();
    document.dispatchEvent(new CustomEvent('prs-complete', { detail: v.status }));
  });
  const patience = new Promise((resolve) => setTimeout(resolve, 15000));
  return Promise.race([settled, patience]);
}

/** What a command found, or that it found nothing, in place of what it found before. */
function take(v, command, document) {
  v.documents = { ...v.documents, [command]: document };
  if (!document) delete v.documents[command];
}

async function askNumbers(v, round) {
  const { text } = v;
  const drop = () => {
    for (const command of singles) take(v, command, null);
    changed();
  };
  if (otherFile(text)) return drop();
  for (const command of singles) {
    if (round !== refreshing || v.text !== text) return;
    const answer = await answerOf(command, v);
    if (round !== refreshing || v.text !== text || answer.ended) return;
    // What cannot be read is wrong for all.
    if (answer.status === 2 && command === 'contact' && !v.documents.solve) return drop();
    take(v, command, answer.document);
    changed();
  }
}

async function askCheck(v, round) {
  const { text } = v;
  if (round !== refreshing || v.text !== text) return;
  const answer = await answerOf('check', v);
  if (round !== refreshing || v.text !== text || answer.ended) return;
  v.status = answer.status;
  v.messages = answer.messages;
  v.answered = text;
  take(v, 'check', answer.document);
  if (answer.document) takeInputs(v);
  changed();
}

/** The inputs that the engine finds stated; a text that it refuses keeps those of its lines. */
function takeInputs(v) {
  const listed = v.documents.check?.input;
  if (!listed) return;
  const own = new Map(v.inputs.map((input) => [input.path, input]));
  const inputs = listed
    .filter((entry) => !(entry.default ?? !entry.written))
    .map(({ path, reason, basis, written, value }) => ({
      path, reason, basis,
      text: own.get(path)?.text ?? valueAt(v.text, path) ?? written ?? value,
    }));
  // Parts of what is listed as a whole, `from` of a range, stand behind it.
  const known = new Set(inputs.map((input) => input.path));
  for (const input of v.inputs.filter(({ path, isWhole }) => !known.has(path) && !isWhole)) {
    const whole = inputs.findLastIndex(({ path }) => input.path.startsWith(`${path}.`) || input.path.startsWith(`${path}[`));
    inputs.splice(whole < 0 ? inputs.length : whole + 1, 0, input);
  }
  v.inputs = inputs;
}

async function askSections(v, round) {
  const text = v.text;
  const report = { own: 0, units: state.units };
  // Those of a requirement take all its candidates: when they are asked for.
  if (otherFile(text)) v.sections = null;
  if (otherFile(text) || round !== refreshing) return;
  report.sections = page.sections.map((s) => s.id).filter((id) => state.open.has(id) && id !== 'verdict');
  report.sections.push('warnings');
  const answer = await send({ command: 'report', report }, v, 'pictures');
  if (round !== refreshing || v.text !== text || answer.ended) return;
  v.units = state.units;
  v.sections = answer.document?.sections ?? null;
  if (!answer.document && v.status !== 2) Object.assign(v, { status: answer.status, messages: answer.messages });
  changed();
}

export function toggleSection(id, isOpen) {
  if (state.open.has(id) === isOpen) return;
  if (isOpen) state.open.add(id);
  else state.open.delete(id);
  if (isOpen && !(id in (current()?.sections ?? {}))) return askSections(current(), refreshing);
}

/** Every section of the report, as HTML by their names: {sections, head}. */
export const wholeReport = () =>
  send({ command: 'report', report: { own: 0, units: state.units } }, current(), 'asked');

/** Answers of variants that are compared and were not asked yet. */
export async function refreshAll() {
  for (const v of state.variants) {
    for (const command of ['check', ...singles]) {
      const { text } = v;
      const { document } = await answerOf(command, v);
      if (v.text === text && v.documents[command] !== document) {
        take(v, command, document);
        changed();
      }
    }
  }
}

// Units, storage ---------------------------------------------------------------------------------

export function setUnits(units) {
  if (units !== 'si' && units !== 'us') throw new Error(`got ${units}; expected si or us`);
  state.units = units;
  document.documentElement.dataset.units = units;
  changed();
  save();
  if (current()) askSections(current(), refreshing);
}

let saving = 0;
function save() {
  clearTimeout(saving);
  saving = setTimeout(keep, 400, storageKey);
}

function keep(key) {
  if (state.variants.length === 0) return;
  const all = {
    at: Date.now(),
    current: state.current,
    variants: state.variants.map(({ name, file, text }) => ({ name, file, text })),
    files: Object.fromEntries(Object.entries(state.files).filter(([name, text]) => lessonFiles[name] !== text)),
  };
  try {
    localStorage.setItem(key, JSON.stringify(all));
  } catch {
    // Without room or permission nothing is kept; the file that is saved is what counts.
  }
}

/** What was at hand when the page was closed, and what stood there before something was opened. */
export function kept() {
  const read = (key) => {
    try {
      const found = JSON.parse(localStorage.getItem(key));
      return found?.variants?.length ? [found] : [];
    } catch {
      return [];
    }
  };
  return [...(current() ? [] : read(storageKey)), ...read(previousKey)];
}

export function restore(found) {
  state.files = { ...state.files, ...found.files };
  state.variants = found.variants.slice(0, mostVariants).map((v) => variant(String(v.name), String(v.file), String(v.text)));
  state.current = Math.min(found.current ?? 0, state.variants.length - 1);
  return refresh();
}
