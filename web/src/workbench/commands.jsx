// Every command that one case answers, and `size` of a requirement.
import { useState } from 'preact/hooks';
import { Html } from './results.jsx';
import { addVariant, ask, changed, current, open, otherFile, page, state, stop } from './store.js';
import { saveFile } from './files.js';
import { t } from './texts.js';
import { prose } from './units.js';

export function Commands() {
  const [shown, setShown] = useState(null);
  const [running, setRunning] = useState(null);
  const v = current();
  const ready = v.documents.check?.commands ?? {};
  const run = async (command) => {
    setRunning(command);
    const answer = await ask({ command });
    setRunning(null);
    setShown({ command, of: v.text, ...answer });
  };
  const text = shown?.document ? JSON.stringify(shown.document, null, 2) : '';
  return (
    <section aria-labelledby="commands-title">
      <h2 id="commands-title">{t('commands')}</h2>
      <p class="default">{t('commandHint')}</p>
      <ul class="command-list">
        {page.commands.map(({ name, help }) => {
          const how = ready[name];
          if (!how && name !== 'check') return null;
          const isReady = how?.ready ?? true;
          return (
            <li key={name}>
              <button type="button" disabled={!isReady || running !== null} onClick={() => run(name)}>prs {name}</button>{' '}
              <span>{isReady ? prose(help) : t('missing', how.missing?.join(', ') ?? '')}</span>
            </li>
          );
        })}
      </ul>
      {running && <p role="status">{t('computing')} prs {running} <button type="button" onClick={() => { stop(); setRunning(null); }}>{t('stop')}</button></p>}
      {shown?.of === v.text && (
        <>
          <h3>prs {shown.command}</h3>
          {shown.messages?.length > 0 && <ul class="warnings">{shown.messages.map((line) => <li>{prose(line)}</li>)}</ul>}
          {text && (
            <>
              <p><button type="button" onClick={() => saveFile(`${v.name}.${shown.command}.json`, 'application/json', `${text}\n`)}>{t('download')}</button></p>
              <pre class="document" tabindex={0} role="group" aria-label={t('document')}>{text.length > 60000 ? `${text.slice(0, 60000)}\n…` : text}</pre>
            </>
          )}
        </>
      )}
    </section>
  );
}

/** Screws for a requirement, and any of them as a case. */
export function Size() {
  const [answer, setAnswer] = useState(null);
  const [running, setRunning] = useState(false);
  const v = current();
  const run = async () => {
    setRunning(true);
    const [report, size] = await Promise.all([
      ask({ command: 'report', report: { units: state.units } }),
      ask({ command: 'size' }),
    ]);
    if (size.document) v.documents = { ...v.documents, size: size.document };
    setRunning(false);
    setAnswer({ ...report, text: v.text, size: size.document });
  };
  const take = async (rank) => {
    const made = await ask({ command: 'write', rank });
    if (made.document) open(made.document.yaml, `${v.name}-${rank}.yaml`);
    else {
      state.trouble = made.messages.join('\n');
      changed();
    }
  };
  const sections = answer?.document?.sections;
  return (
    <section aria-labelledby="size-title">
      <h2 id="size-title">{t('size')}</h2>
      <p class="default">{t('sizeHint')}</p>
      <p><button type="button" class="primary" disabled={running} onClick={run}>{t('run')}</button>{' '}
        {running && <span role="status">{t('computing')} <button type="button" onClick={() => { stop(); setRunning(false); }}>{t('stop')}</button></span>}</p>
      {answer && answer.text === v.text && (
        <>
          {answer.messages?.length > 0 && <ul class="warnings">{answer.messages.map((line) => <li>{prose(line)}</li>)}</ul>}
          {answer.size && (
            <p class="buttons">
              {answer.size.candidates?.slice(0, 5).map((c) => <button type="button" onClick={() => take(c.rank)}>{t('takeCandidate', c.rank)}: {c.name}</button>)}
            </p>
          )}
          {sections && Object.entries(sections).map(([id, html]) => <Html key={id} html={html} id={`section-${id}`} />)}
        </>
      )}
    </section>
  );
}
