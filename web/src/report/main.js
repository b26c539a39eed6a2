// The live page: sliders and fields ask the engine, in workers of their own, for the sections of
// the report with other values. All HTML comes from the engine, which escapes the texts of the case;
// what this script shows of them it sets as text.

import { Engine, Latest } from '../page/engine.js';
import { showMechanism } from './mechanism.js';

const element = (id) => document.getElementById(id);
const theCase = JSON.parse(element('case').textContent);

// What is changed --------------------------------------------------------------------------------

/** Values by their paths, as `--set` takes them. */
const changes = new Map();

const overrides = () => [...theCase.set, ...changes];

/** A question about the case as it is now; of its report, what `report` asks for. */
const question = (more) => ({ command: 'report', ...theCase, set: overrides(), ...more });
const { units } = document.documentElement.dataset;
const reportQuestion = (report) => question({ report: { own: theCase.set.length, units, ...report } });

// Sections ---------------------------------------------------------------------------------------

const quickSections = ['verdict', 'mechanism', 'loads', 'pressures', 'stiffness'];

const isOnScreen = (id) => {
  const box = element(id).getBoundingClientRect();
  return box.bottom > -100 && box.top < innerHeight + 100;
};

/** Numbers that follow later stay as they are, in grey. */
function keepStaleTiles(old, fresh) {
  const place = fresh.querySelector('.tiles');
  if (!place) return;
  let before = null;
  for (const tile of old.querySelectorAll('[data-tile]')) {
    const now = fresh.querySelector(`[data-tile="${tile.dataset.tile}"]`);
    if (now) {
      before = now;
      continue;
    }
    const stale = tile.cloneNode(true);
    stale.className = 'stale';
    const state = stale.querySelector('.state');
    if (state) state.replaceWith('computed when the values rest');
    if (before) before.after(stale);
    else place.prepend(stale);
    before = stale;
  }
}

/** Of the sections as they stand: what is the same again is not drawn again. */
const shown = new Map();

function showSection(id, html, quick) {
  const told = `${id === 'verdict' && quick}${html}`;
  if (shown.get(id) === told) return;
  shown.set(id, told);
  const section = element(id);
  const body = section.querySelector('.body');
  const template = document.createElement('template');
  template.innerHTML = html;
  if (quick && id === 'verdict') keepStaleTiles(body, template.content);
  const scrolled = [...body.querySelectorAll('.wide')].map((box) => box.scrollLeft);
  const focused = [...body.querySelectorAll('.wide')].indexOf(document.activeElement);
  const opened = [...body.querySelectorAll('details[open] > summary')].map((s) => s.textContent);
  for (const summary of template.content.querySelectorAll('summary'))
    summary.parentElement.open = opened.includes(summary.textContent);
  body.replaceChildren(template.content);
  const boxes = body.querySelectorAll('.wide');
  scrolled.forEach((left, k) => {
    if (left && boxes[k]) boxes[k].scrollLeft = left;
  });
  if (focused >= 0) boxes[focused]?.focus({ preventScroll: true });
  const empty = html === '';
  section.hidden = empty;
  document.querySelector(`nav a[href="#${id}"]`).parentElement.hidden = empty;
}

const trouble = element('trouble');

/** The first of several, without its place in the file: the reader moved a slider. */
function told(messages) {
  const first = (messages[0] ?? '').replace(/^.*?:\d+:\d+: error: /, '').replace(/ \(from --set .*\)$/, '');
  return messages.length > 1 ? `${first}\n(and ${messages.length - 1} more)` : first;
}

function show(answer, asked) {
  const wrong = answer.status === 1 || answer.status === 2;
  const wasWrong = document.body.classList.contains('is-wrong');
  trouble.textContent = wrong ? told(answer.messages) : '';
  for (const control of controls) control.mark(wrong && answer.messages.join('\n'));
  if (document.body.classList.toggle('is-wrong', wrong) !== wasWrong) showChanges();
  if (wrong) return;
  for (const [id, html] of Object.entries(answer.document.sections)) showSection(id, html, asked.report.quick);
  // What this engine cannot compute stays as the report has it, in grey where values have moved.
  for (const id of answer.document.kept ?? [])
    element(id).querySelector('.body').classList.toggle('stale', changes.size > 0);
  showHead(answer.document.head);
  if (answer.document.threads) takeThreads(answer.document.threads);
}

/** A quick answer has none: the one that stands is grey until it follows. */
function showHead(html) {
  const head = document.querySelector('header');
  head.classList.toggle('stale', !html);
  if (html) head.innerHTML = html;
}

let settled = true; // Whether all numbers are those of the values.

