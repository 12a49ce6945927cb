// The module in its worker, as a function that answers with promises.

// The smallest modules with one vector instruction, and with one try block.
const kWithVectors = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
const kWithExceptions = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11];

// What the lab needs and this browser lacks, by the keys of texts.js.
export function missingFeatures() {
  const missing = [];
  if (typeof WebAssembly === "undefined") return ["needs_webassembly"];
  if (!WebAssembly.validate(new Uint8Array(kWithVectors))) missing.push("needs_vectors");
  if (!WebAssembly.validate(new Uint8Array(kWithExceptions))) missing.push("needs_exceptions");
  if (typeof Worker === "undefined") missing.push("needs_workers");
  if (typeof DecompressionStream === "undefined") missing.push("needs_gzip");
  return missing;
}

export class Engine {
  #worker;
  #waiting = new Map();
  #last_id = 0;

  // `script` is the worker's text: pages on the disk may start no worker from a file.
  constructor(script) {
    this.#worker = new Worker(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
    this.#worker.onmessage = ({ data }) => {
      const { resolve, reject } = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.failure === undefined) resolve(data);
      else reject(new Error(data.failure));
    };
    this.#worker.onerror = (event) => {
      for (const { reject } of this.#waiting.values()) reject(new Error(event.message));
      this.#waiting.clear();
    };
  }

  #send(message, moved = []) {
    const id = ++this.#last_id;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, ...message }, moved);
    });
  }

  // `gzipped`: the module's bytes in base64.
  start(gzipped) {
    const bytes = Uint8Array.from(atob(gzipped), (letter) => letter.charCodeAt(0));
    return this.#send({ start: bytes }, [bytes.buffer]);
  }

  // [{name, bytes: ArrayBuffer}]; names may have folders.
  keep(files) {
    return this.#send({ files }, files.map((file) => file.bytes));
  }

  // A request of chapters/lab/lab.h; {reply, buffers}. What the program would refuse stands in reply.error.
  ask(request) {
    return this.#send({ ask: request });
  }
}
