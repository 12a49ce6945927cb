// Plots of a report that zoom: all marks move, the axes name other values, and rings go round what is best of the methods that are
// shown. Reads the groups that chapters/notebook/plot.h names.
"use strict";

const kReach_px = 18;      // how near the pointer must come to a point
const kLargestZoom = 200;
const kLinearTicks = 6;    // about so many on an axis without decades

const svgElement = (name, attributes) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

function axisOf(words) {
  const [kind, ...numbers] = words.split(" ");
  const [low, high, from, to] = numbers.map(Number);
  return { logarithmic: kind === "log", low, high, from, to };
}

// 1, 2 or 5 times a power of ten: the step of about kLinearTicks over this extent.
function tickStep(extent) {
  const power = 10 ** Math.floor(Math.log10(extent / kLinearTicks));
  return power * ([1, 2, 5].find((factor) => factor * power * kLinearTicks >= extent) ?? 10);
}

// The values that are named between two on an axis; those of a logarithmic one come as powers of ten.
function tickValues(logarithmic, low, high) {
  const values = [];
  if (logarithmic && high - low > 0.7) {
    for (let e = Math.floor(low); e <= high; ++e)
      for (const factor of high - low > 2 ? [1] : [1, 2, 5])
        if (Math.log10(factor) + e >= low && Math.log10(factor) + e <= high) values.push(factor * 10 ** e);
    return values;
  }
  const [first, last] = logarithmic ? [10 ** low, 10 ** high] : [low, high];
  const step = tickStep(last - first);
  for (let i = Math.ceil(first / step); i * step <= last; ++i) values.push(i * step);
  return values;
}

const shownValue = (value) => String(Number(value.toPrecision(6)));

class ZoomingPlot {
  constructor(svg) {
    this.svg = svg;
    this.grid = svg.querySelector("g.grid");
    this.marks = svg.querySelector("g.marks");
    this.x = axisOf(this.grid.dataset.x);
    this.y = axisOf(this.grid.dataset.y);
    this.original_grid = [...this.grid.childNodes];
    this.places = new Map();
    for (const mark of this.marks.querySelectorAll("line, circle, polyline, text")) this.remember(mark);
    this.front = svg.querySelector("g.front");
    this.original_front = [...(this.front?.children ?? [])];
    this.copies = [];  // of its marks, for a front of some methods alone
    this.clip();
    svg.classList.add("zooms");
    svg.tabIndex = 0;
    this.zoom = { x: 1, y: 1 };
    this.shift = { x: 0, y: 0 };
  }

  remember(mark) {
    const place = {};
    for (const name of ["x", "y", "x1", "y1", "x2", "y2", "cx", "cy"])
      if (mark.hasAttribute(name)) place[name] = Number(mark.getAttribute(name));
    if (mark.hasAttribute("points"))
      place.points = mark.getAttribute("points").trim().split(/\s+/).map((pair) => pair.split(",").map(Number));
    this.places.set(mark, place);
  }

  // What leaves the axes is not seen; what stands at their ends is seen whole.
  clip() {
    const id = "clip" + ZoomingPlot.count++, margin = 7;
    const path = svgElement("clipPath", { id });
    path.append(svgElement("rect", { x: this.x.from - margin, y: this.y.to - margin,
      width: this.x.to - this.x.from + 2 * margin, height: this.y.from - this.y.to + 2 * margin }));
    this.svg.prepend(path);
    this.marks.setAttribute("clip-path", `url(#${id})`);
  }

  whole() {
    this.zoom = { x: 1, y: 1 };
    this.shift = { x: 0, y: 0 };
    this.place();
  }

  // By a factor, about a point in the picture's own coordinates.
  zoomBy(factor, at) {
    for (const axis of ["x", "y"]) {
      const next = Math.min(Math.max(this.zoom[axis] * factor, 1), kLargestZoom);
      this.shift[axis] = at[axis] - (at[axis] - this.shift[axis]) * next / this.zoom[axis];
      this.zoom[axis] = next;
    }
    this.place();
  }

  zoomTo(a, b) {
    for (const [axis, { from, to }] of Object.entries({ x: this.x, y: this.y })) {
      const low = Math.min(a[axis], b[axis]), extent = Math.abs(a[axis] - b[axis]);
      const factor = Math.max(1 / this.zoom[axis], Math.min(Math.abs(to - from) / extent, kLargestZoom / this.zoom[axis]));
      this.shift[axis] = Math.min(from, to) + (this.shift[axis] - low) * factor;
      this.zoom[axis] *= factor;
    }
    this.place();
  }

  moveBy(x, y) { this.shift.x += x; this.shift.y += y; this.place(); }

