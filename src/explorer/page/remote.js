// An engine in a worker, for what takes longer than a frame.

export class Stopped extends Error {}

/// The engine's JSON as an object; throws its sentence with the recommended options and buttons.
export function asked(text) {
  const told = JSON.parse(text);
  if (told.error) throw Object.assign(new Error(told.error), {options: told.options ?? [], buttons: told.buttons ?? []});
  return told;
}

export class Remote {
  /// `address`: of the worker's script; `module`: the engine, compiled.
  constructor(address, module) {
    Object.assign(this, {address, module, files: new Map(), law: '', last: 0});
    this.start();
  }

  start() {
    this.waiting = new Map();
    this.sent = new Map();
    try {
      this.worker = new Worker(this.address);
    } catch (error) {
      return this.refuse(error.message);
    }
    this.worker.onmessage = ({data}) => this.take(data);
    this.worker.onerror = event => {
      event.preventDefault();
      this.refuse(event.message);
    };
    this.worker.postMessage({module: this.module});
  }

  /// Without a worker: every call fails with this sentence.
  refuse(why) {
    this.refused = `This page cannot read and fit here, because the browser does not allow it a worker${why ? ` (${why})` : ''}. Save the page as a file and open that`;
    this.end(new Error(this.refused));
  }

  end(error) {
    const {waiting} = this;
    this.waiting = new Map();
    for (const {reject} of waiting.values()) reject(error);
  }

  take({id, text, part, broken, failed}) {
    if (failed) return this.refuse(failed);
    const one = this.waiting.get(id);
    if (!one) return;
    if (part !== undefined) return one.progress(part);
    this.waiting.delete(id);
    try {
      one.resolve(asked(text));
    } catch (error) {
      one.reject(error);
    }
    if (broken) this.stop();
  }

  get busy() { return this.waiting.size > 0; }

  /// Files for later calls.
  write(name, bytes) { this.files.set(name, bytes); }

  /// What the engine's function returns; `progress(part done)` is called meanwhile if there is one.
  call(call, args, progress) {
    if (this.refused) return Promise.reject(new Error(this.refused));
    const files = [...this.files].filter(([name, bytes]) => this.sent.get(name) !== bytes), id = ++this.last;
    for (const [name, bytes] of files) this.sent.set(name, bytes);
    return new Promise((resolve, reject) => {
      this.waiting.set(id, {resolve, reject, progress});
      this.worker.postMessage({id, call, args, files, law: this.law, told: Boolean(progress)});
    });
  }

  /// Ends what is under way; calls that wait fail with Stopped. The next call is sent all files again.
  stop() {
    this.worker?.terminate();
    this.end(new Stopped('Stopped'));
    if (!this.refused) this.start();
  }
}
