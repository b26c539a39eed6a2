// Studies of one and of two inputs and of tolerances, design by design, in workers that ask the engine. Values
// and responses are those of `prs study` (docs/studies.md).
import { factorOf, split, withUnit } from '../page/quantity.js';
import { inputAt, response } from './response.js';

/** Commands that a response is looked for in, in this order. */
export const commands = ['solve', 'slip', 'measures', 'life', 'contact'];

/** Values between two ends, whose unit is the same: texts as in a case, and numbers in that unit. */
export function range({ from, to, steps, spacing = 'linear' }) {
  const [first, last] = [from, to].map((text) => split(text));
  if (!first || !last) throw new Error(`from, to: got ${from}, ${to}; expected numbers with their units, for example 10 kN`);
  if (first.unit !== last.unit) throw new Error(`from, to: got ${from}, ${to}; expected the same unit; write both in one`);
  if (!Number.isInteger(steps) || steps < 2) throw new Error(`steps: got ${steps}; expected a whole number from 2`);
  if (spacing === 'logarithmic' && !(first.number * last.number > 0))
    throw new Error(`from, to: got ${from}, ${to}; expected ends of one sign, and not 0, for logarithmic steps`);
  const numbers = Array.from({ length: steps }, (_, k) => {
    if (k === 0 || k === steps - 1) return (k === 0 ? first : last).number;
    const share = k / (steps - 1);
    return spacing === 'logarithmic'
      ? first.number * (last.number / first.number) ** share
      : first.number + (last.number - first.number) * share;
  });
  const texts = numbers.map((number) => withUnit(number, first.unit));
  return { texts, numbers: texts.map((text) => split(text).number), unit: first.unit };
}

/** Both ends of a tolerance about a value: `3 %`, `0.02 mm` or `[-0.01 mm, 0.03 mm]`. */
export function ends(value, within) {
  const base = split(value);
  if (!base) throw new Error(`got ${value}; expected a number with its unit in the case`);
  const [, list] = String(within).match(/^\s*\[(.*)\]\s*$/) ?? [];
  const amounts = (list ?? within).split(',').map((text) => {
    const deviation = split(text);
    const kelvin = deviation?.unit === 'K' && ['degC', '°C'].includes(base.unit);
    const isShare = deviation && (deviation.unit === '%' || (deviation.unit === '' && base.unit !== ''));
    const factor = !deviation ? NaN : isShare ? Math.abs(base.number) * (deviation.unit === '%' ? 0.01 : 1) : kelvin ? 1 : factorOf(deviation.unit, base.unit);
    if (isShare && (base.number === 0 || ['degC', '°C', 'degF'].includes(base.unit))) return NaN;
    return deviation ? deviation.number * factor : NaN;
  });
  const [below, above] = list === undefined ? [-amounts[0], amounts[0]] : amounts;
  if (amounts.length !== (list === undefined ? 1 : 2) || !(below < above))
    throw new Error(`within: got ${within}; expected a share, a half width in ${base.unit || 'the unit of the case'}, or lower and upper deviation: 3 %, or [-1 %, 2 %]`);
  return { texts: [below, above].map((amount) => withUnit(base.number + amount, base.unit)), unit: base.unit, base: base.number };
}

/** What `act` makes with several workers, which end with it, and at once where the signal says so. */
async function withWorkers(count, { engine, signal }, act) {
  signal?.throwIfAborted();
  const engines = Array.from({ length: count }, () => engine());
  let leave = null;
  const aborted = new Promise((_, reject) => {
    leave = () => reject(signal.reason);
    signal?.addEventListener('abort', leave);
  });
  try {
    return await Promise.race([act(engines), aborted]);
  } finally {
    signal?.removeEventListener('abort', leave);
    for (const each of engines) each.end?.();
  }
}

/** An answer to each question, by several workers side by side. */
async function answers(questions, engines, { onProgress, signal }) {
  const found = new Array(questions.length);
  let next = 0;
  let done = 0;
  const work = async (worker) => {
    while (next < questions.length && !signal?.aborted) {
      const k = next++;
      found[k] = await worker.ask(questions[k]);
      onProgress?.(++done, questions.length);
    }
  };
  await Promise.all(engines.map(work));
  return found;
}

/** The number that a design has, or why it has none. */
function outcome(answer, path) {
  const value = answer.document ? response(answer.document, path) : null;
  return { value, reason: value === null ? (answer.messages?.[0] ?? `the answer has no ${path}`) : null };
}

