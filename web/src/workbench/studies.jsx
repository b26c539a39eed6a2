// Studies of one and two inputs, and of tolerances, asked in workers design by design.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Engine } from '../page/engine.js';
import { heatMap, tornadoChart } from '../studies/charts.js';
import { responsePaths } from '../studies/response.js';
import { studies } from '../studies/study.js';
import { Chart } from './chart.jsx';
import { saveFile } from './files.js';
import { headlinesOf, responseInfo } from './headlines.js';
import { current, questionOf, state } from './store.js';
import { t } from './texts.js';
import { number, prose, shownIn } from './units.js';

/** Those of the case at hand. */
export function studiesOf(v = current()) {
  if (!v) throw new Error('no case is open; open one first');
  const text = { ...v };
  return studies({ question: (more) => questionOf(text, more), engine: () => new Engine() });
}

const capital = (text) => text.replace(/^./, (c) => c.toUpperCase());
const isNumber = (text) => /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?(\s*[^\d\s].*)?$/i.test(text);

/** About a value: `30 mm` -> ['24 mm', '36 mm']; whole numbers stay whole. */
function around(text, share = 0.2) {
  const [, value, unit] = /^([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(.*)$/i.exec(text) ?? [, '1', ''];
  const isWhole = unit === '' && /^\d+$/.test(value);
  const at = (factor) => {
    const x = Number(value) * factor || (factor > 1 ? 1 : 0);
    return `${isWhole ? Math.max(1, Math.round(x)) : Number(x.toPrecision(4))} ${unit}`.trim();
  };
  return [at(1 - share), at(1 + share)];
}

function ResponseChoice({ value, onChange }) {
  const v = current();
  const first = headlinesOf(v).map(({ path }) => path);
  const all = new Set(Object.entries(v.documents).filter(([name]) => name !== 'check').flatMap(([, document]) => responsePaths(document)));
  const others = [...all].filter((path) => !first.includes(path) && responseInfo(path).title !== path);
  const option = (path) => {
    const { title: name, unit } = responseInfo(path);
    return <option value={path}>{capital(name)}{unit && ` (${unit})`}</option>;
  };
  return (
    <p class="field"><label for="study-response">{t('response')}</label>
      <select id="study-response" value={value ?? first[0]} onChange={(event) => onChange(event.currentTarget.value)}>
        {first.map(option)}
        <optgroup label="prs list responses">{others.map(option)}</optgroup>
      </select></p>
  );
}

function Range({ id, label, inputs, range, take }) {
  const set = (key) => (event) => take({ ...range, [key]: event.currentTarget.value });
  return (
    <fieldset class="range">
      <legend>{label}</legend>
      <p class="field"><label for={`${id}-path`}>{t('input')}</label>
        <select id={`${id}-path`} value={range.path} onChange={(event) => {
          const { path, text } = inputs.find((input) => input.path === event.currentTarget.value);
          const [from, to] = around(text);
          take({ ...range, path, from, to });
        }}>{inputs.map(({ path }) => <option value={path}>{path}</option>)}</select></p>
      {['from', 'to'].map((key) => (
        <p class="field" key={key}><label for={`${id}-${key}`}>{t(key)}</label>
          <input id={`${id}-${key}`} type="text" value={range[key]} onChange={set(key)} /></p>
      ))}
      <p class="field"><label for={`${id}-steps`}>{t('steps')}</label>
        <input id={`${id}-steps`} type="number" min="2" max="200" value={range.steps} onChange={(event) => take({ ...range, steps: Number(event.currentTarget.value) })} /></p>
    </fieldset>
  );
}

const axis = (words, unit) => (unit ? `${words} (${unit})` : words);

/** An input in words: `mechanism.pitch_diameter.screw` -> `Pitch diameter, screw`, `load_cases[0].axial_force` -> `Axial force, load case 1`. */
function titleOf(path) {
  const [, block, place, rest] = /^([^.[]*)((?:\[\d+\])?)\.?(.*)$/.exec(path);
  const item = place ? `${block.replace(/s$/, '')} ${Number(place.slice(1, -1)) + 1}` : '';
  const steps = (rest || block).split('.').map((step) => step.replace(/\[(\d+)\]/g, (_, k) => ` ${Number(k) + 1}`));
  return capital([...steps, item].filter(Boolean).join(', ').replaceAll('_', ' '));
}

/** How a response is shown: {convert, unit, label}. */
function shown(path, values) {
  const { unit, title: name } = responseInfo(path);
  const largest = Math.max(...values.filter((x) => typeof x === 'number').map(Math.abs), 0);
  const how = shownIn(path, unit, state.units, largest);
  return { ...how, label: axis(capital(name), how.unit) };
}

/** An SVG element with its title. */
function Picture({ title: words, svg }) {
  const place = useRef(null);
  useEffect(() => place.current.replaceChildren(svg));
  return <figure class="chart"><figcaption>{words}</figcaption><div class="wide" ref={place} /></figure>;
}

function OneResult({ asked, found }) {
  const how = shown(asked.response, found.responses);
  const points = found.values.map((x, k) => [x, found.responses[k]]).filter(([, y]) => y !== null).map(([x, y]) => [x, how.convert(y)]);
  const refused = found.reasons.find(Boolean);
  return (
    <>
      <Chart title={how.label} x={axis(titleOf(asked.one.path), found.unit)} y={how.label} series={[{ name: current().name, points }]} />
      {refused && <p class="default">{refused}</p>}
      <div class="wide" tabindex={0} role="group" aria-label={t('document')}>
        <table class="quantities"><thead><tr><th scope="col">{axis(titleOf(asked.one.path), found.unit)}</th><th scope="col">{how.label}</th></tr></thead>
          <tbody>{found.values.map((x, k) => <tr><th scope="row">{number(x, '', 5)}</th><td>{found.responses[k] === null ? '–' : number(how.convert(found.responses[k]), how.unit)}</td></tr>)}</tbody></table>
      </div>
    </>
  );
}

function TwoResult({ asked, found }) {
  const all = found.responses.flat();
  const how = shown(asked.response, all);
  const picture = heatMap({
    rows: found.rows, columns: found.columns, responses: found.responses.map((row) => row.map((x) => (x === null ? null : how.convert(x)))), title: how.label,
    x: { title: titleOf(asked.two.path), unit: found.units[1] }, y: { title: titleOf(asked.one.path), unit: found.units[0] }, z: { title: '', unit: how.unit },
  });
  return (
    <>
      <Picture title={how.label} svg={picture} />
      <div class="wide" tabindex={0} role="group" aria-label={how.label}>
        <table class="quantities map">
          <thead><tr><th scope="col">{axis(titleOf(asked.one.path), found.units[0])} ↓ {axis(titleOf(asked.two.path), found.units[1])} →</th>{found.columns.map((x) => <th scope="col">{number(x, '', 5)}</th>)}</tr></thead>
          <tbody>{found.rows.map((row, k) => (
            <tr><th scope="row">{number(row, '', 5)}</th>
              {found.responses[k].map((x) => <td>{x === null ? '–' : number(how.convert(x), how.unit)}</td>)}</tr>
          ))}</tbody>
        </table>
      </div>
    </>
  );
}

function Tornado({ asked, found }) {
  const values = found.bars.flatMap((bar) => bar.responses).filter((x) => x !== null).concat(found.base);
  const how = shown(asked.response, values);
  const picture = tornadoChart({
    bars: found.bars.map((bar) => ({ ...bar, path: titleOf(bar.path), responses: bar.responses.map((x) => (x === null ? null : how.convert(x))) })),
    base: how.convert(found.base), title: how.label, ends: [t('low'), t('high')], y: { title: how.label.replace(/ \([^)]*\)$/, ''), unit: how.unit },
  });
  return (
    <>
      <Picture title={how.label} svg={picture} />
      <div class="wide" tabindex={0} role="group" aria-label={t('tornado')}>
        <table class="quantities"><thead><tr><th scope="col">{t('input')}</th><th scope="col">{t('within')}</th><th scope="col">{t('low')}</th><th scope="col">{t('high')}</th></tr></thead>
          <tbody>{found.bars.map(({ path, within, responses }) => (
            <tr><th scope="row">{titleOf(path)}</th><td>{within}</td>{responses.map((x) => <td>{x === null ? '–' : number(how.convert(x), how.unit)}</td>)}</tr>
          ))}</tbody></table>
      </div>
    </>
  );
}

const kinds = { studyOne: OneResult, studyTwo: TwoResult, tornado: Tornado };

export function Studies() {
  const v = current();
  const inputs = v.inputs.filter(({ path, text }) => isNumber(text) && !/^(study|optimize|report|limits)\b/.test(path));
  const begin = (wanted) => {
    const input = inputs.find(({ path }) => wanted.test(path)) ?? inputs[0];
    const [from, to] = around(input?.text ?? '1');
    return { path: input?.path, from, to, steps: 9 };
  };
  const [kind, setKind] = useState('studyOne');
  const [one, setOne] = useState(() => begin(/axial_force$/));
  const [two, setTwo] = useState(() => ({ ...begin(/rollers$/), steps: 5 }));
  const [tolerances, setTolerances] = useState(() =>
    inputs.filter(({ path, text }) => /pitch_diameter|outer_diameter$|bore$|youngs_modulus|viscosity$/.test(path) && Number.parseFloat(text) !== 0).slice(0, 6).map(({ path }) => ({ path, within: '1 %' })));
  const [response, setResponse] = useState(null);
  const [progress, setProgress] = useState(null);
  const [result, setResult] = useState(null);
  const [trouble, setTrouble] = useState('');
  const abort = useRef(null);
  // A result is that of its text.
  useEffect(() => {
    setResult(null);
    setTrouble('');
    return () => abort.current?.abort();
  }, [v.text]);

  const run = async () => {
    const wanted = response ?? headlinesOf(v)[0]?.path;
    const asked = { kind, one, two, tolerances, response: wanted };
    abort.current = new AbortController();
    const how = { signal: abort.current.signal, onProgress: (done, all) => setProgress([done, all]) };
    setProgress([0, 0]);
    setTrouble('');
    try {
      const of = studiesOf();
      const found = await (kind === 'studyOne' ? of.study(one, wanted, how)
        : kind === 'studyTwo' ? of.map([one, two], wanted, how) : of.tornado(tolerances, wanted, how));
      if (!abort.current.signal.aborted) setResult({ asked, found });
      else setTrouble(t('canceled'));
    } catch (error) {
      setTrouble(abort.current.signal.aborted ? t('canceled') : error.message);
    }
    setProgress(null);
  };
  const Result = result && kinds[result.asked.kind];
  return (
    <section class="studies" aria-labelledby="studies-title">
      <h2 id="studies-title">{t('studies')}</h2>
      <div class="tabs" role="group" aria-label={t('studies')}>
        {Object.keys(kinds).map((name) => <button type="button" key={name} aria-pressed={name === kind} onClick={() => setKind(name)}>{t(name)}</button>)}
      </div>
      <ResponseChoice value={response} onChange={setResponse} />
      {kind !== 'tornado' && (
        <div class="ranges">
          <Range id="study-one" label={t('input')} inputs={inputs} range={one} take={setOne} />
          {kind === 'studyTwo' && <Range id="study-two" label={t('second')} inputs={inputs} range={two} take={setTwo} />}
        </div>
      )}
      {kind === 'tornado' && (
        <>
          {tolerances.map(({ path, within }, k) => (
            <p class="field" key={path}><label for={`within-${k}`}>{titleOf(path)}</label>
              <input id={`within-${k}`} type="text" value={within} aria-label={`${t('within')}, ${path}`}
                onChange={(event) => setTolerances(tolerances.map((each, j) => (j === k ? { path, within: event.currentTarget.value } : each)))} />
              <button type="button" class="quiet remove" aria-label={t('remove', path)} onClick={() => setTolerances(tolerances.filter((_, j) => j !== k))}>×</button></p>
          ))}
          <p><select class="add" value="" aria-label={t('addInput')} onChange={(event) => {
            const path = event.currentTarget.value;
            event.currentTarget.value = '';
            if (path) setTolerances([...tolerances, { path, within: '1 %' }]);
          }}><option value="">+ {t('addInput')} …</option>{inputs.filter(({ path }) => !tolerances.some((each) => each.path === path)).map(({ path }) => <option>{path}</option>)}</select></p>
        </>
      )}
      <p class="buttons">
        <button type="button" class="primary" disabled={progress !== null} onClick={run}>{t('run')}</button>
        {progress && <><button type="button" onClick={() => abort.current.abort()}>{t('cancel')}</button>{' '}
          <progress max={progress[1] || 1} value={progress[0]} aria-label={t('studies')} /> <span role="status">{t('progress', ...progress)}</span></>}
        {result && <button type="button" onClick={() => saveFile(`${v.name}.study.json`, 'application/json', `${JSON.stringify(result, null, 2)}\n`)}>{t('download')}</button>}
      </p>
      {trouble && <p class="trouble" role="alert">{prose(trouble)}</p>}
      {Result && <Result asked={result.asked} found={result.found} />}
    </section>
  );
}
