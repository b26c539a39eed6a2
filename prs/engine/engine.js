// The engine in a page or in node: a plain script, which puts `loadEngine` into scope.

/**
 * Compiles the module and gives a function from the text of a question to that of its answer
 * (prs/engine/engine.h). Where the module itself fails, the answer says so, and the next question
 * finds a new one.
 */
async function loadEngine(bytes) {
  const module = await WebAssembly.compile(bytes);
  let engine;
  const view = () => new DataView(engine.memory.buffer);

  // What it asks its host for (WASI): a clock. There are no files, no terminal, no environment.
  const host = {
    clock_time_get(_clock, _precision, at) {
      view().setBigUint64(at, BigInt(Date.now()) * 1000000n, true);
      return 0;
    },
    environ_sizes_get(count, bytes) {
      view().setUint32(count, 0, true);
      view().setUint32(bytes, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit(status) {
      throw new Error(`it ended with status ${status}`);
    },
    emscripten_notify_memory_growth() {},
  };
  const notThere = () => 52;  // ENOSYS
  const imports = {};
  for (const {module: from, name} of WebAssembly.Module.imports(module))
    (imports[from] ??= {})[name] = host[name] ?? notThere;

  const start = (instance) => {
    engine = instance.exports;
    engine._initialize();
  };
  start(await WebAssembly.instantiate(module, imports));

  const ask = (question) => {
    try {
      const text = new TextEncoder().encode(question);
      const at = engine.malloc(text.length + 1);
      if (at === 0) throw new Error("out of memory");
      const memory = new Uint8Array(engine.memory.buffer, at, text.length + 1);
      memory.set(text);
      memory[text.length] = 0;
      const answer = engine.prs_answer(at);
      engine.free(at);
      const all = new Uint8Array(engine.memory.buffer);
      return new TextDecoder().decode(all.subarray(answer, all.indexOf(0, answer)));
    } catch (error) {
      start(new WebAssembly.Instance(module, imports));
      const message = `prs: error: the engine failed: ${error.message}`;
      return JSON.stringify({status: 1, document: null, figures: [], messages: [message]});
    }
  };
  /** Bytes of its memory that are in use. */
  ask.used = () => {
    const at = engine.malloc(40);
    engine.mallinfo(at);
    const used = view().getInt32(at + 28, true);  // uordblks
    engine.free(at);
    return used;
  };
  return ask;
}
