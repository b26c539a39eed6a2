// The report of the case at hand as a page of its own, without scripts.
import { page, state, wholeReport, current } from './store.js';

const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

const hash = async (text) => {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text)));
  return btoa(String.fromCharCode(...digest));
};

/** {name, html}; throws where the case cannot be computed. */
export async function reportPage() {
  const v = current();
  const answer = await wholeReport();
  if (!answer.document) throw new Error(answer.messages.join('\n'));
  const { sections, head } = answer.document;
  const titles = new Map(page.sections.map((s) => [s.id, s.title]));
  const filled = Object.entries(sections).filter(([, html]) => html);
  const title = (id) => titles.get(id) ?? id.replace(/^./, (c) => c.toUpperCase());
  const style = document.querySelector('style').textContent;
  // crypto.subtle is for secure contexts, which files are not everywhere.
  const policy = globalThis.crypto?.subtle ? `'sha256-${await hash(style)}'` : "'unsafe-inline'";
  const html = `<!DOCTYPE html>
<html lang="en"${state.units === 'us' ? ' data-units="us"' : ''}>
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src ${policy}; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(v.name)} · planetary roller screw</title>
<style>${style}</style>
</head>
<body>
<div class="page">
<header>
${head}</header>
<div class="side"><nav aria-label="Contents"><ol>${filled.map(([id]) => `<li><a href="#${id}">${title(id)}</a></li>`).join('')}</ol></nav></div>
<main>
${filled.map(([id, body]) => `<section id="${id}" aria-labelledby="${id}-title">\n<h2 id="${id}-title">${title(id)}</h2>\n<div class="body">\n${body}</div></section>`).join('\n')}
</main>
<footer><p>Made by the workbench of prs ${escaped(page.version)} on ${new Date().toISOString().slice(0, 10)}.</p></footer>
</div>
</body>
</html>
`;
  return { name: `${v.name}.html`, html };
}
