// A study of one input: the engine is asked design by design, in workers of its own.
import { Engine } from '../page/engine.js';
import { responseIn } from './headlines.js';
import { current, questionOf } from './store.js';

/** The commands whose documents may have a response, by the first key of its path. */
export const commandsFor = (path) =>
  ({ slip: ['slip'], heat: ['slip'], life: ['life'], measures: ['measures'], preload: ['preload'], contact: ['contact'] })[
    path.split('.')[0]
  ] ?? ['solve', 'contact'];

const quantity = (text) => {
  const [, number, unit] = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i.exec(String(text)) ?? [];
  if (number === undefined) throw new Error(`got ${text}; expected a number with its unit`);
  return { number: Number(number), unit };
};

/** {values: [], texts: []} from the first to the last, in the unit of the first. */
export function designs({ from, to, steps }) {
  const [first, last] = [quantity(from), quantity(to)];
  if (first.unit !== last.unit) throw new Error(`got ${from} and ${to}; expected one unit for both`);
  const count = Math.max(2, Math.round(Number(steps)));
  const values = Array.from({ length: count }, (_, k) =>
    k === count - 1 ? last.number : first.number + (k * (last.number - first.number)) / (count - 1));
  return { values, texts: values.map((x) => `${x} ${first.unit}`.trim()), unit: first.unit };
}

/**
 * Asks every question, several at once; `told(done, all)` as they are answered. Answers in the order of
 * the questions; null for those that were not asked, because `signal` ended the run.
 */
export async function askAll(questions, { told = () => {}, signal } = {}) {
  const answers = new Array(questions.length).fill(null);
  let next = 0;
  let done = 0;
  const count = Math.min(questions.length, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 0), 8);
  const engines = Array.from({ length: count }, () => new Engine());
  const end = () => engines.forEach((each) => each.end());
  signal?.addEventListener('abort', end);
  await Promise.all(engines.map(async (engine) => {
    while (next < questions.length && !signal?.aborted) {
      const k = next++;
      const answer = await engine.ask(questions[k]);
      answers[k] = answer.ended ? null : answer;
      told(++done, questions.length);
    }
  }));
  end();
  return answers;
}

/** The response for each value of an input: {values, responses, unit}; null where it has none. */
export async function study({ path, from, to, steps }, response, how = {}) {
  const v = current();
  if (!v) throw new Error('no case is open; open one first');
  const { values, texts, unit } = designs({ from, to, steps });
  let responses = [];
  for (const command of commandsFor(response)) {
    const answers = await askAll(texts.map((text) => questionOf(v, { command, set: [[path, text]] })), how);
    responses = answers.map((answer) => (answer?.document ? responseIn(answer.document, response, 0) ?? null : null));
    if (responses.some((x) => x !== null)) break;
    const wrong = answers.find((answer) => answer?.status === 2);
    if (wrong && command === commandsFor(response).at(-1)) throw new Error(wrong.messages.join('\n'));
  }
  return { values, responses, unit };
}
