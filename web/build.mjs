// Bundles the pages' scripts into prs/page/live, see scripts/web.sh: report, workbench and the view of the
// mechanism, which both load when it is looked at, gzipped, each with the hash by which the page's policy
// names it; what starts them, and the worker, as they are.
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';

const live = new URL('../prs/page/live/', import.meta.url);

async function bundled(entry, format) {
  const { outputFiles } = await build({
    absWorkingDir: import.meta.dirname,
    entryPoints: [entry],
    bundle: true,
    write: false,
    minify: true,
    format,
    target: ['chrome100', 'firefox113', 'safari16.4'],
    charset: 'utf8',
    legalComments: 'eof',
    jsx: 'automatic',
    jsxImportSource: 'preact',
    loader: { '.css': 'text' },
  });
  // What would end the script element or begin a comment of HTML in it.
  return outputFiles[0].text.replaceAll(/<(\/script|!--)/gi, '\\x3c$1');
}

for (const name of ['report', 'workbench', 'mechanism']) {
  const text = await bundled(`src/${name}/main.js`, 'esm');
  const packed = gzipSync(text, { level: 9 });
  writeFileSync(new URL(`${name}.js.gz`, live), packed);
  writeFileSync(
    new URL(`${name}.hash`, live),
    `sha256-${createHash('sha256').update(text).digest('base64')}`,
  );
  console.log(`${name}: ${text.length} letters, ${packed.length} bytes packed`);
}
for (const name of ['start', 'worker'])
  writeFileSync(new URL(`${name}.js`, live), await bundled(`src/page/${name}.js`, 'iife'));
