// The page: header, variants, inputs, views.
import { useEffect, useState } from 'preact/hooks';
import { Commands, Size } from './commands.jsx';
import { Compare } from './compare.jsx';
import { Editor } from './editor.jsx';
import { saveFile } from './files.js';
import { Form } from './form.jsx';
import { reportPage } from './report_page.js';
import { Results } from './results.jsx';
import { FileButton, Start } from './start.jsx';
import {
  addVariant, changed, chooseVariant, current, lacking, mostVariants, otherFile, page, redo, removeVariant, setUnits, state, stop, undo,
} from './store.js';
import { Studies } from './studies.jsx';
import { t } from './texts.js';
import { prose } from './units.js';

const isWrong = () => current()?.status === 2 || current()?.status === 1;

export function saveCase() {
  const v = current();
  if (v) saveFile(/\.ya?ml$/i.test(v.file) ? v.file.replace(/^.*[\\/]/, '') : `${v.name}.yaml`, 'text/yaml', v.text);
}

function Header({ starts, setStarts }) {
  const v = current();
  const report = async () => {
    try {
      const { name, html } = await reportPage();
      saveFile(name, 'text/html', html);
    } catch (error) {
      state.note = error.message;
      changed();
    }
  };
  return (
    <header class="bar">
      <h1>{t('title')}</h1>
      <div class="tools" role="toolbar" aria-label={t('file')}>
        <button type="button" aria-pressed={starts} onClick={() => setStarts(!starts)}>{t('newCase')}</button>
        <FileButton id="open-file" label={t('open')} done={() => setStarts(false)} />
        <button type="button" disabled={!v} onClick={saveCase}>{t('save')}</button>
        <button type="button" disabled={!v || Boolean(otherFile(v.text))} onClick={report}>{t('saveReport')}</button>
        <button type="button" disabled={!v?.done.length} onClick={undo}>{t('undo')}</button>
        <button type="button" disabled={!v?.undone.length} onClick={redo}>{t('redo')}</button>
        <label for="units" class="small">{t('units')}</label>
        <select id="units" value={state.units} onChange={(event) => setUnits(event.currentTarget.value)}>
          <option value="si">SI</option><option value="us">US</option>
        </select>
      </div>
    </header>
  );
}

/** Arrow keys move between tabs. */
function moveByKeys(event) {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (!step) return;
  const tabs = [...event.currentTarget.querySelectorAll('[role=tab]')];
  const next = tabs[(tabs.indexOf(document.activeElement) + step + tabs.length) % tabs.length];
  event.preventDefault();
  next.focus();
  next.click();
}

function Variants() {
  return (
    <div class="variants">
      <div role="tablist" aria-label={t('variants')} onKeyDown={moveByKeys}>
        {state.variants.map((v, k) => (
          <button type="button" key={k} role="tab" aria-selected={k === state.current} aria-controls="case" tabindex={k === state.current ? 0 : -1}
            onClick={() => chooseVariant(k)}>{v.name}</button>
        ))}
      </div>
      <label for="variant-name" class="small">{t('renameVariant')}</label>
      <input id="variant-name" class="variant-name" value={current().name}
        onChange={(event) => { current().name = event.currentTarget.value.trim() || current().name; changed(); }} />
      {state.variants.length < mostVariants && (
        <button type="button" title={t('variantHint')} onClick={() => addVariant()}>+ {t('addVariant')}</button>
      )}
      {state.variants.length > 1 && (
        <button type="button" class="quiet" aria-label={t('removeVariant', current().name)} title={t('removeVariant', current().name)} onClick={() => removeVariant(state.current)}>×</button>
      )}
      <p class="status" role="status">
        {state.busy ? <>{t('computing')} <button type="button" class="quiet" onClick={stop}>{t('stop')}</button></> : isWrong() ? '' : t('ready')}
      </p>
    </div>
  );
}

function Views() {
  const other = otherFile(current().text);
  const views = other
    ? [['size', Size], ['commands', Commands]]
    : [['results', Results], ['compare', Compare], ['studies', Studies], ['commands', Commands]];
  const [chosen, View] = views.find(([name]) => name === state.view) ?? views[0];
  return (
    <div class="views" id="results">
      <div role="tablist" aria-label={t('views')} class="tabs" onKeyDown={moveByKeys}>
        {views.map(([name]) => (
          <button type="button" key={name} id={`tab-${name}`} role="tab" aria-selected={name === chosen} aria-controls="view" tabindex={name === chosen ? 0 : -1}
            onClick={() => { state.view = name; changed(); }}>{t(name)}</button>
        ))}
      </div>
      <div id="view" role="tabpanel" aria-labelledby={`tab-${chosen}`}>
        {isWrong() && <p class="trouble" role="alert">{t('wrong')}<br /><span>{prose(current().messages.filter((line) => /error/.test(line)).slice(0, 3).join('\n'))}</span></p>}
        <View />
      </div>
    </div>
  );
}

const panes = ['form', 'yaml', 'results'];

/** What a narrow window shows of the case; a wide one shows all. */
function Panes({ pane, setPane }) {
  return (
    <div class="panes" role="group" aria-label={t('views')}>
      {panes.map((name) => (
        <button type="button" key={name} class={`pane-of-${name}`} aria-pressed={pane === name} onClick={() => { setPane(name); scrollTo(0, 0); }}>{t(name)}</button>
      ))}
    </div>
  );
}

function Inputs() {
  return (
    <div class="inputs">
      <section class="form-part" aria-label={t('inputs')}><Form key={state.current} /></section>
      <section class="yaml-part" aria-label={t('yaml')}><Editor key={state.current} /></section>
    </div>
  );
}

export function App() {
  const [starts, setStarts] = useState(false);
  const [pane, setPane] = useState('form');
  const v = current();
  useEffect(() => {
    document.title = v ? `${v.name} · ${t('title')}` : t('title');
  });
  const close = () => setStarts(false);
  const files = v ? lacking(v) : [];
  return (
    <>
      <a class="skip" href="#results">{t('skip')}</a>
      <Header starts={starts || !v} setStarts={setStarts} />
      {state.note && <p class="note" role="status">{state.note} <button type="button" class="quiet" aria-label={t('remove', '')} onClick={() => { state.note = ''; changed(); }}>×</button></p>}
      {files.length > 0 && <p class="note" role="status">{t('missingFile', files.join(', '))} <FileButton id="missing-file" label={t('open')} /></p>}
      {(starts || !v) && (v ? <aside class="start-place" aria-label={t('start')}><Start done={close} /></aside> : <main class="start-place" id="results"><Start done={close} /></main>)}
      {v && (
        <main>
          <Variants />
          <Panes pane={pane} setPane={setPane} />
          <div class={`case shows-${pane}`} id="case" role="tabpanel" aria-label={v.name}>
            <Inputs />
            <Views />
          </div>
        </main>
      )}
      <footer class="foot"><p>{t('footer', page.version)}</p></footer>
    </>
  );
}
