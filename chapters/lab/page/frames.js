// When which frame is drawn: what is looked at at once, and all buffers with their hashes as soon as nothing changes.
import { frameRequest } from "./state.js";
import { Viewer } from "./viewer.js";

// So long after the last change a picture is taken to stay.
const kRest_ms = 250;
// A frame that takes longer is told to be on its way.
const kSlow_ms = 400;
// Frames that a rate is told over.
const kRateFrames = 8;

export class Frames {
  buffers = {};     // of the last frame, by name
  reply = null;     // what was told with it
  settled = false;  // all buffers are there, with hashes
  #engine;
  #state;
  #all;
  #drawn;
  #slow;
  #refused;
  #busy = false;
  #wanted = false;
  #changed_ms = -Infinity;
  #timer = 0;
  #shown_ms = [];
  // Of each pass, what it took when it was last computed; of the frame, their sum: at rest nothing is computed again.
  #pass_ms = new Map();
  frame_ms = 0;
  #key = "";
  #painting = 0;

  // `all()`: the names of all buffers that the method has. `drawn()` is called with each frame, `slow()` where one
  // takes long, `refused(message)` where there is none.
  constructor(engine, state, { all, drawn, slow, refused }) {
    this.#engine = engine;
    this.#state = state;
    this.#all = all;
    this.#drawn = drawn;
    this.#slow = slow;
    this.#refused = refused;
  }

  // The state has changed: draws what is missing of it.
  ask() {
    this.#changed_ms = performance.now();
    this.#wanted = true;
    if (!this.#busy) this.#run();
  }

  // What was drawn says nothing of what is asked next: files have changed.
  forget() {
    this.#key = "";
  }

  // Frames in a second, over the last few of a movement; 0 where there is none.
  get rate() {
    const times = this.#shown_ms;
    if (times.length < 2 || performance.now() - times.at(-1) > 1000) return 0;
    return 1000 * (times.length - 1) / (times.at(-1) - times[0]);
  }

  async #run() {
    this.#busy = true;
    while (this.#wanted) {
      this.#wanted = false;
      clearTimeout(this.#timer);
      // What the module does not answer at all, such as where its memory ends, is a refusal like any other.
      await this.#draw(performance.now() - this.#changed_ms >= kRest_ms).catch((error) => this.#refused(error.message));
    }
    this.#busy = false;
  }

  async #draw(rests) {
    const wanted = Viewer.wanted(this.#state);
    const all = this.#all();
    const request = frameRequest(this.#state, rests ? all : wanted.filter((name) => all.includes(name)), rests);
    const key = JSON.stringify({ ...request, only: [], hashes: false });
    if (key === this.#key && this.settled) return this.#paint();
    const slow = setTimeout(this.#slow, kSlow_ms);
    const { reply, buffers } = await this.#engine.ask(request).finally(() => clearTimeout(slow));
    if (reply.error !== undefined) {
      this.#key = "";
      cancelAnimationFrame(this.#painting);
      return this.#refused(reply.error);
    }
    // Another view of the same frame keeps the buffers that it has.
    this.buffers = key === this.#key ? { ...this.buffers, ...buffers } : buffers;
    this.reply = reply;
    this.#noteTimes(reply);
    this.settled = rests;
    this.#key = key;
    this.#shown_ms = rests ? [] : [...this.#shown_ms, performance.now()].slice(-kRateFrames);
    this.#paint();
    if (!rests) this.#timer = setTimeout(() => { this.#wanted = true; if (!this.#busy) this.#run(); }, kRest_ms);
  }

  #noteTimes({ passes, unchanged }) {
    const ran = passes.slice(0, -1);
    for (const { name, wall_ms } of ran) this.#pass_ms.set(name, wall_ms);
    const names = new Set([...ran.map(({ name }) => name), ...unchanged]);
    this.frame_ms = [...names].reduce((sum, name) => sum + (this.#pass_ms.get(name) ?? 0), 0);
  }

  // With the next picture of the screen, so that the module begins the next frame meanwhile.
  #paint() {
    cancelAnimationFrame(this.#painting);
    this.#painting = requestAnimationFrame(this.#drawn);
  }
}
