// Studies of the case at hand, see web/src/studies.
import { Engine } from '../page/engine.js';
import { studies } from '../studies/study.js';
import { current, questionOf } from './store.js';

export const engine = () => new Engine();

export function question(more) {
  if (!current()) throw new Error('no case is open; open one first');
  return questionOf(current(), more);
}

/** `study({path, from, to, steps}, response)`: {values, responses, ..}. */
export const { study } = studies({ question, engine });
