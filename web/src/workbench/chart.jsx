// Lines over an axis, those of several variants together, as SVG that follows the page's theme.
import { number } from './units.js';

const width = 560;
const height = 300;
const box = { left: 62, right: 14, top: 12, bottom: 44 };

/** Round steps that cover a range with about `count` of them. */
export function ticks(from, to, count = 5) {
  const raw = (to - from || Math.abs(to) || 1) / count;
  const size = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * size).find((s) => s >= raw * 0.999);
  const found = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) found.push(Number((k * step).toPrecision(12)));
  return found;
}

/** `series`: [{name, points: [[x, y], ..]}]. The table of its numbers is beside it, for readers of screens. */
export function Chart({ title, x, y, series }) {
  const points = series.flatMap((s) => s.points).filter(([a, b]) => Number.isFinite(a) && Number.isFinite(b));
  if (points.length === 0) return null;
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  let [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  if (y0 > 0 && y0 < 0.6 * y1) y0 = 0;
  if (y1 === y0) [y0, y1] = [y0 - Math.abs(y0 || 1) * 0.05, y1 + Math.abs(y1 || 1) * 0.05];
  if (x1 === x0) [x0, x1] = [x0 - 0.5, x1 + 0.5];
  const left = (v) => box.left + ((v - x0) / (x1 - x0)) * (width - box.left - box.right);
  const up = (v) => height - box.bottom - ((v - y0) / (y1 - y0)) * (height - box.top - box.bottom);
  return (
    <figure class="chart">
      <figcaption>{title}</figcaption>
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`${title}: ${series.map((s) => s.name).join(', ')}`}>
        {ticks(y0, y1).map((v) => (
          <g><line class="grid" x1={box.left} x2={width - box.right} y1={up(v)} y2={up(v)} />
            <text x={box.left - 6} y={up(v) + 4} text-anchor="end">{number(v, '', 4)}</text></g>
        ))}
        {ticks(x0, x1, 6).map((v) => (
          <g><line class="tick" x1={left(v)} x2={left(v)} y1={height - box.bottom} y2={height - box.bottom + 5} />
            <text x={left(v)} y={height - box.bottom + 18} text-anchor="middle">{number(v, '', 4)}</text></g>
        ))}
        <line class="axis" x1={box.left} x2={width - box.right} y1={height - box.bottom} y2={height - box.bottom} />
        <text class="label" x={(box.left + width - box.right) / 2} y={height - 6} text-anchor="middle">{x}</text>
        <text class="label" transform={`translate(14 ${(height - box.bottom + box.top) / 2}) rotate(-90)`} text-anchor="middle">{y}</text>
        {series.map((s, k) => (
          <g class={`series-${k % 4}`}>
            <polyline points={s.points.map(([a, b]) => `${left(a).toFixed(1)},${up(b).toFixed(1)}`).join(' ')} />
            {s.points.length < 60 && s.points.map(([a, b]) => <circle cx={left(a)} cy={up(b)} r={2.6}><title>{`${s.name}: ${number(a, '', 4)}, ${number(b, '', 4)}`}</title></circle>)}
          </g>
        ))}
      </svg>
      {series.length > 1 && (
        <ul class="legend">{series.map((s, k) => s.points.length > 0 && <li class={`series-${k % 4}`}><svg viewBox="0 0 34 16" aria-hidden="true"><polyline points="1,8 33,8" /><circle cx="17" cy="8" r="3" /></svg>{s.name}</li>)}</ul>
      )}
    </figure>
  );
}
