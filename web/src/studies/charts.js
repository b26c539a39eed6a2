// Pictures of studies as SVG elements, with the classes and variables of the page's style sheet
// (`svg_rules` in prs/svg/elements.cpp).

const namespace = 'http://www.w3.org/2000/svg';

function draw(name, attributes = {}, ...children) {
  const node = document.createElementNS(namespace, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const width = 640;

const text = (x, y, words, more = {}) => draw('text', { x, y, ...more }, String(words));

const shown = (value) => (value === null || value === undefined ? '–' : String(Number(value.toPrecision(4))));

/** Round places on an axis. */
function ticks(from, to, count = 6) {
  if (!(to > from)) return [from];
  const raw = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 2.5, 5, 10].find((each) => each * power >= raw * (1 - 1e-9));
  const found = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; k++) found.push(Number((k * step).toPrecision(12)));
  return found;
}

function frame(height, title) {
  return draw('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': title }, draw('title', {}, title));
}

const withUnit = (words, unit) => (unit ? `${words} (${unit})` : words);

/** A colour of the page's scale. */
function scaleColour(scale, share) {
  const at = Math.max(0, Math.min(1, share)) * (scale.length - 1);
  const k = Math.min(scale.length - 2, Math.floor(at));
  const channel = (colour, place) => Number.parseInt(colour.slice(1 + 2 * place, 3 + 2 * place), 16);
  const mixed = [0, 1, 2].map((place) => Math.round(channel(scale[k], place) + (at - k) * (channel(scale[k + 1], place) - channel(scale[k], place))));
  return `#${mixed.map((value) => value.toString(16).padStart(2, '0')).join('')}`;
}

/** A response over two inputs, each field with its number: `{rows, columns, responses[row][column]}`. */
export function heatMap({ rows, columns, responses, title, x, y, z }) {
  const scale = getComputedStyle(document.documentElement).getPropertyValue('--scale').split(',').map((colour) => colour.trim());
  const known = responses.flat().filter((value) => value !== null);
  const box = { left: 84, top: 44, width: width - 104, height: 320 };
  const svg = frame(430, title);
  if (known.length === 0) return svg;
  const [least, most] = [Math.min(...known), Math.max(...known)];
  const [across, up] = [box.width / columns.length, box.height / rows.length];
  const hasNumbers = across >= 46 && up >= 16;
  responses.forEach((row, k) => row.forEach((value, j) => {
    const [left, top] = [box.left + j * across, box.top + box.height - (k + 1) * up];
    const share = most > least ? (value - least) / (most - least) : 0.5;
    const field = draw('rect', { x: left, y: top, width: across + 0.5, height: up + 0.5, fill: value === null ? 'none' : scaleColour(scale, share) },
      draw('title', {}, `${shown(columns[j])} ${x.unit}, ${shown(rows[k])} ${y.unit}: ${shown(value)} ${z.unit}`));
    svg.append(field);
    if (hasNumbers) svg.append(text(left + across / 2, top + up / 2 + 4, shown(value), { class: value === null ? 'm' : 'n' }));
  }));
  const every = (count, room) => Math.max(1, Math.ceil(count / room));
  columns.forEach((value, j) => {
    if (j % every(columns.length, 9) === 0) svg.append(text(box.left + (j + 0.5) * across, box.top + box.height + 19, shown(value), { class: 'm' }));
  });
  rows.forEach((value, k) => {
    if (k % every(rows.length, 14) === 0) svg.append(text(box.left - 6, box.top + box.height - (k + 0.5) * up + 4, shown(value), { class: 'e' }));
  });
  const steps = 24;
  for (let k = 0; k < steps; k++)
    svg.append(draw('rect', { x: box.left + 70 + k * 8, y: 8, width: 8.5, height: 12, fill: scaleColour(scale, k / (steps - 1)) }));
  svg.append(
    text(box.left + 64, 19, shown(least), { class: 'e' }),
    text(box.left + 70 + 8 * steps + 6, 19, `${shown(most)} ${z.unit}  ${z.title}`),
    draw('rect', { class: 't', x: box.left, y: box.top, width: box.width, height: box.height }),
    text(box.left + box.width / 2, box.top + box.height + 42, withUnit(x.title, x.unit), { class: 'm' }),
    text(0, 0, withUnit(y.title, y.unit), { class: 'm', transform: `translate(16 ${box.top + box.height / 2}) rotate(-90)` }),
  );
  return svg;
}

/**
 * Effects of tolerances about the response of the case, the largest at the top. An outlined bar shows the
 * response at the lower end of an input, a filled bar that at the upper end; both have their numbers beside
 * them. `ends`: names of the lower and the upper end in the legend.
 */
export function tornadoChart({ bars, base, title, y, ends }) {
  const rowHeight = 46;
  const box = { left: 20, top: 30, width: width - 40, height: rowHeight * bars.length + 6 };
  const bottom = box.top + box.height;
  const svg = frame(bottom + 48, title);
  const known = [base, ...bars.flatMap((bar) => bar.responses)].filter((value) => value !== null);
  const half = Math.max(...known.map((value) => Math.abs(value - base))) * 1.25 || Math.abs(base) * 0.01 || 1;
  const horizontal = (value) => box.left + box.width * (0.5 + (value - base) / (2 * half));
  // As many digits as tell the bars apart.
  const places = Math.max(0, Math.min(12, 2 - Math.floor(Math.log10(half))));
  const told = (value) => value.toFixed(places).replace('-', '−');
  const place = horizontal(base);
  for (const value of ticks(base - half, base + half))
    svg.append(
      draw('line', { class: 't', x1: horizontal(value), x2: horizontal(value), y1: bottom, y2: bottom + 5 }),
      text(horizontal(value), bottom + 19, shown(value), { class: 'm' }),
    );
  svg.append(
    draw('rect', { class: 't', x: box.left, y: box.top, width: box.width, height: box.height }),
    draw('line', { class: 't', x1: place, x2: place, y1: box.top, y2: bottom }),
    text(box.left + box.width / 2, bottom + 40, withUnit(y.title, y.unit), { class: 'm' }),
  );
  ends.forEach((words, k) => svg.append(
    draw('rect', { class: k === 0 ? 's0' : 'f0', x: box.left + 200 * k, y: 8, width: 26, height: 10 }),
    text(box.left + 200 * k + 34, 17, words),
  ));
  bars.forEach((bar, k) => {
    const top = box.top + k * rowHeight + 6;
    svg.append(text(box.left + 8, top + 10, `${bar.path}: ${bar.value}, ${bar.within}`, { class: 'h' }));
    bar.responses.forEach((response, end) => {
      const from = top + 15 + 11 * end;
      if (response === null) return void svg.append(text(place + 8, from + 9, `${bar.texts[end]}: –`, { class: 'q' }));
      const at = horizontal(response);
      const isLeft = at < place;
      svg.append(
        draw('rect', { class: end === 0 ? 's0' : 'f0', x: Math.min(place, at), y: from, width: Math.max(1, Math.abs(at - place)), height: 10 },
          draw('title', {}, `${bar.texts[end]}: ${told(response)} ${y.unit}`)),
        text(at + (isLeft ? -6 : 6), from + 9, told(response), { class: isLeft ? 'e h' : 'h', 'font-size': 12 }),
      );
    });
  });
  return svg;
}
