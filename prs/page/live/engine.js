// The engine in a page or in node: a plain script, which puts `unpackEngine` and `loadEngine` into scope.

/**
 * Unpacks a file of the format .lzma, as the module is shipped: a third smaller than gzipped, and
 * as text in a page 0.4 MB. Names are those of its specification (7-zip.org/sdk.html).
 */
function unpackEngine(packed) {
  const literalContextBits = packed[0] % 9;
  const literalPositionMask = (1 << (Math.floor(packed[0] / 9) % 5)) - 1;
  const positionMask = (1 << Math.floor(packed[0] / 45)) - 1;

  // Where the probabilities of each kind of decision stand.
  const isMatch = 0, isRep = 192, isRepG0 = 204, isRepG1 = 216, isRepG2 = 228, isRep0Long = 240;
  const slots = 432, special = 688, align = 802, lengths = 818, repLengths = 1332, literals = 1846;
  const probabilities = new Uint16Array(literals + (literalPositionMask + 1 << literalContextBits) * 768).fill(1024);

  // Range and code of the arithmetic decoder, 32 bits each: an array of them is the fastest.
  const coder = new Int32Array([-1, new DataView(packed.buffer, packed.byteOffset).getInt32(14)]);
  let at = 18;

  function shift() {
    coder[0] <<= 8;
    coder[1] = (coder[1] << 8) | packed[at++];
  }

  function bit(k) {
    const chance = probabilities[k];
    const range = coder[0], code = coder[1];
    const bound = Math.imul(range >>> 11, chance);
    const one = code >>> 0 >= bound >>> 0;
    if (one) {
      coder[0] = range - bound;
      coder[1] = code - bound;
      probabilities[k] = chance - (chance >> 5);
    } else {
      coder[0] = bound;
      probabilities[k] = chance + ((2048 - chance) >> 5);
    }
    if (coder[0] >>> 0 < 0x1000000) shift();
    return one ? 1 : 0;
  }

  function tree(base, bits) {
    let node = 1;
    for (let k = 0; k < bits; k++) node = (node << 1) | bit(base + node);
    return node - (1 << bits);
  }

  function reverseTree(base, bits) {
    let node = 1, value = 0;
    for (let k = 0; k < bits; k++) {
      const b = bit(base + node);
      node = (node << 1) | b;
      value |= b << k;
    }
    return value;
  }

  function direct(bits) {
    let value = 0;
    for (let k = 0; k < bits; k++) {
      coder[0] >>>= 1;
      const one = coder[1] >>> 0 >= coder[0] >>> 0;
      if (one) coder[1] -= coder[0];
      value = (value << 1) | one;
      if (coder[0] >>> 0 < 0x1000000) shift();
    }
    return value;
  }

  function lengthOf(base, place) {
    if (!bit(base)) return 2 + tree(base + 2 + place * 8, 3);
    if (!bit(base + 1)) return 10 + tree(base + 130 + place * 8, 3);
    return 18 + tree(base + 258, 8);
  }

  function distanceOf(length) {
    const slot = tree(slots + 64 * Math.min(length - 2, 3), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const start = (2 | (slot & 1)) << bits;
    if (slot < 14) return start + reverseTree(special + start - slot, bits);
    return (start + (direct(bits - 4) << 4) + reverseTree(align, 4)) >>> 0;
  }

  let bytes = new Uint8Array(1 << 22), size = 0;

  function literal(state, distance) {
    const before = size > 0 ? bytes[size - 1] : 0;
    const base = literals +
        768 * (((size & literalPositionMask) << literalContextBits) + (before >> (8 - literalContextBits)));
    let symbol = 1;
    if (state >= 7)
      for (let match = bytes[size - distance - 1]; symbol < 0x100; match <<= 1) {
        const expected = (match >> 7) & 1;
        symbol = (symbol << 1) | bit(base + ((1 + expected) << 8) + symbol);
        if ((symbol & 1) !== expected) break;
      }
    while (symbol < 0x100) symbol = (symbol << 1) | bit(base + symbol);
    return symbol;
  }

  let state = 0;
  let [rep0, rep1, rep2, rep3] = [0, 0, 0, 0];  // The last distances, the latest first.
  for (;;) {
    if (at > packed.length) throw new Error('the packed engine is cut off');
    const place = size & positionMask;
    let length = 1;
    if (!bit(isMatch + state * 16 + place)) {
      if (size === bytes.length) grow();
      bytes[size] = literal(state, rep0);
      size++;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    if (!bit(isRep + state)) {
      [rep3, rep2, rep1] = [rep2, rep1, rep0];
      length = lengthOf(lengths, place);
      state = state < 7 ? 7 : 10;
      rep0 = distanceOf(length);
      if (rep0 === 0xffffffff) return bytes.subarray(0, size);
    } else {
      let again = false;
      if (!bit(isRepG0 + state)) again = bit(isRep0Long + state * 16 + place) === 0;
      else if (!bit(isRepG1 + state)) [rep0, rep1] = [rep1, rep0];
      else if (!bit(isRepG2 + state)) [rep0, rep1, rep2] = [rep2, rep0, rep1];
      else [rep0, rep1, rep2, rep3] = [rep3, rep0, rep1, rep2];
      if (!again) length = lengthOf(repLengths, place);
      state = state < 7 ? (again ? 9 : 8) : 11;
    }
    if (rep0 >= size) throw new Error('the packed engine is damaged');
    while (size + length > bytes.length) grow();
    for (const end = size + length; size < end; size++) bytes[size] = bytes[size - rep0 - 1];
  }

  function grow() {
    const larger = new Uint8Array(2 * bytes.length);
    larger.set(bytes);
    bytes = larger;
  }
}

/**
 * Starts the module, compiled or as bytes, and gives a function from the text of a question to that
 * of its answer (prs/engine/engine.h). Where the module itself fails, the answer says so, and the
 * next question finds a new one.
 */
async function loadEngine(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
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