const quick = new Latest((answer, asked) => settled || show(answer, asked));
const complete = new Latest((answer, asked) => {
  // An older answer must not replace what follows the slider by now.
  if (JSON.stringify(asked.set) !== JSON.stringify(overrides())) return;
  show(answer, asked);
  if (asked.report.sections) return;
  settled = true;
  element('state').textContent =
    answer.status !== 0
      ? 'See the message below.'
      : !changes.size
        ? ''
        : answer.document.all_follow
          ? 'All numbers follow.'
          : 'Not all numbers follow: those in grey say why.';
  if (answer.status === 3) element('state').textContent = 'A load case did not converge.';
  document.dispatchEvent(new CustomEvent('prs-complete', { detail: answer.status }));
  // Another count of threads moves the choice.
  if (JSON.stringify(chosenThread()) !== JSON.stringify(asked.report.thread)) askThread();
});

let completion = 0;

/** Shows the changed case: at once what is on the screen, and all when the values rest. */
function follow(resting) {
  showChanges();
  settled = false;
  element('state').textContent = 'Computing …';
  quick.put(() => reportQuestion({ quick: true, sections: quickSections.filter(isOnScreen) }));
  clearTimeout(completion);
  completion = setTimeout(showAll, resting ? 0 : 300);
}

function showAll() {
  clearTimeout(completion);
  complete.put(() => reportQuestion({ thread: chosenThread() }));
}

// What differs -----------------------------------------------------------------------------------

function showChanges() {
  const wrong = document.body.classList.contains('is-wrong');
  const changed = element('changed');
  changed.hidden = changes.size === 0;
  changed.textContent = '';
  if (changes.size === 0) return;
  const told = controls.filter((c) => c.isChanged).map((c) => `${c.title} ${c.value} (${c.own})`);
  const strong = document.createElement('strong');
  strong.textContent = wrong
    ? 'These values cannot be computed, and the numbers are those before them: '
    : 'This page differs from the report: ';
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Reset';
  button.addEventListener('click', reset);
  changed.append(strong, `${told.join(', ')}. ${wrong ? '' : 'Grey: the report. '}`, button);
}

function reset() {
  for (const control of controls) control.reset();
  changes.clear();
  follow(true);
}

// Sliders and fields -----------------------------------------------------------------------------

/** A number as short as its place on a slider of this length needs. */
function short(value, length) {
  const digits = Math.max(0, 3 - Math.floor(Math.log10(length)));
  return String(Number(value.toFixed(Math.min(12, digits))));
}

class Control {
  constructor(place) {
    this.paths = place.dataset.paths.split(' ');
    this.own = place.dataset.value;
    this.title = place.querySelector('label').textContent;
    [this.text, this.slider] = place.querySelectorAll('input');
    this.unit = this.slider.dataset.unit;
    this.slider.addEventListener('input', () => {
      const whole = this.slider.step === '1';
      const length = this.slider.max - this.slider.min;
      const number = whole ? this.slider.value : short(Number(this.slider.value), length);
      this.text.value = this.unit ? `${number} ${this.unit}` : number;
      this.slider.classList.remove('stale');
      this.set(this.text.value);
      follow(false);
    });
    this.slider.addEventListener('change', showAll);
    this.text.addEventListener('change', () => {
      this.set(this.withUnit(this.text.value.trim()) || this.own);
      this.moveSlider();
      follow(true);
    });
  }

  get value() {
    return this.text.value;
  }

  get isChanged() {
    return changes.has(this.paths[0]);
  }

  /** A number alone has the unit of the value that stood there. */
  withUnit(typed) {
    const shown = changes.get(this.paths[0]) ?? this.own;
    const [, unit = this.unit] = shown.match(/^[-+]?[\d.]+(?:e[-+]?\d+)?(?![\d.])\s*(\S.*)$/i) ?? [];
    return unit && /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(typed) ? `${typed} ${unit}` : typed;
  }

  set(value) {
    for (const path of this.paths)
      if (value === this.own) changes.delete(path);
      else changes.set(path, value);
    this.text.value = value;
  }

  moveSlider() {
    const [, number, unit] = this.value.match(/^\s*([-+\d.eE]+)\s*(.*?)\s*$/) ?? [];
    const fits =
      (unit === this.unit || unit === '') &&
      number - this.slider.min >= 0 &&
      this.slider.max - number >= 0;
    this.slider.classList.toggle('stale', !fits);
    if (fits) this.slider.value = number;
  }

  reset() {
    this.set(this.own);
    this.moveSlider();
  }

  mark(messages) {
    const wrong = Boolean(messages) && this.paths.some((path) => messages.includes(path));
    this.text.toggleAttribute('aria-invalid', wrong);
  }
}

const controls = [...document.querySelectorAll('.control')].map((place) => new Control(place));
element('controls').addEventListener('submit', (event) => event.preventDefault());
element('reset').addEventListener('click', reset);

// Copies -----------------------------------------------------------------------------------------

