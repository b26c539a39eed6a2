// The view with its controls, in an element of a page; see README.md.
import { dimensions } from './geometry.js';
import { hasRollers, largest, quantities, shown, sides, stateOf, temperatures, threadNumber } from './numbers.js';
import { texts } from './texts.js';
import { View } from './view.js';

function make(tag, properties = {}, ...children) {
  const { attributes = {}, ...rest } = properties;
  const node = Object.assign(document.createElement(tag), rest);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Colours of the page, whose style sheet has them as variables. */
function themeOf(element) {
  const style = getComputedStyle(element);
  const value = (name, otherwise) => style.getPropertyValue(name).trim() || otherwise;
  return {
    screw: '#8fa3b5',
    rollers: '#c3ccd4',
    nut: '#a9b1a4',
    quiet: '#7d858c',
    chosen: value('--link', '#00619a'),
    scale: value('--scale', '#ffffe5,#fee391,#fec44f,#ec7014,#cc4c02').split(',').map((colour) => colour.trim()),
  };
}

let count = 0;

/** Whether pictures come from the processor, which draws a tenth of the triangles. */
function isDrawnBySoftware() {
  const probe = document.createElement('canvas').getContext('webgl2');
  const info = probe?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? probe.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  probe?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/**
 * Draws `document` into the element; null where there is no WebGL, with the element as it was.
 * `onThread({load_case, roller, thread})`, all from 0, is told of a thread that the reader chose.
 */
export function mount(element, { document: first, loadCase = 0, onThread = () => {}, link = null }) {
  const id = `mechanism-view-${++count}`;
  const canvas = make('canvas', { tabIndex: 0, attributes: { role: 'img', 'aria-describedby': `${id}-help` } });
  const isFast = !isDrawnBySoftware();
  const context = canvas.getContext('webgl2', { antialias: isFast });
  if (!context) return null;
  const choice = (label, select) => make('label', {}, `${label} `, select);
  const cases = make('select');
  const colours = make('select');
  const button = (text, act) => {
    const node = make('button', { type: 'button', textContent: text });
    node.addEventListener('click', act);
    return node;
  };
  const toggle = (part) => {
    const box = make('input', { type: 'checkbox', checked: true });
    box.addEventListener('change', () => view.setVisible(part, box.checked));
    return make('label', {}, box, ` ${texts[part]}`);
  };
  const low = make('span');
  const high = make('span');
  const legend = make('p', { className: 'scale' }, low, make('span', { className: 'ramp' }), high);
  const told = make('p', { className: 'told', attributes: { role: 'status' } });
  const casesLabel = choice(texts.loadCase, cases);

  let view = null;
  let data = first;
  let chosen = null;
  view = new View(canvas, context, { isFast, theme: themeOf(element), onPick: (picked) => pick(picked) });

  const box = make('div', { className: 'mechanism-view' },
    make('div', { className: 'picture' }, canvas),
    make('div', { className: 'row' }, casesLabel, choice(texts.colours, colours),
      make('span', { attributes: { role: 'group', 'aria-label': texts.show } }, toggle('nut'), ' ', toggle('rollers'), ' ', toggle('screw')),
      button(texts.previous, () => step(-1)), button(texts.next, () => step(1)), button(texts.reset, () => view.home())),
    legend, told,
    make('p', { id: `${id}-help`, className: 'help', textContent: texts.help }));
  element.append(box);

  const loadCaseNow = () => data.load_cases?.[Number(cases.value) || 0];
  const many = () => hasRollers(loadCaseNow());

  function fill(select, rows, value) {
    select.replaceChildren(...rows.map(([key, text]) => new Option(text, key)));
    select.value = rows.some(([key]) => String(key) === String(value)) ? value : rows[0]?.[0];
  }

  function paint() {
    const loadCase = loadCaseNow();
    const warm = temperatures(data, loadCase);
    const available = Object.keys(quantities).filter((name) => loadCase?.screw?.[quantities[name].key]);
    fill(colours, [...available, ...(warm ? ['temperature'] : [])].map((name) => [name, texts[name]]), colours.value);
    view.show(dimensions(data, Number(cases.value) || 0));
    const { d } = view;
    if (colours.value === 'temperature') {
      const values = [warm.screw, warm.rollers, warm.nut];
      const [from, to] = [Math.min(...values), Math.max(...values)];
      const share = (value) => (to > from ? (value - from) / (to - from) : 0.5);
      view.colour({
        contacts: () => null,
        parts: { screw: share(warm.screw), rollers: share(warm.rollers), nut: share(warm.nut) },
      });
      low.textContent = `${shown(from)} °C`;
      high.textContent = `${shown(to)} °C (${['screw', 'rollers', 'nut'].map((part) => `${texts[part]} ${shown(warm[part])}`).join(', ')})`;
    } else {
      const quantity = quantities[colours.value];
      // One scale for all load cases, so that they can be compared.
      const most = quantity && Math.max(...data.load_cases.map((each) => largest(each, quantity.key, d.rollers, d.contacts)?.value ?? 0));
      view.colour({
        contacts: (side, roller, thread) => {
          const value = quantity && threadNumber(loadCase, side, quantity.key, roller, thread);
          return value === null || value === undefined ? null : value / (most || 1);
        },
        parts: null,
      });
      low.textContent = quantity ? `0 ${quantity.unit}` : '';
      high.textContent = quantity ? [`${shown(most)} ${quantity.unit}`, stateOf(loadCase)].filter(Boolean).join(', ') : '';
    }
    legend.hidden = !colours.value;
    describe(loadCase, d);
    tell();
  }

  const placeText = ({ roller, thread }) => texts.place({ roller: roller + 1, thread: thread + 1, manyRollers: many() });

  function describe(loadCase, d) {
    const quantity = quantities[colours.value] ?? quantities.load;
    const most = largest(loadCase, quantity.key, d.rollers, d.contacts);
    const { type } = data.resolved_input.mechanism;
    const summary = texts.summary({
      type: texts.types[type] ?? type, rollers: d.rollers - d.missing.size, contacts: d.contacts,
      loadCase: [loadCase?.name, stateOf(loadCase)].filter(Boolean).join(', '),
    });
    const side = most && `${texts[quantity === quantities.load ? 'load' : 'pressure']} ${most.side === 'nut' ? texts.atNut : texts.atScrew}`;
    canvas.setAttribute('aria-label', `${texts.title}. ${summary}${most ? ` ${texts.largest({ side, place: placeText(most), value: `${shown(most.value)} ${quantity.unit}` })}` : ''}`);
  }

  function tell() {
    told.textContent = '';
    if (!chosen) return;
    const loadCase = loadCaseNow();
    const words = sides.map((side) => {
      const numbers = Object.values(quantities)
        .map(({ key, unit }) => [threadNumber(loadCase, side, key, chosen.roller, chosen.thread), unit])
        .filter(([value]) => value !== null);
      const text = numbers[0]?.[0] === 0 ? texts.unloaded : numbers.map(([value, unit]) => `${shown(value)} ${unit}`).join(', ');
      return text && `${side === 'nut' ? texts.atNut : texts.atScrew} ${text}`;
    });
    const place = placeText(chosen);
    const title = [`${place[0].toUpperCase()}${place.slice(1)}`, stateOf(loadCase)].filter(Boolean).join(', ');
    told.append(make('strong', { textContent: title }), `: ${words.filter(Boolean).join('; ')}. `);
    if (link) told.append(make('a', { href: link, textContent: texts.allNumbers }));
  }

  /** Shows a thread as chosen, without telling the page. */
  function select(picked) {
    chosen = picked && { roller: many() ? picked.roller : 0, thread: picked.thread };
    if (picked?.load_case !== undefined && Number(cases.value) !== picked.load_case) {
      cases.value = picked.load_case;
      paint();
    }
    view.choose(picked && { roller: many() ? picked.roller : null, thread: picked.thread });
    tell();
  }

  function pick(picked) {
    select(picked);
    onThread({ load_case: Number(cases.value) || 0, ...chosen });
  }

  function step(by) {
    const { d } = view;
    const rollers = many() ? d.rollers : 1;
    const all = rollers * d.contacts;
    const now = chosen ? chosen.roller * d.contacts + chosen.thread + by : by > 0 ? 0 : all - 1;
    const at = (now + all) % all;
    pick({ roller: Math.floor(at / d.contacts), thread: at % d.contacts });
  }

  const keys = {
    ArrowLeft: () => view.turn(-0.1, 0),
    ArrowRight: () => view.turn(0.1, 0),
    ArrowUp: () => view.turn(0, -0.1),
    ArrowDown: () => view.turn(0, 0.1),
    '+': () => view.zoom(1 / 1.15),
    '=': () => view.zoom(1 / 1.15),
    '-': () => view.zoom(1.15),
    Home: () => view.home(),
    PageUp: () => step(-1),
    PageDown: () => step(1),
  };
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  cases.addEventListener('change', () => {
    paint();
    if (chosen) pick(chosen);
  });
  colours.addEventListener('change', paint);

  /** Another document, of changed values: the view, the choices and the thread stay. */
  function update(next, wanted = Number(cases.value) || 0) {
    data = next;
    const names = (data.load_cases ?? []).map((each, k) => [k, each.name]);
    fill(cases, names, wanted);
    casesLabel.hidden = names.length < 2;
    const d = dimensions(data, Number(cases.value) || 0);
    if (chosen && (chosen.thread >= d.contacts || chosen.roller >= d.rollers)) chosen = null;
    paint();
    if (chosen) select(chosen);
    else view.choose(null);
  }

  update(first, loadCase);

  function dispose() {
    view.dispose();
    box.remove();
  }

  return { update, select, dispose, view };
}
