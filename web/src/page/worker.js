// The engine in a worker. The first message is the module, compiled or as it stands in the page, in
// base 85: then the compiled one is posted, for further workers. Each further message is a question,
// whose answer is posted, both as objects. `loadEngine` stands in prs/page/live/engine.js.
import { bytesOf } from './packed.js';

async function start(source) {
  if (source instanceof WebAssembly.Module) return loadEngine(source);
  let module = null;
  try {
    module = await WebAssembly.compile(unpackEngine(bytesOf(source)));
    postMessage({ engine: module });
  } catch (error) {
    postMessage({ engine: null });
    if (!module) throw error;
  }
  return loadEngine(module);
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
