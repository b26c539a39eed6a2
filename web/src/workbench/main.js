// The workbench: the program as one page. Scripts and the browser's console drive it by `prs`.
import { h, render } from 'preact';
import { App, saveCase } from './app.jsx';
import {
  addVariant, ask, changed, current, onChange, open, page, redo, set, setUnits, state, toggleSection, undo, warm,
} from './store.js';
import { takeFiles } from './start.jsx';
import { studiesOf } from './studies.jsx';

const place = document.getElementById('workbench');
const draw = () => render(h(App), place);
onChange(draw);

const answered = (v) => ({ status: v.status, messages: v.messages });

globalThis.prs = {
  open: async (yaml, file) => {
    await open(String(yaml), file);
    return answered(current());
  },
  yaml: () => current()?.text ?? '',
  set: (path, text) => set(path, text),
  undo: () => undo(),
  redo: () => redo(),
  ask: (question) => ask(question),
  variants: () => state.variants.map(({ name, text }) => ({ name, yaml: text })),
  addVariant: async (name) => {
    await addVariant(name);
    return answered(current());
  },
  study: async (range, response) => {
    const { values, responses, unit } = await studiesOf().study({ ...range, steps: Number(range.steps) }, response);
    return { values, responses, unit };
  },
  units: setUnits,
};

document.addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key === 's' && current()) {
    event.preventDefault();
    saveCase();
  }
  // Fields have an undo of their own while somebody types.
  if (key === 'z' && !/^(INPUT|TEXTAREA)$/.test(event.target.tagName) && !event.target.shadowRoot) {
    event.preventDefault();
    (event.shiftKey ? redo : undo)();
  }
});

// Files that are dropped anywhere are opened.
document.addEventListener('dragover', (event) => event.preventDefault());
document.addEventListener('drop', (event) => {
  if (!event.dataTransfer?.files.length) return;
  event.preventDefault();
  takeFiles([...event.dataTransfer.files]);
});

// A word leads to its meaning, in a section that may be closed.
document.addEventListener('click', async (event) => {
  const id = event.target.closest?.('a.term')?.getAttribute('href').slice(1);
  if (!id) return;
  event.preventDefault();
  await toggleSection('glossary', true);
  changed();
  requestAnimationFrame(() => document.getElementById(id)?.scrollIntoView());
});

draw();
if (page.opened) {
  open(page.opened.yaml, page.opened.file.replace(/^.*[\\/]/, '')).then(async () => {
    for (const [path, value] of page.opened.set) await set(path, value);
  });
}
(globalThis.requestIdleCallback ?? ((run) => setTimeout(run, 100)))(warm);
