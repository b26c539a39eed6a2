// The view of the mechanism, whose script stands packed in the page until it is looked at.
import { run } from './packed.js';

let mount = null;

/** The function `mount` of web/src/mechanism/mount.js. */
export const loadMechanism = () =>
  (mount ??= new Promise((resolve, reject) => {
    document.addEventListener('prs-mechanism', (event) => resolve(event.detail), { once: true });
    run('mechanism-script').catch(reject);
  }));
