// Why a pixel is as it is: what the probe tells of each pass, its samples in the picture and in a cut, step by step.
import { drawOverlay } from "./overlay.js";
import { sectionOf } from "./section.js";
import { probeText } from "./probe_texts.js";
import { Steps } from "./steps.js";
import { cellText, isList, membersOf, tableOf } from "./tables.js";
import { translated } from "./texts.js";

// What one wants to know of a sample first.
const kFirstColumns = ["number", "verdict", "contribution", "sum"];
// Lists that are gone through step by step.
const kStepped = ["samples", "taps", "passes"];

const withFirst = (row) => ({ ...Object.fromEntries(kFirstColumns.filter((name) => name in row).map((name) => [name, row[name]])), ...row });

function foldOf(title, className) {
  const details = Object.assign(document.createElement("details"), { className });
  details.append(Object.assign(document.createElement("summary"), { textContent: title }));
  return details;
}

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
    const answer = Object.assign(document.createElement("p"), { textContent: probeText(probe.answer) });
    const passes = Object.entries(probe.passes).map(([name, pass]) => this.#passElement(name, pass));
    this.#place.replaceChildren(answer, ...passes);
    this.#mark([]);
    this.#steps[0]?.goToEnd();
  }

  #stop() {
    for (const steps of this.#steps) steps.stop();
    this.#steps = [];
  }

  // The samples of the method and the taps of its blur step by step, other lists as tables, then the pass's own numbers.
  #passElement(name, pass) {
    const details = foldOf(name, "pass");
    details.dataset.pass = name;
    details.open = name === "ao";
    if (name === "ao" && pass.samples.length > 0) details.append(this.#samples(pass, details));
    if (name === "blur") details.append(...pass.passes.map((iteration) => this.#taps(iteration)));
    for (const [list, rows] of Object.entries(pass).filter(([key, value]) => isList(value) && !kStepped.includes(key)))
      details.append(Object.assign(document.createElement("h4"), { textContent: list.replaceAll("_", " ") }), tableOf(rows));
    details.append(membersOf(pass));
    return details;
  }

  #samples(ao, details) {
    const place = document.createElement("div"), cut = Object.assign(document.createElement("div"), { className: "cut-place" });
    const show = (done, lit) => {
      this.#mark(ao.samples.slice(0, done).map(({ q_screen: [x, y], contribution }, number) =>
        ({ x, y, kind: contribution > 0 ? "occludes" : "open", lit: number === lit })));
      cut.innerHTML = sectionOf({ ao, ...this.#frame, lit, done });
    };
    const sums = ao.samples.map(({ sum }) => sum);
    const steps = this.#stepped(ao.samples.map(withFirst), sums, `${ao.formula} = ${cellText(ao.value)}`, show, details);
    place.append(cut, steps);
    return place;
  }

  // One pass of the blur.
  #taps({ name, taps, last_step, value }) {
    const details = foldOf(`${probeText(name)}: ${cellText(value)}`, "iteration");
    const { width, height } = this.#frame.size, [map_width, map_height] = this.#probe.passes.ao.map_size;
    // As the kernel adds up: floats, tap after tap.
    let sum = 0;
    const sums = taps.map(({ value: of_tap, weight }) => (sum = Math.fround(sum + Math.fround(weight * of_tap))));
    const show = (done, lit) => this.#mark(taps.slice(0, done).map(({ texel: [x, y], weight }, number) =>
      ({ x: (x + 0.5) * width / map_width, y: (y + 0.5) * height / map_height, kind: weight > 0 ? "open" : "occludes", lit: number === lit })));
    const rows = taps.map((tap, number) => ({ number, ...tap, sum: sums[number] }));
    details.append(this.#stepped(rows, sums, `${probeText(last_step)} = ${cellText(value)}`, show, details));
    return details;
  }

  // Steps that are in the picture as soon as their fold is opened.
  #stepped(rows, sums, result, show, details) {
    const tell = (done) => {
      const so_far = filled("sum_so_far", { done, all: rows.length, sum: cellText(done === 0 ? 0 : sums[done - 1]) });
      return done < rows.length ? so_far : `${so_far}; ${result}`;
    };
    const steps = new Steps(rows, tell, show);
    this.#steps.push(steps);
    details.addEventListener("toggle", (event) => { if (event.target === details && details.open) steps.goToEnd(); });
    return steps.element;
  }

  #mark(marks) {
    if (this.#frame === null) return;
    const asked = this.#probe === null ? null : { x: this.#probe.pixel[0], y: this.#probe.pixel[1] };
    drawOverlay(this.#overlay, this.#frame.size, asked, marks);
  }
}