/**
 * `question(more)` is a question about the case at hand with more keys (prs/engine/engine.h); `engine()` a new
 * worker with `ask(question)` and `end()`; `workers` of them at most.
 */
export function studies({ question, engine, workers = Math.max(1, Math.min(4, (globalThis.navigator?.hardwareConcurrency ?? 2) - 1)) }) {
  /** The first command whose answer to the case has the response, and that answer. */
  async function choose(host, path, command) {
    let refusal = null; // Where no command answers: the first one's.
    let isAnswered = false;
    for (const name of command ? [command] : commands) {
      const answer = await host.ask(question({ command: name }));
      if (answer.document && response(answer.document, path) !== null) return { name, document: answer.document };
      if (answer.document) isAnswered = true;
      else refusal ??= answer;
    }
    throw new Error(refusal && !isAnswered ? refusal.messages.join('\n') : `${path}: the case has no number of that name; see \`prs list responses\``);
  }

  /** Numbers of the case with each list of values set, and of the case itself. */
  const run = (settings, path, { command, ...options }) =>
    withWorkers(Math.min(workers, settings.length), { engine, ...options }, async (engines) => {
      const { name, document } = await choose(engines[0], path, command);
      // What counts is the first load case: of `solve` and `contact` the others change nothing.
      const first = document.load_cases?.[0]?.name;
      const isAlone = ['solve', 'contact'].includes(name) && first && !first.includes('[') && !path.startsWith('load_cases[');
      const more = { command: name, ...(isAlone ? { load_cases: [first] } : {}) };
      const set = question({}).set ?? [];
      const questions = settings.map((pairs) => question({ ...more, set: [...set, ...pairs] }));
      const found = await answers(questions, engines, options);
      return { command: name, base: response(document, path), outcomes: found.map((answer) => outcome(answer, path)) };
    });

  const told = (outcomes) => ({ responses: outcomes.map(({ value }) => value), reasons: outcomes.map(({ reason }) => reason) });

  return {
    /** `{path, from, to, steps, spacing, command}`: {values, responses, reasons, unit, command, base}. */
    async study({ path, command, ...ends_ }, wanted, options = {}) {
      const { texts, numbers, unit } = range(ends_);
      const { outcomes, command: chosen, base } = await run(texts.map((text) => [[path, text]]), wanted, { command, ...options });
      return { values: numbers, ...told(outcomes), unit, command: chosen, base };
    },

    /** Of two such inputs: rows of the first, columns of the second; responses[row][column]. */
    async map([one, other], wanted, options = {}) {
      const [rows, columns] = [range(one), range(other)];
      const settings = rows.texts.flatMap((a) => columns.texts.map((b) => [[one.path, a], [other.path, b]]));
      const { outcomes, command, base } = await run(settings, wanted, { command: one.command, ...options });
      const lines = (list) => rows.texts.map((_, k) => list.slice(k * columns.texts.length, (k + 1) * columns.texts.length));
      const { responses, reasons } = told(outcomes);
      return {
        rows: rows.numbers, columns: columns.numbers, units: [rows.unit, columns.unit],
        responses: lines(responses), reasons: lines(reasons), command, base,
      };
    },

    /** Inputs `{path, within}`, each at both ends of its tolerance, one at a time; the largest effect first. */
    async tornado(inputs, wanted, { command, ...options } = {}) {
      const { document, messages } = await withWorkers(1, { engine, ...options }, ([host]) => host.ask(question({ command: 'check' })));
      if (!document) throw new Error(messages.join('\n'));
      const list = inputs.map(({ path, within }) => {
        const value = inputAt(document.resolved_input, path);
        if (value === undefined || typeof value === 'object') throw new Error(`${path}: got no single value in the case; write it there first`);
        try {
          return { path, within, value: String(value), ...ends(String(value), within) };
        } catch (error) {
          throw new Error(`${path}: ${error.message}`);
        }
      });
      const settings = list.flatMap(({ path, texts }) => texts.map((text) => [[path, text]]));
      const { outcomes, base, command: chosen } = await run(settings, wanted, { command, ...options });
      const { responses, reasons } = told(outcomes);
      const bars = list.map(({ path, within, value, texts }, k) => ({
        path, within, value, texts, responses: responses.slice(2 * k, 2 * k + 2), reasons: reasons.slice(2 * k, 2 * k + 2),
      }));
      const swing = ({ responses: [a, b] }) => Math.max(...[a, b].filter((x) => x !== null).map((x) => Math.abs(x - base)), 0);
      return { bars: bars.sort((a, b) => swing(b) - swing(a)), base, command: chosen };
    },
  };
}
