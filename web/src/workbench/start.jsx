// Where a reader begins: catalogue data, a lesson, a file, or what was at hand last time.
import { useState } from 'preact/hooks';
import { readFiles } from './files.js';
import { ask, changed, current, kept, lessons, open, page, refresh, restore, state } from './store.js';
import { t } from './texts.js';
import { prose } from './units.js';

export const lesson = (l) => open(l.text, `${l.name}.yaml`);

const texts = ['screw_diameter', 'lead', 'nut_diameter', 'nut_length', 'load', 'speed'];
const counts = ['starts', 'rollers'];
const examples = { screw_diameter: '30 mm', lead: '10 mm', nut_diameter: '64 mm', nut_length: '85 mm', load: '20 kN', speed: '200 rpm' };

function ByCatalogue({ done }) {
  const [trouble, setTrouble] = useState('');
  const make = async (event) => {
    event.preventDefault();
    const form = new FormData(event.currentTarget);
    const asked = { type: form.get('type') };
    for (const key of texts) {
      const typed = form.get(key).trim();
      // A number alone has the unit of the example.
      if (typed) asked[key] = /^[\d.]+$/.test(typed) ? `${typed} ${examples[key].split(' ')[1]}` : typed;
    }
    for (const key of counts) if (form.get(key)) asked[key] = Number(form.get(key));
    if (form.get('lubricant')) asked.lubricant = form.get('lubricant');
    const answer = await ask({ command: 'new', new: asked });
    if (!answer.document) return setTrouble(answer.messages.join('\n').replace(/prs: error: (question: )?/g, ''));
    setTrouble('');
    await open(answer.document.yaml, `screw-${asked.screw_diameter ?? ''}-${asked.lead ?? ''}.yaml`.replaceAll(' ', ''));
    state.note = answer.document.assumed;
    done?.();
    changed();
  };
  return (
    <form class="start-form" onSubmit={make} autocomplete="off">
      <h3>{t('byCatalogue')}</h3>
      <p class="default">{t('byCatalogueHint')}</p>
      <div class="field"><label for="new-type">{t('kind')}</label>
        <select id="new-type" name="type"><option value="standard">{t('standard')}</option><option value="inverted">{t('inverted')}</option></select></div>
      {texts.map((key, k) => (
        <div class="field" key={key}><label for={`new-${key}`}>{t(key)}{k > 1 && <small> {t('optional')}</small>}</label>
          <input id={`new-${key}`} name={key} type="text" required={k < 2} placeholder={examples[key]} aria-describedby={trouble ? 'new-trouble' : undefined} /></div>
      ))}
      {counts.map((key) => (
        <div class="field" key={key}><label for={`new-${key}`}>{t(key)}<small> {t('optional')}</small></label>
          <input id={`new-${key}`} name={key} type="number" min="1" max="100" /></div>
      ))}
      <div class="field"><label for="new-lubricant">{t('lubricant')}<small> {t('optional')}</small></label>
        <select id="new-lubricant" name="lubricant"><option value="">–</option>{page.lubricants.map((l) => <option>{l.name}</option>)}</select></div>
      {trouble && <p class="wrong" id="new-trouble" role="alert">{prose(trouble)}</p>}
      <p><button class="primary">{t('create')}</button></p>
    </form>
  );
}

/** Takes cases and tables: the first case is opened, further ones become variants. */
export async function takeFiles(list) {
  const { cases, tables } = await readFiles(list);
  state.files = { ...state.files, ...tables };
  if (cases.length > 0) await open(cases[0].text, cases[0].name);
  else if (current()) await refresh();
}

export function FileButton({ id, label, className, done }) {
  return (
    <>
      <label class={`button ${className ?? ''}`} for={id}>{label}</label>
      <input id={id} class="file-input" type="file" multiple accept=".yaml,.yml,.csv,.txt"
        onChange={async (event) => { const list = [...event.currentTarget.files]; event.currentTarget.value = ''; await takeFiles(list); done?.(); }} />
    </>
  );
}

export function Start({ done }) {
  const [chosen, setChosen] = useState(lessons[0]?.name);
  return (
    <section class="start" aria-labelledby="start-title">
      <h2 id="start-title">{t('startTitle')}</h2>
      {kept().map((last) => (
        <p key={last.at}><button type="button" onClick={() => { restore(last); done?.(); }}>{t('goOn', last.variants.map((v) => v.name).join(', '))}</button>{' '}
          <span class="default">{t('savedAt', new Date(last.at).toLocaleString('en'))}</span></p>
      ))}
      <div class="start-ways">
        <ByCatalogue done={done} />
        <div>
          <h3>{t('byLesson')}</h3>
          <p class="field"><label for="lesson">{t('lesson')}</label>
            <select id="lesson" value={chosen} onChange={(event) => setChosen(event.currentTarget.value)}>
              {lessons.map((l) => <option value={l.name}>{l.name.slice(0, 2)}: {l.title}</option>)}
            </select></p>
          <p><button type="button" onClick={() => { lesson(lessons.find((l) => l.name === chosen)); done?.(); }}>{t('openLesson')}</button></p>
          <h3>{t('byFile')}</h3>
          <p class="default">{t('byFileHint')}</p>
          <p><FileButton id="start-file" label={t('chooseFiles')} done={done} /></p>
        </div>
      </div>
    </section>
  );
}
