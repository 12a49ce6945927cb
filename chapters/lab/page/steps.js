// A list gone through step by step: a table of which so many rows are done, with buttons, a slider and a clock.
import { tableOf } from "./tables.js";
import { translated } from "./texts.js";

const kTick_ms = 400;

export class Steps {
  element = document.createElement("div");
  #rows;
  #slider;
  #told;
  #play;
  #count;
  #changed;
  #tell;
  #clock = 0;

  // `rows`: objects; `tell(done)`: what to say after so many of them; `changed(done, lit)`: how many are done, and which one
  // is lit, a number or null.
  constructor(rows, tell, changed) {
    this.#count = rows.length;
    this.#tell = tell;
    this.#changed = changed;
    const table = tableOf(rows);
    this.#rows = [...table.tBodies[0].rows];
    this.#rows.forEach((row, number) => this.#light(row, number));
    this.element.className = "steps";
    this.element.append(this.#bar(), this.#scrolled(table));
    this.#show(this.#count);
  }

  // So many rows are done, and the last of them is lit, or none where none or all are.
  go(done) {
    this.#show(done);
    this.#changed(done, done > 0 && done < this.#count ? done - 1 : null);
  }

  // All again, as when one begins to look at it.
  goToEnd() {
    this.go(this.#count);
  }

  #show(done) {
    this.#slider.value = done;
    this.#rows.forEach((row, number) => {
      row.classList.toggle("to-come", number >= done);
      row.classList.toggle("present", number === done - 1 && done < this.#count);
    });
    this.#told.textContent = this.#tell(done);
  }

  stop() {
    clearInterval(this.#clock);
    this.#clock = 0;
    this.#play.textContent = "▶";
    this.#play.setAttribute("aria-pressed", "false");
  }

  #light(row, number) {
    row.tabIndex = 0;
    const on = () => this.#changed(Number(this.#slider.value), number);
    const off = () => this.go(Number(this.#slider.value));
    row.addEventListener("pointerenter", on);
    row.addEventListener("focus", on);
    row.addEventListener("pointerleave", off);
    row.addEventListener("blur", off);
    row.addEventListener("click", () => this.go(number + 1));
  }

  #bar() {
    const bar = Object.assign(document.createElement("div"), { className: "step-bar" });
    this.#slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: this.#count, step: 1 });
    this.#slider.setAttribute("aria-label", translated("step"));
    this.#slider.addEventListener("input", () => this.go(Number(this.#slider.value)));
    this.#told = document.createElement("output");
    const button = (text, label, act) => {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: text });
      made.setAttribute("aria-label", translated(label));
      made.addEventListener("click", act);
      return made;
    };
    const by = (step) => () => {
      this.stop();
      this.go(Math.min(Math.max(Number(this.#slider.value) + step, 0), this.#count));
    };
    this.#play = button("▶", "play", () => (this.#clock === 0 ? this.#start() : this.stop()));
    bar.append(button("«", "step_first", () => { this.stop(); this.go(0); }), button("−1", "step_back", by(-1)),
      button("+1", "step_on", by(1)), this.#play, this.#slider, this.#told);
    return bar;
  }

  #start() {
    this.#play.textContent = "❚❚";
    this.#play.setAttribute("aria-pressed", "true");
    if (Number(this.#slider.value) === this.#count) this.go(0);
    this.#clock = setInterval(() => {
      this.go(Number(this.#slider.value) + 1);
      if (Number(this.#slider.value) === this.#count || !this.element.isConnected) this.stop();
    }, kTick_ms);
  }

  #scrolled(table) {
    const place = Object.assign(document.createElement("div"), { className: "scroll" });
    place.append(table);
    return place;
  }
}
