// The section "Mechanism" of the report: the view in three dimensions above the picture that stands there.
import { loadMechanism } from '../page/mechanism.js';

const commands = ['slip', 'solve', 'contact']; // The first says most.

/** What the page carries of the case as it was written. */
function carried() {
  const { results, resolved_input: input } = JSON.parse(document.querySelector('script#data').textContent);
  // A document that was too long is not there; one that says less is no answer then.
  const command = document.querySelector('#slip:not([hidden])') ? 'slip' : 'solve';
  return results[command] ? { ...results[command], resolved_input: input } : null;
}

/** The document of the case with the values as they are now; null where no command answers. */
async function documentOf(ask) {
  for (const command of commands) {
    const { status, document } = await ask({ command });
    if (document && (status === 0 || status === 3)) return document;
  }
  return null;
}

/**
 * Shows the view once the section is in sight, where the browser has WebGL. `thread` is that of the
 * section "One thread": { chosen(), choose(thread) }, threads by load case, roller and thread from 0.
 */
export function showMechanism({ ask, thread }) {
  const section = document.getElementById('mechanism');
  if (!globalThis.WebGL2RenderingContext) return;
  let view = null;
  let isStarted = false;
  let isSeen = false;
  let isStale = false; // Whether values changed since it was drawn.

  async function update() {
    isStale = false;
    const found = await documentOf(ask);
    if (found) view.update(found);
  }

  async function start() {
    const own = isStale ? null : carried();
    const [found, mount] = await Promise.all([own ?? documentOf(ask), loadMechanism()]);
    if (!found?.contact) return;
    const place = document.createElement('div');
    section.querySelector('.body').before(place);
    const { load_case: loadCase, ...chosen } = thread.chosen();
    view = mount(place, { document: found, loadCase, onThread: thread.choose, link: '#thread' });
    view?.select(chosen);
    if (view) document.addEventListener('prs-thread', () => view.select(thread.chosen()));
  }

  async function bring() {
    if (!isStarted) {
      isStarted = true;
      await start();
    }
    if (view && isSeen && isStale) update();
  }

  new IntersectionObserver((seen) => {
    isSeen = seen.at(-1).isIntersecting;
    if (isSeen) bring();
  }).observe(section);
  document.addEventListener('prs-complete', () => {
    isStale = true;
    if (isSeen) bring();
  });
}
