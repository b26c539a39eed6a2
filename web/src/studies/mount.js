// The studies with their form, in an element of a page; see README.md.
import { split, withUnit } from '../page/quantity.js';
import { curve, heatMap, shown, tornadoChart } from './charts.js';
import { responsePaths } from './response.js';
import { commands, studies } from './study.js';
import { texts as english } from './texts.js';

function make(tag, properties = {}, ...children) {
  const { attributes = {}, ...rest } = properties;
  const node = Object.assign(document.createElement(tag), rest);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Inputs that a study may begin with, the more usual first. */
const usual = [/axial_force$/, /^mechanism\.lead$/, /^mechanism\.rollers$/, /contacts_per_roller$/, /outer_diameter$/];
const firstTolerances = 8;
const firstResponse = 'axial_stiffness_N_per_um';

/** Cells of a table as a file that spreadsheets read. */
const csv = (rows) => rows.map((row) => row.map((cell) => {
  const words = String(cell ?? '');
  return /[",\n]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words;
}).join(',')).join('\n');

/**
 * `question(more)`, `engine()`: as in study.js. `responses`: rows {path, title, unit} of `prs list responses`.
 * `title(path)`: what an input is called. `texts`: see texts.js. `documents()`: those of the case by their
 * commands, `check` among them, where the page has them at hand.
 */
export function mount(element, { question, engine, responses = [], title = (path) => path, texts = english, documents = asked }) {
  const run = studies({ question, engine });
  const known = new Map(responses.map((row) => [row.path, row]));
  const colours = getComputedStyle(element).getPropertyValue('--scale').split(',').map((colour) => colour.trim());
  let inputs = [];
  let cancel = null;

  const labelled = (words, field) => make('label', {}, `${words} `, field);
  const button = (words, act) => {
    const node = make('button', { type: 'button', textContent: words });
    node.addEventListener('click', act);
    return node;
  };
  const kind = make('select', {}, ...['curve', 'map', 'tornado'].map((name) => new Option(texts[name], name)));
  const wanted = make('select');

  /** The fields of one input that is varied. */
  function axis(words) {
    const path = make('select');
    const [from, to] = [make('input', { type: 'text', size: 9 }), make('input', { type: 'text', size: 9 })];
    const steps = make('input', { type: 'number', min: 2, max: 200 });
    const spacing = make('input', { type: 'checkbox' });
    const box = make('p', { className: 'row' }, labelled(words, path), labelled(texts.from, from), labelled(texts.to, to),
      labelled(texts.steps, steps), make('label', {}, spacing, ` ${texts.logarithmic}`));
    const suggest = () => {
      const input = inputs.find((each) => each.path === path.value);
      if (!input) return;
      const { number, unit } = split(input.text);
      const isWhole = unit === '' && Number.isInteger(number);
      const around = (share) => (isWhole ? Math.max(1, Math.round(number * share)) : number * share);
      [from.value, to.value] = number === 0 ? [input.text, withUnit(1, unit)] : [withUnit(around(0.8), unit), withUnit(around(1.2), unit)];
      const span = Math.abs(around(1.2) - around(0.8));
      steps.value = isWhole && span > 0 && span < 24 ? span + 1 : kind.value === 'map' ? 7 : 9;
    };
    path.addEventListener('change', suggest);
    return {
      box, path, suggest,
      value: () => ({ path: path.value, from: from.value.trim(), to: to.value.trim(), steps: Number(steps.value), spacing: spacing.checked ? 'logarithmic' : 'linear' }),
    };
  }

  const first = axis(texts.input);
  const second = axis(texts.second);
  const tolerances = make('table', { className: 'tolerances' });
  const start = make('button', { textContent: texts.run });
  const stop = button(texts.cancel, () => cancel?.abort());
  const progress = make('progress', { hidden: true });
  const state = make('p', { attributes: { role: 'status' } });
  const trouble = make('p', { className: 'trouble', attributes: { role: 'alert' } });
  const result = make('div', { className: 'result' });
  const form = make('form', { autocomplete: 'off' },
    make('p', { className: 'row' }, labelled(texts.kind, kind), labelled(texts.response, wanted)),
    first.box, second.box, make('div', { className: 'wide' }, tolerances), make('p', { className: 'row' }, start, stop, progress));
  const box = make('div', { className: 'studies' }, form, state, trouble, result);
  element.append(box);

  function showKind() {
    first.box.hidden = kind.value === 'tornado';
    second.box.hidden = kind.value !== 'map';
    tolerances.hidden = kind.value !== 'tornado';
    first.suggest();
    second.suggest();
  }
  kind.addEventListener('change', showKind);

  const ofResponse = (path) => ({ title: known.get(path)?.title ?? path, unit: known.get(path)?.unit ?? '' });

  function fillTolerances() {
    const isWhole = ({ text }) => /^\s*[-+]?\d+\s*$/.test(text);
    const rows = inputs.filter((input) => !isWhole(input)).map(({ path, text }, k) => {
      const use = make('input', { type: 'checkbox', checked: k < firstTolerances, attributes: { 'aria-label': `${texts.use}: ${title(path)}` } });
      const within = make('input', { type: 'text', value: '1 %', size: 18, attributes: { 'aria-label': `${texts.within}: ${title(path)}` } });
      const row = make('tr', {}, make('td', {}, use), make('th', { scope: 'row', textContent: title(path), title: path }), make('td', { textContent: text }), make('td', {}, within));
      return Object.assign(row, { chosen: () => (use.checked ? { path, within: within.value.trim() } : null) });
    });
    tolerances.replaceChildren(make('caption', { textContent: texts.within }), make('tbody', {}, ...rows));
    tolerances.chosen = () => rows.map((row) => row.chosen()).filter(Boolean);
  }

  /** Documents of the case, from the engine. */
  async function asked() {
    const host = engine();
    const found = {};
    try {
      for (const command of ['check', ...commands]) {
        if (found.check?.commands[command]?.ready === false) continue;
        const { document: answer } = await host.ask(question({ command }));
        if (answer) found[command] = answer;
      }
      return found;
    } finally {
      host.end?.();
    }
  }

  /** Reads what the case has: its inputs with numbers, and the responses of its commands. */
  async function refresh() {
    const { check, ...others } = await documents();
    if (!check?.input) return;
    inputs = check.input
      .filter(({ path, value, written, default: isDefault }) => !isDefault && split(written ?? value) && !/^(study|optimize|report)\b/.test(path))
      .map(({ path, value, written }) => ({ path, text: String(written ?? value) }));
    // The first two of the usual ones, of each one.
    const found = usual.map((each) => inputs.find(({ path }) => each.test(path))).filter(Boolean);
    const sorted = [...found, ...inputs.filter((input) => !found.includes(input))];
    for (const [select, at] of [[first.path, 0], [second.path, 1]]) {
      const before = select.value;
      select.replaceChildren(...inputs.map(({ path }) => new Option(title(path), path)));
      select.value = inputs.some(({ path }) => path === before) ? before : sorted[Math.min(at, sorted.length - 1)]?.path;
    }
    const paths = new Set();
    for (const command of commands)
      for (const path of others[command] ? responsePaths(others[command]) : [])
        if (known.size === 0 || known.has(path)) paths.add(path);
    const before = wanted.value;
    wanted.replaceChildren(...[...paths].map((path) => {
      const { title: words, unit } = ofResponse(path);
      return new Option(unit ? `${words} (${unit})` : words, path);
    }));
    wanted.value = paths.has(before) ? before : paths.has(firstResponse) ? firstResponse : [...paths][0];
    fillTolerances();
    showKind();
    start.disabled = inputs.length === 0;
    if (inputs.length === 0) state.textContent = texts.noInputs;
  }

  /** The picture with all its numbers below. */
  function show(picture, words, head, rows) {
    const cells = (tag) => (row) => make('tr', {}, ...row.map((cell, k) => make(k === 0 || tag === 'th' ? 'th' : 'td', { textContent: typeof cell === 'number' ? shown(cell) : (cell ?? '–') })));
    const save = button(texts.saveTable, () => {
      const link = make('a', { href: URL.createObjectURL(new Blob([csv([head, ...rows])], { type: 'text/csv' })), download: 'study.csv' });
      link.click();
      URL.revokeObjectURL(link.href);
    });
    result.replaceChildren(
      make('figure', {}, make('figcaption', { textContent: words }), make('div', { className: 'wide' }, picture),
        ...(kind.value === 'tornado' ? [make('p', { textContent: texts.legendTornado })] : [])),
      make('details', {}, make('summary', { textContent: texts.numbers }),
        make('div', { className: 'wide', tabIndex: 0 }, make('table', { className: 'quantities' }, make('thead', {}, ...[head].map(cells('th'))), make('tbody', {}, ...rows.map(cells('td'))))),
        save));
  }

  const withUnitOf = (words, unit) => (unit ? `${words} [${unit}]` : words);

  async function runCurve(path, y, options) {
    const asked = first.value();
    const found = await run.study(asked, path, options);
    const x = { title: title(asked.path), unit: found.unit };
    const own = split(inputs.find((input) => input.path === asked.path)?.text ?? '');
    const words = texts.titleCurve(y.title, x.title);
    const picture = curve({ ...found, baseValue: own?.unit === found.unit ? own.number : NaN, title: words, x, y });
    show(picture, words, [withUnitOf(x.title, x.unit), withUnitOf(y.title, y.unit), texts.reason],
      found.values.map((value, k) => [value, found.responses[k], found.reasons[k] ?? '']));
    return [found.responses, found.command];
  }

  async function runMap(path, z, options) {
    const [one, other] = [first.value(), second.value()];
    const found = await run.map([one, other], path, options);
    const [y, x] = [one, other].map((each, k) => ({ title: title(each.path), unit: found.units[k] }));
    const words = texts.titleMap(z.title, y.title, x.title);
    show(heatMap({ ...found, title: words, x, y, z, scale: colours }), words,
      [withUnitOf(y.title, y.unit), withUnitOf(x.title, x.unit), withUnitOf(z.title, z.unit), texts.reason],
      found.rows.flatMap((row, k) => found.columns.map((column, j) => [row, column, found.responses[k][j], found.reasons[k][j] ?? ''])));
    return [found.responses.flat(), found.command];
  }

  async function runTornado(path, y, options) {
    const found = await run.tornado(tolerances.chosen(), path, options);
    const bars = found.bars.map((bar) => ({ ...bar, title: title(bar.path) }));
    const words = texts.titleTornado(y.title);
    show(tornadoChart({ bars, base: found.base, title: words, y }), words,
      [texts.input, texts.ofCase, texts.lower, withUnitOf(y.title, y.unit), texts.upper, withUnitOf(y.title, y.unit), texts.reason],
      bars.map(({ title: input, value, texts: [low, high], responses: [atLow, atHigh], reasons }) => [input, value, low, atLow, high, atHigh, reasons.filter(Boolean).join(' ')]));
    return [bars.flatMap((bar) => bar.responses), found.command];
  }

  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    if (cancel) return;
    cancel = new AbortController();
    start.disabled = true;
    stop.disabled = false;
    trouble.textContent = '';
    state.textContent = '';
    progress.hidden = false;
    progress.removeAttribute('value');
    const options = {
      signal: cancel.signal,
      onProgress: (done, all) => {
        progress.max = all;
        progress.value = done;
        state.textContent = texts.running(done, all);
      },
    };
    try {
      const act = { curve: runCurve, map: runMap, tornado: runTornado }[kind.value];
      const [found, command] = await act(wanted.value, ofResponse(wanted.value), options);
      const failed = found.filter((value) => value === null).length;
      state.textContent = [texts.finished(found.length, command), ...(failed ? [texts.failed(failed)] : [])].join(', ');
    } catch (error) {
      if (error.name === 'AbortError') state.textContent = texts.cancelled;
      else {
        state.textContent = '';
        trouble.textContent = error.message;
      }
    } finally {
      cancel = null;
      start.disabled = false;
      stop.disabled = true;
      progress.hidden = true;
    }
  });
  stop.disabled = true;

  const isRead = refresh();
  return {
    ...run,
    isRead,
    refresh,
    dispose() {
      cancel?.abort();
      box.remove();
    },
  };
}
