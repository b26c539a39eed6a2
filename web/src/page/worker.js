// The engine in a worker. The first message is the module, gzipped, in base 85; each further one a
// question, whose answer is posted, both as objects. `loadEngine` stands in prs/engine/engine.js.
import { unpacked } from './packed.js';

const start = async (text) => loadEngine(await unpacked(text).arrayBuffer());

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
