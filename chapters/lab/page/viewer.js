// The picture on the page: one buffer, two beside each other or on both sides of an edge, their difference, or one after
// the other. Each canvas has the pixels of its buffer, and is stretched to the picture's place.
import { differenceOf, imageOf, rangeOf, scalarAt, shortest } from "./colour.js";

export class Viewer {
  edge_percent = 50;  // of the picture, where the second buffer begins
  flipped = false;    // flip: the second buffer is on
  #parts;             // {first, second, stage}
  #shown = [];        // {name, buffer} of each canvas

  constructor(stage) {
    this.#parts = { stage, first: stage.querySelector(".first canvas"), second: stage.querySelector(".second canvas") };
  }

  // The names of the buffers that a state shows.
  static wanted(state) {
    return state.view === "one" ? [state.show] : [state.show, state.against];
  }

  // `buffers`: by name, those that there are.
  show(state, buffers) {
    const { stage, first, second } = this.#parts;
    const range = rangeOfWord(state.range);
    const a = buffers[state.show], b = buffers[state.against];
    stage.dataset.view = state.view;
    stage.style.setProperty("--edge", `${this.edge_percent}%`);
    stage.classList.toggle("flipped", this.flipped);
    this.#shown = [];
    if (state.view === "difference") {
      const difference = a && b ? differenceOf(a, b) : null;
      if (difference !== null) this.#draw(first, "difference", difference, state.colours, range);
      return difference !== null;
    }
    if (a) this.#draw(first, state.show, a, state.colours, range);
    if (b && state.view !== "one") this.#draw(second, state.against, b, state.colours, range);
    return Boolean(a) && (state.view === "one" || Boolean(b));
  }

  #draw(canvas, name, buffer, colours, range) {
    if (canvas.width !== buffer.width || canvas.height !== buffer.height) Object.assign(canvas, { width: buffer.width, height: buffer.height });
    canvas.getContext("2d").putImageData(imageOf(name, buffer, colours, range), 0, 0);
    canvas.setAttribute("aria-label", name);
    canvas.closest("figure").querySelector("figcaption").textContent = name;
    this.#shown.push({ name, buffer, canvas });
  }

  // What the histogram is of: the buffer on top.
  get shown() {
    return this.#shown[this.flipped ? 1 : 0] ?? this.#shown[0];
  }

  // The pixel of the picture, of `size` pixels, under the pointer; null beside it.
  pixelAt(event, size) {
    const canvas = this.#canvasAt(event);
    if (canvas === null) return null;
    const { x, y } = sharesAt(event, canvas);
    return { x: Math.floor(x * size.width), y: Math.floor(y * size.height) };
  }

  #canvasAt(event) {
    const { first, second, stage } = this.#parts;
    const canvas = stage.dataset.view === "pair" && inside(event, second) ? second : first;
    return inside(event, canvas) ? canvas : null;
  }

  // "ao_blurred (12, 34) = 0.5", of every buffer shown there.
  valuesAt(event) {
    const canvas = this.#canvasAt(event);
    if (canvas === null) return "";
    const { x, y } = sharesAt(event, canvas);
    return this.#shown.map(({ name, buffer }) => {
      const column = Math.floor(x * buffer.width), row = Math.floor(y * buffer.height);
      return `${name} (${column}, ${row}) = ${valueText(buffer, column, row)}`;
    }).join("   ");
  }
}

export function valueText(buffer, x, y) {
  const numbers = [];
  for (let c = 0; c < buffer.components; ++c) numbers.push(shortest(buffer.values[(c * buffer.height + y) * buffer.width + x]));
  return numbers.join(" ");
}

// "low,high" as two numbers; null for anything else.
export function rangeOfWord(word) {
  const numbers = word.split(",").map(Number);
  return word !== "" && numbers.length === 2 && numbers.every(Number.isFinite) && numbers[0] < numbers[1] ? numbers : null;
}

function inside(event, canvas) {
  const { x, y } = sharesAt(event, canvas);
  return x >= 0 && y >= 0 && x < 1 && y < 1;
}

function sharesAt(event, canvas) {
  const box = canvas.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
}

// ---- how often which values stand in a buffer ------------------------------------------------------------------------

const kBins = 96;

// Into an <svg> with the viewBox 0 0 kBins 30. The mean of a pixel's components counts; what lies beyond the range is left out.
export function drawHistogram(svg, buffer, range) {
  const [low, high] = range ?? rangeOf(buffer);
  const counts = new Array(kBins).fill(0);
  for (let pixel = 0; pixel < buffer.width * buffer.height; ++pixel) {
    const bin = Math.floor((scalarAt(buffer, pixel) - low) / (high - low) * kBins);
    if (bin >= 0 && bin <= kBins) ++counts[Math.min(bin, kBins - 1)];
  }
  // One full bin, such as that of open surfaces at 1, would leave nothing to see of the others: heights are roots.
  const tallest = Math.sqrt(Math.max(...counts, 1));
  const bars = counts.map((count, bin) => {
    const height = 30 * Math.sqrt(count) / tallest;
    return `M${bin} 30v${-height.toFixed(2)}h1V30z`;
  });
  svg.innerHTML = `<path d="${bars.join("")}"/>`;
  return [low, high];
}
