// Truth by rays that refines while somebody looks, and how far the AO on screen is off.
import { shortest } from "./colour.js";
import { translated } from "./texts.js";

// The buffers that it adds to those of a frame.
export const kTruthBuffers = ["truth", "ao_error", "truth_error"];
// Where it stops: another pass would change no pixel by a grey level.
const kMostRays = 4096;

export class TruthPanel {
  #engine;
  #frames;
  #output;
  #refined;
  #on = false;
  #busy = false;

  // `refined()` is called when there are new buffers among those of the frame.
  constructor(engine, frames, output, refined) {
    this.#engine = engine;
    this.#frames = frames;
    this.#output = output;
    this.#refined = refined;
  }

  set on(value) {
    this.#on = value;
    if (!value) this.#output.textContent = "";
    this.goOn();
  }

  // To be called with every frame: casts rays as long as it stays.
  async goOn() {
    if (!this.#on || this.#busy || !this.#frames.settled) return;
    this.#busy = true;
    const { reply: of_frame } = this.#frames;
    let rays = 0;
    while (this.#on && this.#frames.settled && this.#frames.reply === of_frame && rays < kMostRays) {
      const { reply, buffers } = await this.#engine.ask({ ask: "truth" });
      if (!this.#on || this.#frames.reply !== of_frame) break;
      if (reply.error !== undefined) {
        this.#output.textContent = reply.error;
        break;
      }
      rays = reply.rays;
      if (reply.rmse === undefined) continue;
      Object.assign(this.#frames.buffers, buffers);
      this.#tell(reply);
      this.#refined();
    }
    this.#busy = false;
    if (this.#frames.reply !== of_frame) this.goOn();
  }

  #tell({ rays, rmse, bias }) {
    const frame_ms = this.#frames.frame_ms.toFixed(1);
    this.#output.textContent = translated("truth_told").replace("{rays}", rays).replace("{rmse}", digits(rmse))
      .replace("{bias}", digits(bias)).replace("{ms}", frame_ms);
  }
}

const digits = (value) => shortest(Math.fround(Number(value.toPrecision(3))));