const quoted = (word) =>
  /^[\w./:,+@%[\]=-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;

async function copy(title, text) {
  element('copy-title').textContent = title;
  element('copy-text').value = text;
  element('copied').textContent = '';
  element('copy').showModal();
  element('copy-text').select();
  try {
    await navigator.clipboard.writeText(text);
    element('copied').textContent = 'Copied.';
  } catch {
    element('copied').textContent = 'Copy it from here.';
  }
}

element('copy-set').addEventListener('click', () => {
  const sets = overrides().map(([path, value]) => ` --set ${quoted(`${path}=${value}`)}`);
  copy('The same on the command line', `prs report ${quoted(theCase.file)}${sets.join('')}`);
});

element('copy-yaml').addEventListener('click', async () => {
  const answer = await complete.engine.ask(question({ command: 'write' }));
  copy('The case with these values', answer.document?.yaml ?? answer.messages.join('\n'));
});

// One thread -------------------------------------------------------------------------------------

const threadCase = element('thread-case');
const threadNumber = element('thread-number');
const threadRoller = element('thread-roller');
let threadsOfRoller = 1;
let threadIsShown = false;

function chosenThread() {
  if (!threadIsShown) return undefined;
  const roller = Math.max(1, Number(threadRoller.value) || 1);
  const thread = Math.max(1, Number(threadNumber.value) || 1);
  return {
    load_case: Number(threadCase.value) || 0,
    thread: (roller - 1) * threadsOfRoller + thread - 1,
  };
}

function askThread() {
  threadIsShown = true;
  element('thread').hidden = false;
  document.querySelector('nav a[href="#thread"]').parentElement.hidden = false;
  document.dispatchEvent(new Event('prs-thread'));
  if (!settled) return showAll();
  complete.put(() => reportQuestion({ sections: ['thread'], thread: chosenThread() }));
}

/** How many threads and rollers there are to choose from. */
function takeThreads(choices) {
  threadsOfRoller = choices.threads;
  for (const [field, most] of [[threadNumber, choices.threads], [threadRoller, choices.rollers]]) {
    field.max = most;
    if (Number(field.value) > most) field.value = most;
  }
  element('roller-label').hidden = choices.rollers === 1;
}

function fillThreadForm() {
  const choices = JSON.parse(element('threads').textContent);
  if (!choices) return;
  takeThreads(choices);
  choices.cases.forEach((name, k) => threadCase.append(new Option(name, k)));
  threadCase.value = choices.load_case;
  threadNumber.value = (choices.thread % threadsOfRoller) + 1;
  threadRoller.value = Math.floor(choices.thread / threadsOfRoller) + 1;
  element('thread').hidden = false;
  document.querySelector('nav a[href="#thread"]').parentElement.hidden = false;
}

element('thread-form').addEventListener('input', askThread);
element('thread-form').addEventListener('submit', (event) => event.preventDefault());

// Its pictures are made when it is first looked at.
new IntersectionObserver((seen, observer) => {
  if (!seen.some((entry) => entry.isIntersecting)) return;
  observer.disconnect();
  if (!threadIsShown && threadCase.length > 0) askThread();
}).observe(element('thread-form'));

// Pictures over threads have a field that says where which thread stands.
document.querySelector('main').addEventListener('click', (event) => {
  const field = event.target.closest('.pick');
  if (!field) return;
  const box = field.getBoundingClientRect();
  const at = (share, ends) => {
    const [from, to] = ends.split(' ').map(Number);
    return Math.max(1, Math.round(from + share * (to - from)));
  };
  threadNumber.value = at((event.clientX - box.left) / box.width, field.dataset.threads);
  if (field.dataset.rollers)
    threadRoller.value = at((box.bottom - event.clientY) / box.height, field.dataset.rollers);
  askThread();
  element('thread').scrollIntoView();
});

// The mechanism in three dimensions ---------------------------------------------------------------

const thread = {
  chosen: () => ({
    load_case: Number(threadCase.value) || 0,
    roller: Number(threadRoller.value) - 1,
    thread: Number(threadNumber.value) - 1,
  }),
  choose: ({ load_case: loadCase, roller, thread: number }) => {
    if (threadCase.length === 0) return;
    threadCase.value = loadCase;
    threadRoller.value = roller + 1;
    threadNumber.value = number + 1;
    askThread();
  },
};

// Start ------------------------------------------------------------------------------------------

fillThreadForm();
const panel = element('live');
const wide = matchMedia('(min-width: 64rem)');
const details = panel.querySelector('details');
details.open = wide.matches;
wide.addEventListener('change', () => (details.open = wide.matches));
panel.hidden = false;

/** The engine of this page, for its reader's console: `await prs.ask({command: 'solve'})`. */
globalThis.prs = {
  changes,
  ask: (more) => (complete.engine ??= new Engine()).ask(question(more)),
};

showMechanism({ ask: globalThis.prs.ask, thread });

// Ready before the first slider moves.
const idle = globalThis.requestIdleCallback ?? ((run) => setTimeout(run, 200));
idle(() => {
  if (!quick.engine) {
    quick.engine = new Engine();
    quick.engine.ask(reportQuestion({ quick: true }));
  }
  complete.engine ??= new Engine();
});
