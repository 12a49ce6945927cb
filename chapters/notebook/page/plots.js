// How a report's plots are used: by pointer, wheel, keys and buttons, and by choosing scenes, methods and threads. Without any of it the
// page still reads.
"use strict";

const kZoomStep = 1.5;     // of a button or a key
const kLeastBox_px = 8;    // what is dragged over less than this is a click

// ---- pointer, wheel and keys -----------------------------------------------------------------------------------------------

function dragsAndPoints(plot) {
  const { svg } = plot;
  let start = null, last = null, box = null;
  const end = () => { start = null; box?.remove(); box = null; svg.classList.remove("moving"); };
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.pointerType === "touch") return;
    [start, last] = [plot.at(event), event];
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (start === null) { showPoint(plot.nearest(event)); return; }
    const now = plot.at(event);
    if (event.shiftKey) {
      const before = plot.at(last);
      svg.classList.add("moving");
      plot.moveBy(now.x - before.x, now.y - before.y);
    } else if (box !== null || Math.hypot(now.x - start.x, now.y - start.y) > kLeastBox_px) {
      box ??= svg.appendChild(svgElement("rect", { class: "area" }));
      for (const [name, value] of Object.entries({ x: Math.min(now.x, start.x), y: Math.min(now.y, start.y),
        width: Math.abs(now.x - start.x), height: Math.abs(now.y - start.y) })) box.setAttribute(name, value);
    }
    last = event;
  });
  svg.addEventListener("pointerup", (event) => {
    const now = plot.at(event);
    const dragged = start !== null && !svg.classList.contains("moving") && box !== null
      && Math.min(Math.abs(now.x - start.x), Math.abs(now.y - start.y)) > kLeastBox_px;
    const moved = box !== null || svg.classList.contains("moving");
    if (dragged) plot.zoomTo(start, now);
    end();
    if (moved) return;
    const circle = plot.nearest(event);
    showPoint(circle);
    if (circle !== null) copyCommand(circle);
  });
  svg.addEventListener("pointercancel", end);
  svg.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") showPoint(null); });
  svg.addEventListener("blur", () => showPoint(null));
  // Pages scroll over a plot that nobody has chosen.
  svg.addEventListener("wheel", (event) => {
    if (document.activeElement !== svg && !event.ctrlKey) return;
    event.preventDefault();
    plot.zoomBy(Math.exp(-event.deltaY / 400), plot.at(event));
  }, { passive: false });
}

const middleOf = (plot) => ({ x: (plot.x.from + plot.x.to) / 2, y: (plot.y.from + plot.y.to) / 2 });

function keys(plot) {
  plot.svg.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const by = { ArrowRight: ["cx", 1], ArrowLeft: ["cx", -1], ArrowUp: ["cy", -1], ArrowDown: ["cy", 1] }[event.key];
    const zoom = { "+": kZoomStep, "=": kZoomStep, "-": 1 / kZoomStep }[event.key];
    if (by !== undefined) {
      const place = (circle) => Number(circle.getAttribute(by[0]));
      const circles = plot.circles().sort((a, b) => place(a) - place(b));
      const next = circles.indexOf(here) + by[1];
      const first = by[1] > 0 ? 0 : circles.length - 1;
      showPoint(circles[circles.includes(here) ? Math.min(Math.max(next, 0), circles.length - 1) : first] ?? null);
    } else if (zoom !== undefined) {
      plot.zoomBy(zoom, here !== null ? { x: Number(here.getAttribute("cx")), y: Number(here.getAttribute("cy")) } : middleOf(plot));
    } else if (event.key === "0") {
      plot.whole();
    } else if (event.key === "Enter" && here !== null) {
      copyCommand(here);
    } else if (event.key === "Escape") {
      showPoint(null);
    } else {
      return;
    }
    event.preventDefault();
  });
}

function buttons(plot) {
  const tools = document.createElement("div");
  tools.className = "plot-tools";
  const add = (label, name, action) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.setAttribute("aria-label", name);
    button.addEventListener("click", action);
    tools.append(button);
  };
  add("+", "larger", () => plot.zoomBy(kZoomStep, middleOf(plot)));
  add("−", "smaller", () => plot.zoomBy(1 / kZoomStep, middleOf(plot)));
  add("whole", "the whole plot", () => plot.whole());
  const hint = document.createElement("span");
  hint.textContent = "Drag over a part to enlarge it, with Shift to move. Click the plot first for the wheel and the keys: arrows go from point to point, + − 0 zoom.";
  tools.append(hint);
  plot.svg.closest("figure").querySelector(".scroll").after(tools);
}

// ---- filters -----------------------------------------------------------------------------------------------------------------

const distinct = (values) => [...new Set(values)];

function choice(form, name, values, shown) {
  if (values.length < 2) return null;
  const label = document.createElement("label"), select = document.createElement("select");
  label.append(name + " ", select);
  select.name = name;
  for (const value of ["", ...values]) select.append(new Option(value === "" ? "all" : shown(value), value));
  form.append(label);
  return select;
}

// A curve's name begins with its method.
const isOf = (curve, method) => curve === method || curve.startsWith(method + ",");

function setUpFilters(plots) {
  const main = document.querySelector("main");
  const sections = [...main.querySelectorAll("section[data-scene]")], blocks = [...main.querySelectorAll("[data-threads]")];
  const tables = [...main.querySelectorAll("table")].filter((table) => table.tHead?.rows[0].cells[0].textContent === "method");
  const methods = distinct(tables.flatMap((table) => [...table.tBodies[0].rows].map((row) => row.cells[0].textContent)));
  const form = document.createElement("form");
  form.className = "filters";
  form.setAttribute("aria-label", "filters");
  const scene = choice(form, "scene", distinct(sections.map((section) => section.dataset.scene)), (name) => name);
  const threads = choice(form, "threads", distinct(blocks.map((block) => block.dataset.threads)), (name) => name);
  const boxes = methods.length < 2 ? [] : methods.map((method) => {
    const label = document.createElement("label"), box = document.createElement("input");
    Object.assign(box, { type: "checkbox", checked: true, name: "method", value: method });
    label.append(box, " " + method);
    form.append(label);
    return box;
  });
  if (form.childElementCount === 0) return;
  const apply = () => {
    const hidden = boxes.filter((box) => !box.checked).map((box) => box.value);
    for (const section of sections) section.classList.toggle("off", Boolean(scene?.value) && section.dataset.scene !== scene.value);
    for (const block of blocks) block.classList.toggle("off", Boolean(threads?.value) && block.dataset.threads !== threads.value);
    for (const table of tables)
      for (const row of table.tBodies[0].rows) row.classList.toggle("off", hidden.includes(row.cells[0].textContent));
    for (const curve of main.querySelectorAll("svg [data-name]"))
      if (!curve.classList.contains("front")) curve.classList.toggle("off", hidden.some((method) => isOf(curve.dataset.name, method)));
    for (const plot of plots) plot.ringFront(hidden.length > 0);
    showPoint(null);
  };
  form.addEventListener("input", apply);
  form.addEventListener("submit", (event) => event.preventDefault());
  main.querySelector("h1").after(form);
}

function setUp() {
  document.body.append(card);
  const plots = [...document.querySelectorAll("svg:has(g.grid):has(circle[data-point])")].map((svg) => new ZoomingPlot(svg));
  for (const plot of plots) { dragsAndPoints(plot); keys(plot); buttons(plot); }
  addEventListener("scroll", () => { if (here !== null && !card.hidden) placeCard(here); }, { passive: true });
  setUpFilters(plots);
}

setUp();
