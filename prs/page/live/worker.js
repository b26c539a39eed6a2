// The engine in a worker. The first message is the module, gzipped, in base64; each further one a
// question, whose answer is posted, both as objects. `loadEngine` stands in prs/engine/engine.js.

async function start(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return loadEngine(await new Response(stream).arrayBuffer());
}

let engine = null;

onmessage = async ({ data }) => {
  if (!engine) {
    engine = start(data);
    engine.catch(() => {});
    return;
  }
  try {
    postMessage(JSON.parse((await engine)(JSON.stringify(data))));
  } catch (error) {
    const message = `The engine does not run in this browser: ${error.message}`;
    postMessage({ status: 1, document: null, figures: [], messages: [message] });
  }
};
