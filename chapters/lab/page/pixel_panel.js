// Why a pixel is as it is: what the probe tells of each pass, its samples in the picture and in a cut, step by step.
import { drawOverlay } from "./overlay.js";
import { sectionOf } from "./section.js";
import { Steps } from "./steps.js";
import { cellText, isList, membersOf, tableOf } from "./tables.js";
import { translated } from "./texts.js";

// What one wants to know of a sample first.
const kFirstColumns = ["number", "verdict", "contribution", "sum"];

const withFirst = (row) => ({ ...Object.fromEntries(kFirstColumns.filter((name) => name in row).map((name) => [name, row[name]])), ...row });

// "{a} of {b}" with words in the places.
const filled = (key, words) => translated(key).replace(/\{(\w+)\}/g, (mark, name) => words[name]);

export class PixelPanel {
  #place;
  #overlay;
  #frame = null;  // {size, camera, view_depth} of the frame that is probed
  #probe = null;
  #steps = [];

  constructor(place, overlay) {
    this.#place = place;
    this.#overlay = overlay;
    new ResizeObserver(() => this.#mark([])).observe(overlay);
  }

  // Nothing is asked about.
  clear() {
    this.#stop();
    this.#probe = null;
    this.#place.replaceChildren();
    this.#mark([]);
  }

  // `probe` as the command tells it with --json; `frame`: {size: {width, height}, camera, view_depth}.
  show(probe, frame) {
    this.#stop();
    this.#probe = probe;
    this.#frame = frame;
    const passes = Object.entries(probe.passes).map(([name, pass]) => this.#passElement(name, pass));
    this.#place.replaceChildren(...passes);
    if (probe.passes.ao === undefined || probe.passes.ao.samples.length === 0) this.#mark([]);
  }

  #stop() {
    for (const steps of this.#steps) steps.stop();
    this.#steps = [];
  }

  #passElement(name, pass) {
    const details = Object.assign(document.createElement("details"), { className: "pass", open: name === "ao" });
    details.dataset.pass = name;
    const summary = Object.assign(document.createElement("summary"), { textContent: this.#headOf(name, pass) });
    details.append(summary);
    for (const [list_name, list] of Object.entries(pass).filter(([, value]) => isList(value))) {
      details.append(Object.assign(document.createElement("h4"), { textContent: list_name.replaceAll("_", " ") }));
      if (list_name === "samples") details.append(this.#samples(pass));
      else if (list_name === "taps") details.append(this.#taps(pass));
      else details.append(tableOf(list));
    }
    details.append(membersOf(pass));
    return details;
  }

  #headOf(name, pass) {
    if (name !== "ao" || pass.samples.length === 0) return name;
    const count = pass.samples.filter(({ contribution }) => contribution > 0).length;
    return filled("ao_answer", { value: cellText(pass.value), count, all: pass.samples.length });
  }

  #samples(ao) {
    const place = document.createElement("div"), cut = document.createElement("div");
    const show = (done, lit) => {
      this.#mark(ao.samples.slice(0, done).map(({ q_screen: [x, y], contribution }, number) =>
        ({ x, y, kind: contribution > 0 ? "occludes" : "open", lit: number === lit })));
      cut.innerHTML = sectionOf({ ao, ...this.#frame, lit, done });
    };
    const tell = (done) => {
      const sum = done === 0 ? 0 : ao.samples[done - 1].sum;
      const so_far = filled("sum_so_far", { done, all: ao.samples.length, sum: cellText(sum) });
      return done < ao.samples.length ? so_far : `${so_far}; ${ao.formula} = ${cellText(ao.value)}`;
    };
    cut.className = "cut-place";
    place.append(cut, this.#stepped(ao.samples.map(withFirst), tell, show));
    return place;
  }

  #taps(blur) {
    const [map_width, map_height] = blur.map_size ?? [this.#frame.size.width, this.#frame.size.height];
    const { width, height } = this.#frame.size;
    const show = (done, lit) => {
      this.#mark(blur.taps.slice(0, done).map(({ texel: [x, y], counts }, number) =>
        ({ x: (x + 0.5) * width / map_width, y: (y + 0.5) * height / map_height, kind: counts ? "open" : "occludes", lit: number === lit })));
    };
    const tell = (done) => filled("sum_so_far", { done, all: blur.taps.length, sum: cellText(done === 0 ? 0 : blur.taps[done - 1].sum) });
    return this.#stepped(blur.taps, tell, show);
  }

  #stepped(rows, tell, show) {
    const steps = new Steps(rows, tell, show);
    this.#steps.push(steps);
    return steps.element;
  }

  #mark(marks) {
    if (this.#frame === null) return;
    const asked = this.#probe === null ? null : { x: this.#probe.pixel[0], y: this.#probe.pixel[1] };
    drawOverlay(this.#overlay, this.#frame.size, asked, marks);
  }
}