  place() {
    for (const axis of ["x", "y"]) {  // never beyond what there is
      const { from, to } = this[axis], low = Math.min(from, to), high = Math.max(from, to), zoom = this.zoom[axis];
      this.shift[axis] = Math.min(low - zoom * low, Math.max(high - zoom * high, this.shift[axis]));
    }
    const to_x = (x) => this.zoom.x * x + this.shift.x, to_y = (y) => this.zoom.y * y + this.shift.y;
    for (const [mark, place] of this.places) {
      const span = mark.closest(".spans") !== null, start = this.x.from + 12;  // of a bar of ratios, which stays where it is
      const place_x = span ? (x) => start + (x - start) * this.zoom.x : mark.closest(".level") ? (x) => x : to_x;
      const place_y = span || mark.closest(".upright") ? (y) => y : to_y;
      for (const [name, value] of Object.entries(place)) {
        const set = name === "points" ? value.map(([x, y]) => `${place_x(x)},${place_y(y)}`).join(" ")
          : name.includes("x") ? place_x(value) : place_y(value);
        mark.setAttribute(name, set);
      }
    }
    this.drawGrid();
    if (here !== null && this.svg.contains(here) && !card.hidden) placeCard(here);
  }

  drawGrid() {
    if (this.zoom.x === 1 && this.zoom.y === 1) { this.grid.replaceChildren(...this.original_grid); return; }
    const stroke = this.grid.querySelector("line")?.getAttribute("stroke") ?? "currentColor";
    const ink = this.grid.querySelector("text")?.getAttribute("fill") ?? "currentColor";
    this.grid.replaceChildren();
    const add = (line, text, label) => {
      const words = svgElement("text", { ...text, fill: ink });
      words.textContent = label;
      this.grid.append(svgElement("line", { ...line, stroke }), words);
    };
    for (const name of ["x", "y"]) {
      const axis = this[name], { from, to } = axis;
      const value = (at) => axis.low + ((at - this.shift[name]) / this.zoom[name] - from) / (to - from) * (axis.high - axis.low);
      for (const tick of tickValues(axis.logarithmic, value(from), value(to))) {
        const power = axis.logarithmic ? Math.log10(tick) : tick;
        const at = this.zoom[name] * (from + (power - axis.low) / (axis.high - axis.low) * (to - from)) + this.shift[name];
        if (name === "x") add({ x1: at, x2: at, y1: this.y.from, y2: this.y.to }, { x: at, y: this.y.from + 18, "text-anchor": "middle" }, shownValue(tick));
        else add({ x1: this.x.from, x2: this.x.to, y1: at, y2: at }, { x: this.x.from - 6, y: at + 4, "text-anchor": "end" }, shownValue(tick));
      }
    }
  }

  // The points that are shown, inside the axes.
  circles() {
    return [...this.marks.querySelectorAll(".curve:not(.off) circle[data-point]")].filter((circle) => {
      const x = Number(circle.getAttribute("cx")), y = Number(circle.getAttribute("cy"));
      return x >= this.x.from - 1 && x <= this.x.to + 1 && y <= this.y.from + 1 && y >= this.y.to - 1;
    });
  }

  // The rings go round what is best of the methods that are shown.
  ringFront(filtered) {
    if (this.front === null) return;
    for (const copy of this.copies) this.places.delete(copy);
    this.copies = [];
    if (filtered) {
      const shown = [...this.marks.querySelectorAll(".curve:not(.off) circle[data-point]")].map((circle) => this.places.get(circle));
      const best = shown.sort((a, b) => a.cx - b.cx || b.cy - a.cy)
        .filter((point, i) => shown.slice(0, i).every((faster) => faster.cy < point.cy));
      const copied = (mark, place) => {
        const copy = mark.cloneNode();
        this.places.set(copy, place);
        return copy;
      };
      const ring = this.original_front.find((mark) => mark.tagName === "circle");
      const line = this.original_front.find((mark) => mark.tagName === "polyline");
      this.copies = [copied(line, { points: best.map(({ cx, cy }) => [cx, cy]) }), ...best.map(({ cx, cy }) => copied(ring, { cx, cy }))];
    }
    this.front.replaceChildren(...(filtered ? this.copies : this.original_front));
    this.place();
  }

  // Where an event is, in the picture's own coordinates.
  at(event) { return new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse()); }

  nearest(event) {
    let nearest = null, distance = kReach_px;
    for (const circle of this.circles()) {
      const box = circle.getBoundingClientRect();
      const away = Math.hypot(box.x + box.width / 2 - event.clientX, box.y + box.height / 2 - event.clientY);
      if (away < distance) [nearest, distance] = [circle, away];
    }
    return nearest;
  }
}
ZoomingPlot.count = 0;
