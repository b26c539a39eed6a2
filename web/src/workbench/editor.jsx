// The text of the case: an edit here shows in the form, and one there here. It stands in a shadow
// root, where the page's policy lets the editor bring its own style.
import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import { yaml } from '@codemirror/lang-yaml';
import { HighlightStyle, syntaxHighlighting, indentOnInput } from '@codemirror/language';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Compartment, EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { useEffect, useRef } from 'preact/hooks';
import { current, edit, redo, undo } from './store.js';
import { t } from './texts.js';

const colours = HighlightStyle.define([
  { tag: tags.propertyName, color: 'var(--link)' },
  { tag: [tags.comment, tags.lineComment], color: 'var(--quiet)' },
  { tag: [tags.string, tags.content], color: 'var(--ink)' },
  { tag: tags.keyword, color: 'var(--good)' },
]);

const look = EditorView.theme({
  '&': { height: '100%', fontSize: '.82rem', color: 'var(--ink)', backgroundColor: 'var(--paper)' },
  '&.cm-focused': { outline: '2px solid var(--link)' },
  '.cm-scroller': { fontFamily: 'ui-monospace, SFMono-Regular, Menlo, Consolas, monospace', overflow: 'auto' },
  '.cm-gutters': { backgroundColor: 'var(--band)', color: 'var(--quiet)', border: '0' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--band)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '&.cm-focused .cm-selectionBackground, .cm-selectionBackground': { backgroundColor: 'var(--line) !important' },
  '.cm-panels': { backgroundColor: 'var(--band)', color: 'var(--ink)' },
  '.cm-tooltip': { backgroundColor: 'var(--band)', color: 'var(--ink)', border: '1px solid var(--line)' },
});

const fromOutside = new Compartment();

/** What the engine says of lines: `case.yaml:12:7: error: ..`. */
function diagnostics(view, messages) {
  const found = [];
  for (const message of messages) {
    const [, line, column, kind, text] = /:(\d+):(\d+): (error|warning): ([\s\S]*)$/.exec(message) ?? [];
    if (!line || Number(line) > view.state.doc.lines) continue;
    const at = view.state.doc.line(Number(line));
    const from = Math.min(at.from + Number(column) - 1, at.to);
    found.push({ from, to: at.to, severity: kind, message: text });
  }
  return found;
}

export function Editor() {
  const place = useRef(null);
  const view = useRef(null);
  const v = current();

  useEffect(() => {
    const root = place.current.shadowRoot ?? place.current.attachShadow({ mode: 'open' });
    let own = false;
    const turn = (act) => () => (act(), true);
    view.current = new EditorView({
      root,
      parent: root,
      state: EditorState.create({
        doc: current().text,
        extensions: [
          lineNumbers(), drawSelection(), highlightActiveLine(), indentOnInput(), lintGutter(), search({ top: true }),
          highlightSelectionMatches(), yaml(), syntaxHighlighting(colours), look, fromOutside.of([]),
          EditorView.contentAttributes.of({ 'aria-label': t('yamlLabel'), tabindex: '0' }),
          keymap.of([
            { key: 'Mod-z', run: turn(undo) }, { key: 'Mod-y', run: turn(redo) }, { key: 'Mod-Shift-z', run: turn(redo) },
            ...searchKeymap, ...defaultKeymap, indentWithTab,
          ]),
          EditorView.updateListener.of((update) => {
            if (!update.docChanged || own) return;
            const text = update.state.doc.toString();
            edit(current().text.includes('\r\n') ? text.replaceAll('\n', '\r\n') : text, 'editor');
          }),
        ],
      }),
    });
    view.current.take = (ours) => {
      const text = ours.replaceAll('\r\n', '\n');
      const old = view.current.state.doc.toString();
      if (old === text) return;
      let from = 0;
      while (from < old.length && old[from] === text[from]) ++from;
      let end = 0;
      while (end < Math.min(old.length, text.length) - from && old.at(-1 - end) === text.at(-1 - end)) ++end;
      own = true;
      view.current.dispatch({ changes: { from, to: old.length - end, insert: text.slice(from, text.length - end) } });
      own = false;
    };
    return () => view.current.destroy();
  }, []);

  useEffect(() => {
    view.current.take(v.text);
    view.current.dispatch(setDiagnostics(view.current.state, diagnostics(view.current, v.messages)));
  });

  return (
    <div class="editor">
      <p class="hint">{t('yamlHint')}</p>
      <div class="editor-place" ref={place} />
    </div>
  );
}
