// Headlines, verdict, warnings and the sections of the report.
import { useLayoutEffect, useRef } from 'preact/hooks';
import { Mechanism } from './mechanism.jsx';
import { headlinesOf, loadCaseNames } from './headlines.js';
import { changed, current, page, state, toggleSection } from './store.js';
import { t } from './texts.js';
import { number, prose, quantity, shownIn } from './units.js';

const capital = (text) => text.replace(/^./, (c) => c.toUpperCase());

export function LoadCaseChoice() {
  const names = loadCaseNames(current());
  if (names.length < 2) return null;
  return (
    <p class="load-case">
      <label for="load-case">{t('loadCase')}</label>{' '}
      <select id="load-case" value={Math.min(state.loadCase, names.length - 1)}
        onChange={(event) => { state.loadCase = Number(event.currentTarget.value); changed(); }}>
        {names.map((name, k) => <option value={k}>{name}</option>)}
      </select>
    </p>
  );
}

export function Headlines() {
  // Of a text that cannot be read those of the one before, in grey.
  const stale = !current().documents.contact;
  const v = stale ? { documents: current().before } : current();
  const all = headlinesOf(v);
  const tiles = (rows) => (
    <dl class="tiles headlines">
      {rows.map(({ path, value, unit, title: name }) => {
        const shown = quantity(value, path, unit, state.units);
        return (
          <div key={path}>
            <dt>{capital(name)}</dt>
            <dd><div class="value" data-quantity={path} data-value={value}>{shown.text} <small>{shown.unit}</small></div></dd>
          </div>
        );
      })}
    </dl>
  );
  const ofCase = all.filter((row) => !row.whole);
  const whole = all.filter((row) => row.whole);
  const names = loadCaseNames(v);
  return (
    <section aria-labelledby="headlines-title" class={stale ? 'stale' : undefined}>
      <h2 id="headlines-title">{t('headlines')}</h2>
      <LoadCaseChoice />
      {ofCase.length > 0 && <><h3>{t('ofLoadCase', names[Math.min(state.loadCase, names.length - 1)] ?? '')}</h3>{tiles(ofCase)}</>}
      {whole.length > 0 && <><h3>{t('ofCase')}</h3>{tiles(whole)}</>}
    </section>
  );
}

export function Verdict() {
  const verdict = current().documents.check?.verdict;
  if (!verdict) return null;
  const told = { green: 'verdictGreen', amber: 'verdictAmber', red: 'verdictRed' }[verdict.state] ?? 'verdictOpen';
  const show = (c, value) => {
    if (value === undefined) return '–';
    const how = shownIn(c.name, prose(c.unit), state.units);
    return `${number(how.convert(value), how.unit)} ${how.unit}`.trim();
  };
  return (
    <section aria-labelledby="verdict-title" class="verdict">
      <h2 id="verdict-title">{t('verdict')}</h2>
      <p role="status"><span class={`state ${verdict.state}`}>{t(told)}</span></p>
      <div class="wide" tabindex={0} role="group" aria-label={t('verdict')}>
        <table>
          <thead><tr><th scope="col">{t('criterion')}</th><th scope="col">{t('value')}</th><th scope="col">{t('limit')}</th><th scope="col">{t('state')}</th><th scope="col">{t('where')}</th></tr></thead>
          <tbody>
            {verdict.criteria.map((c) => (
              <tr key={c.name}>
                <th scope="row">{c.title}</th>
                <td>{show(c, c.value)}</td>
                <td>{c.limit === undefined ? '' : `${t(c.sense === 'least' ? 'atLeast' : 'atMost', show(c, c.limit))}, ${t(`source.${c.limit_source}`)}`}</td>
                <td><span class={`state ${c.state}`}>{t(`state.${c.state}`)}</span></td>
                <td>{prose([c.load_case, c.reason].filter(Boolean).join(': '))}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="default">{t('setLimits')}</p>
    </section>
  );
}

/** HTML of the engine, which escapes the texts of the case; what was open in it stays open. */
export function Html({ html, id }) {
  const place = useRef(null);
  const shown = useRef(null);
  useLayoutEffect(() => {
    if (shown.current === html) return;
    shown.current = html;
    const template = document.createElement('template');
    template.innerHTML = html;
    const body = place.current;
    const opened = [...body.querySelectorAll('details[open] > summary')].map((s) => s.textContent);
    for (const summary of template.content.querySelectorAll('summary'))
      summary.parentElement.open = opened.includes(summary.textContent);
    for (const box of template.content.querySelectorAll('.wide')) {
      box.setAttribute('role', 'group');
      box.setAttribute('aria-label', t('results'));
    }
    body.replaceChildren(template.content);
  });
  return <div class="body" id={id} ref={place} />;
}

export function Warnings() {
  if (!current().sections) return null;
  const html = current().sections.warnings;
  return (
    <section aria-labelledby="warnings-title">
      <h2 id="warnings-title">{t('warnings')}</h2>
      {html ? <Html html={html} /> : <p role="status">{t(html === undefined ? 'computing' : 'noWarnings')}</p>}
    </section>
  );
}

const ownPlaces = new Set(['summary', 'verdict', 'warnings', 'studies', 'provenance']);

export function Sections() {
  const v = current();
  if (!v.sections) return null;
  return page.sections.filter(({ id }) => !ownPlaces.has(id)).map(({ id, title: name }) => {
    const html = v.sections[id];
    const isOpen = state.open.has(id);
    if (html === '' && isOpen) return null;
    return (
      <details key={id} id={`section-${id}`} class="section" open={isOpen}
        onToggle={(event) => toggleSection(id, event.currentTarget.open)}>
        <summary><h2>{name}</h2></summary>
        {isOpen && (html ? <Html html={html} /> : <p role="status">{t('computing')}</p>)}
      </details>
    );
  });
}

export function Results() {
  return <><Headlines /><Verdict /><Warnings /><Mechanism /><Sections /></>;
}
