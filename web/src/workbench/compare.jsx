// Variants side by side: numbers with their differences, inputs that differ, curves together.
import { useEffect } from 'preact/hooks';
import { Chart } from './chart.jsx';
import { headlinesOf, stateOfLoads } from './headlines.js';
import { LoadCaseChoice } from './results.jsx';
import { refreshAll, state } from './store.js';
import { t } from './texts.js';
import { number, prose, shownIn } from './units.js';

const capital = (text) => text.replace(/^./, (c) => c.toUpperCase());

const percent = (value, first) => {
  if (value === first) return '0 %';
  if (!first || value * first < 0) return '';
  const change = ((value - first) / Math.abs(first)) * 100;
  const size = Math.abs(change);
  return `${change > 0 ? '+' : '−'}${size < 0.01 ? '< 0.01' : number(size, '', size < 1 ? 2 : 3)} %`;
};

function Numbers() {
  const all = state.variants.map((v) => headlinesOf(v));
  const paths = [...new Map(all.flat().map((row) => [row.path, row])).values()];
  return (
    <div class="wide" tabindex={0} role="group" aria-label={t('compare')}>
      <table class="quantities compare">
        <thead><tr><th scope="col">{t('quantity')}</th>{state.variants.map((v) => <th scope="col">{v.name}</th>)}<th scope="col" class="unit">{t('units')}</th></tr></thead>
        <tbody>
          {paths.map(({ path, unit, title: name, value: largest }) => {
            const rows = all.map((of) => of.find((row) => row.path === path)?.value);
            const how = shownIn(path, unit, state.units, largest);
            return (
              <tr key={path}>
                <th scope="row">{capital(name)}</th>
                {rows.map((value, k) => (
                  <td>{value === undefined ? '–' : number(how.convert(value), how.unit)}
                    {k > 0 && value !== undefined && rows[0] !== undefined && <small class="change">{percent(value, rows[0])}</small>}</td>
                ))}
                <td class="unit">{how.unit}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

function Differences() {
  const all = state.variants.map((v) => new Map(v.inputs.map(({ path, text }) => [path, text])));
  const paths = [...new Set(all.flatMap((of) => [...of.keys()]))].filter((path) => all.some((of) => of.get(path) !== all[0].get(path)));
  if (paths.length === 0) return <p>{t('sameInputs')}</p>;
  return (
    <div class="wide" tabindex={0} role="group" aria-label={t('differentInputs')}>
      <table>
        <thead><tr><th scope="col">{t('input')}</th>{state.variants.map((v) => <th scope="col">{v.name}</th>)}</tr></thead>
        <tbody>{paths.map((path) => <tr key={path}><th scope="row"><code>{path}</code></th>{all.map((of) => <td>{prose(of.get(path) ?? '–')}</td>)}</tr>)}</tbody>
      </table>
    </div>
  );
}

const curves = [
  ['shareScrew', 'screw', 'load_rate_percent', 'share', '%'],
  ['shareNut', 'nut', 'load_rate_percent', 'share', '%'],
  ['pressureScrew', 'screw', 'peak_pressure_MPa', 'pressure', 'MPa'],
  ['pressureNut', 'nut', 'peak_pressure_MPa', 'pressure', 'MPa'],
];

/** Of all rollers the first. */
const threadsOf = (values, sums) =>
  Array.isArray(values?.[0]) ? values[0] : (values ?? []);

export function Curves() {
  return (
    <div class="charts">
      {curves.map(([name, side, key, y, unit]) => {
        const how = shownIn(key, unit, state.units, 1);
        const series = state.variants.map((v) => {
          const cases = (v.documents.solve ?? v.documents.contact)?.load_cases ?? [];
          const values = threadsOf(cases[Math.min(state.loadCase, cases.length - 1)]?.[side]?.[key]);
          return { name: v.name, points: values.map((value, k) => [k + 1, how.convert(value)]) };
        });
        return <Chart key={name} title={`${t(name)}${stateOfLoads(state.variants[0])}`} x={t('thread')} y={`${t(y)} (${how.unit})`} series={series} />;
      })}
    </div>
  );
}

export function Compare() {
  const key = state.variants.map((v) => v.text).join('\0');
  useEffect(() => void refreshAll(), [key]);
  return (
    <section aria-labelledby="compare-title">
      <h2 id="compare-title">{t('compare')}</h2>
      {state.variants.length < 2 && <p>{t('oneVariant')}</p>}
      <p class="default">{t('compareHint')}</p>
      <LoadCaseChoice />
      <Numbers />
      <h3>{t('differentInputs')}</h3>
      <Differences />
      <Curves />
    </section>
  );
}
