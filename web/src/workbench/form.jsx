// Fields for every input that the case states, made from the schema.
import { useEffect, useState } from 'preact/hooks';
import { keysAt, lengthAt, valueAt, withBlock, withItem, without } from './case_text.js';
import { choices, help, isWhole, join, meaning, missingKeys, nodeAt, skeleton } from './schema.js';
import { changed, current, edit, schemaOf, set, state, withUnit } from './store.js';
import { t } from './texts.js';
import { inSystem, prose } from './units.js';

const words = (key) => key.replaceAll('_', ' ').replace(/^./, (c) => c.toUpperCase());

const blockOf = (path) => path.split(/[.[]/)[0];

/** `structure.nut.flanges[0].from` -> `Nut · flanges 1 · from` */
const labelOf = (path) =>
  path
    .slice(blockOf(path).length)
    .replace(/^\./, '')
    .split('.')
    .map((step) => step.replace(/^([^[]*)((\[\d+\])*)$/, (_, key, places) =>
      [key && words(key), ...[...places.matchAll(/\d+/g)].map(([k]) => Number(k) + 1)].filter((x) => x !== '').join(' ')))
    .join(' · ') || words(path);

const idOf = (path) => `input-${path.replace(/[^\w]/g, '-')}`;

/** Whether what the engine finds wrong names this input. */
const isNamed = (messages, path) =>
  messages.some((line) => /error/.test(line) && new RegExp(`(^|[\\s\`])${path.replace(/[.[\]]/g, '\\$&')}([\\s:,\`]|$)`).test(line));

function Field({ input, schema, reasonAbove }) {
  const { path, text } = input;
  const node = nodeAt(schema, path);
  const [draft, setDraft] = useState(null);
  useEffect(() => setDraft(null), [text]);
  const options = choices(node);
  const id = idOf(path);
  const wrong = current().status === 2 && isNamed(current().messages, path);
  const other = inSystem(text, state.units);
  const commit = (value) => {
    const typed = withUnit(path, value.trim());
    if (typed === '') return setDraft(''); // The value stays, in grey, until another is written.
    if (typed === text) return setDraft(null);
    set(path, typed, `field ${path}`).then(({ status, messages }) => {
      // What stands in the text is told beside it.
      if (valueAt(current().text, path) === typed) return;
      setDraft(null);
      state.note = status === 2 && messages?.length ? messages[0] : '';
      changed();
    });
  };
  // What is whole is computed while it is typed.
  const follow = (value) => {
    setDraft(value);
    if (node && isWhole(node, value.trim())) set(path, value.trim(), `field ${path}`);
  };
  const said = [meaning(node), help(node), node?.default !== undefined && `(${node.default})`].filter(Boolean).join('. ');
  const describedBy = [`${id}-help`, wrong && `${id}-wrong`].filter(Boolean).join(' ');
  const label = labelOf(path);
  return (
    <div class="field">
      <label for={id}>{label}</label>
      {options && options.includes(text) ? (
        <select id={id} data-path={path} value={text} aria-describedby={describedBy} aria-invalid={wrong || undefined}
          onChange={(event) => commit(event.currentTarget.value)}>
          {options.map((word) => <option value={word}>{word}</option>)}
        </select>
      ) : (
        <input id={id} type="text" data-path={path} value={draft ?? text} placeholder={text} spellcheck={false} autocomplete="off"
          aria-describedby={describedBy} aria-invalid={wrong || undefined}
          onInput={(event) => follow(event.currentTarget.value)}
          onChange={(event) => commit(event.currentTarget.value)}
          onKeyDown={(event) => event.key === 'Enter' && commit(event.currentTarget.value)} />
      )}
      <button type="button" class="quiet remove" aria-label={t('remove', path)} title={t('remove', path)}
        onClick={() => edit(without(current().text, path))}>×</button>
      {other && <span class="other">= {other}</span>}
      {input.basis === 'assumed' && <span class="assumed" title={input.reason}>{t('assumed')}{input.reason === reasonAbove ? `, ${t('asAbove')}` : `: ${prose(input.reason)}`}</span>}
      {wrong && <p class="wrong" id={`${id}-wrong`}>{prose(current().messages.find((line) => isNamed([line], path)).replace(/^.*?error: /, ''))}</p>}
      <p class="help" id={`${id}-help`}><code>{path}</code> {prose(said)}</p>
    </div>
  );
}

/** Inputs that the block may have and has not: [path, node]. */
function addable(text, schema, block) {
  const found = [];
  const walk = (path, depth) => {
    const node = nodeAt(schema, path);
    const keys = keysAt(text, path);
    if (keys) {
      for (const [key, of] of Object.entries(missingKeys(node, keys)))
        found.push([join(path, key), of]);
      if (depth < 4) for (const key of keys) walk(join(path, key), depth + 1);
    }
    for (let k = 0; k < Math.min(lengthAt(text, path), 6); ++k) walk(`${path}[${k}]`, depth + 1);
  };
  walk(block, 0);
  return found;
}

function lists(inputs) {
  const found = new Set();
  for (const { path } of inputs) {
    const match = /^(.*)\[\d+\][^[]*$/.exec(path);
    if (match) found.add(match[1]);
  }
  return [...found];
}

function AddTo({ block, schema, inputs }) {
  const [seen, setSeen] = useState(false);
  const v = current();
  const choose = (event) => {
    const path = event.currentTarget.value;
    event.currentTarget.value = '';
    if (!path) return;
    if (path.startsWith('+')) {
      const text = withItem(v.text, path.slice(1));
      if (text) edit(text);
      return;
    }
    set(path, skeleton(nodeAt(schema, path))).then(() => document.getElementById(idOf(path))?.focus());
  };
  const offered = seen ? addable(v.text, schema, block) : [];
  return (
    <select class="add" aria-label={t('addTo', words(block))} onFocus={() => setSeen(true)} onPointerDown={() => setSeen(true)} onChange={choose}>
      <option value="">+ {t('addInput')} …</option>
      {lists(inputs).map((path) => <option value={`+${path}`}>{t('addItem', path)}</option>)}
      {offered.map(([path, node]) => (
        <option value={path} title={meaning(node)}>{path.slice(block.length).replace(/^\./, '')}: {prose(meaning(node)).slice(0, 70)}</option>
      ))}
    </select>
  );
}

export function Form() {
  const [wanted, setWanted] = useState('');
  const v = current();
  const schema = schemaOf(v.text);
  const blocks = new Map();
  for (const input of v.inputs) {
    const block = blockOf(input.path);
    if (!blocks.has(block)) blocks.set(block, []);
    blocks.get(block).push(input);
  }
  const missing = Object.keys(schema.properties).filter((key) => !blocks.has(key) && keysAt(v.text, '')?.includes(key) !== true);
  const words_ = wanted.toLowerCase().split(/\s+/).filter(Boolean);
  const isWanted = ({ path }) => {
    const said = `${path} ${labelOf(path)} ${meaning(nodeAt(schema, path))}`.toLowerCase();
    return words_.every((word) => said.includes(word));
  };
  const opened = new Set(['mechanism', 'load_cases', 'limits', 'motion', 'operation', 'life']);
  return (
    <div class="form">
      <p class="find">
        <label for="find-input">{t('find')}</label>
        <input id="find-input" type="search" value={wanted} onInput={(event) => setWanted(event.currentTarget.value)} />
      </p>
      {[...blocks].map(([block, inputs]) => {
        const hits = inputs.filter(isWanted);
        return (
          <details key={block} class="block-of" open={words_.length ? hits.length > 0 : opened.has(block)} hidden={words_.length > 0 && hits.length === 0}>
            <summary>{words(block)} <small>{inputs.length}</small></summary>
            <p class="meaning">{prose(meaning(schema.properties[block]))}</p>
            {inputs.map((input, k) => (
              <div key={input.path} hidden={words_.length > 0 && !isWanted(input)}><Field input={input} schema={schema} reasonAbove={inputs.slice(0, k).findLast(({ reason }) => reason)?.reason} /></div>
            ))}
            <AddTo block={block} schema={schema} inputs={inputs} />
          </details>
        );
      })}
      <p>
        <select class="add" aria-label={t('addBlock')} value="" onChange={(event) => {
          const key = event.currentTarget.value;
          event.currentTarget.value = '';
          if (key) edit(withBlock(current().text, key, schema.properties[key]));
        }}>
          <option value="">+ {t('addBlock')} …</option>
          {missing.map((key) => <option value={key}>{words(key)}: {prose(meaning(schema.properties[key])).slice(0, 70)}</option>)}
        </select>
      </p>
    </div>
  );
}
