// Bundles the pages' scripts into a folder, `node build.mjs FOLDER` (scripts/web.sh): report, workbench and the
// view of the mechanism, which both load when it is looked at, gzipped, each with the hash by which the page's
// policy names it; what starts them, and the worker, as they are.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const folder = process.argv[2];

/** Of others, by their names: {version, licence, text}. */
const used = new Map();

function note(file) {
  const [place, name] = file.match(/^(?:.*\/)?node_modules\/((?:@[^/]+\/)?[^/]+)(?=\/)/) ?? [];
  if (!name || used.has(name)) return name;
  const { version, license } = JSON.parse(readFileSync(`${place}/package.json`, 'utf8'));
  if (!['MIT', 'ISC', 'BSD-2-Clause', 'BSD-3-Clause', 'Apache-2.0'].includes(license))
    throw new Error(`${name}: got licence ${license}; expected MIT, ISC, BSD or Apache`);
  const text = readdirSync(place).find((each) => /^licen[cs]e/i.test(each));
  used.set(name, { version, license, text: readFileSync(`${place}/${text}`, 'utf8').trim() });
  return name;
}

async function bundled(entry, format) {
  const { outputFiles, metafile } = await build({
    absWorkingDir: import.meta.dirname,
    entryPoints: [entry],
    bundle: true,
    write: false,
    metafile: true,
    minify: true,
    format,
    target: ['chrome100', 'firefox113', 'safari16.4'],
    charset: 'utf8',
    legalComments: 'none',
    jsx: 'automatic',
    jsxImportSource: 'preact',
    loader: { '.css': 'text' },
  });
  const names = new Set(Object.keys(metafile.inputs).map(note).filter(Boolean));
  const told = [...names].sort().map((name) => `${name} ${used.get(name).version} (${used.get(name).license})`);
  const head = told.length ? `/* With ${told.join(', ')}; licences: web/licences.txt */\n` : '';
  // What would end the script element or begin a comment of HTML in it.
  return head + outputFiles[0].text.replaceAll(/<(\/script|!--)/gi, '\\x3c$1');
}

for (const name of ['report', 'workbench', 'mechanism']) {
  const text = await bundled(`src/${name}/main.js`, 'esm');
  const packed = gzipSync(text, { level: 9 });
  writeFileSync(join(folder, `${name}.js.gz`), packed);
  writeFileSync(join(folder, `${name}.hash`), `sha256-${createHash('sha256').update(text).digest('base64')}`);
  console.log(`${name}: ${text.length} letters, ${packed.length} bytes packed`);
}
for (const name of ['start', 'worker'])
  writeFileSync(join(folder, `${name}.js`), await bundled(`src/page/${name}.js`, 'iife'));

writeFileSync(
  new URL('licences.txt', import.meta.url),
  [...used].sort().map(([name, { version, text }]) => `${name} ${version}\n\n${text}\n`).join(`\n${'-'.repeat(80)}\n\n`),
);
