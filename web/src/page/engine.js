// The engine of the page, in workers.

const element = (id) => document.getElementById(id);
let workerUrl = null;

/** The module as the first worker compiles it, for all others; null where it did not. */
let compiled = null;

/** One worker with the engine: questions in, answers out, in their order. */
export class Engine {
  constructor() {
    workerUrl ??= URL.createObjectURL(
      new Blob([element('worker').textContent], { type: 'text/javascript' }),
    );
    this.waiting = [];
    this.worker = new Worker(workerUrl);
    this.worker.onmessage = ({ data }) =>
      data.engine === undefined ? this.waiting.shift()(data) : this.pass(data.engine);
    this.worker.onmessageerror = () => this.pass(null);
    this.worker.onerror = (event) => {
      event.preventDefault();
      const answer = { status: 1, messages: [`The engine stopped: ${event.message}`] };
      for (const take of this.waiting.splice(0)) take(answer);
      this.pass(null);
    };
    this.pass = () => {};
    this.started = (compiled ?? Promise.resolve(null)).then((module) =>
      this.worker.postMessage(module ?? element('engine').textContent),
    );
    compiled ??= new Promise((resolve) => (this.pass = resolve));
  }

  async ask(question) {
    await this.started;
    return new Promise((resolve) => {
      if (this.waiting.length === 0) this.began = performance.now();
      this.waiting.push(resolve);
      this.worker.postMessage(question);
    });
  }

  /** Whether it computes, and since when. */
  get busySince() {
    return this.waiting.length > 0 ? this.began : null;
  }

  /** Ends it, also in the middle of an answer: `ended` says so of what it was asked. */
  end() {
    this.worker.terminate();
    this.pass(null);
    const messages = ['prs: error: the computation was ended'];
    for (const take of this.waiting.splice(0)) take({ status: 130, document: null, figures: [], messages, ended: true });
  }
}

/** Asks one question at a time; of those that come meanwhile, the last. */
export class Latest {
  constructor(take) {
    this.engine = null;
    this.take = take;
    this.next = null;
    this.busy = false;
  }

  async put(make) {
    this.next = make;
    if (this.busy) return;
    this.busy = true;
    this.engine ??= new Engine();
    while (this.next) {
      const question = this.next();
      this.next = null;
      this.take(await this.engine.ask(question), question);
    }
    this.busy = false;
  }
}
