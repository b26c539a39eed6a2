// The engine in a worker. The first message is the module, gzipped, in base 85; each further one a
// question, whose answer is posted, both as objects. `loadEngine` stands in prs/engine/engine.js.

/** See base85 in prs/page/page.cpp. */
function bytesOf(text) {
  const [length, letters] = text.trim().split(' ');
  const view = new DataView(new ArrayBuffer((letters.length / 5) * 4));
  for (let k = 0; k < letters.length; k += 5) {
    let four = 0;
    for (let j = k; j < k + 5; j++) {
      const code = letters.charCodeAt(j);
      four = four * 85 + (code === 125 ? 20 : code === 126 ? 52 : code - 40);
    }
    view.setUint32((k / 5) * 4, four);
  }
  return new Uint8Array(view.buffer, 0, Number(length));
}

async function start(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream('gzip'));
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
