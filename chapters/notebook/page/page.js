// What the pages of the book do beyond standing there: languages, mathematics, colours of code, links to the lab, pictures that enlarge,
// compare and tell their values. Everything works from the disk, and without any of it the text still reads.
"use strict";

// ---- language ----------------------------------------------------------------------------------------------------

function setLanguage(language) {
  const root = document.documentElement;
  root.dataset.lang = root.lang = language;
  for (const button of document.querySelectorAll("[data-set-lang]"))
    button.setAttribute("aria-pressed", String(button.dataset.setLang === language));
}

// What the reader has chosen on some page, else the browser's language, else the page's own.
function firstLanguage() {
  let chosen = null;
  try { chosen = localStorage.getItem("crevice-language"); } catch { /* some browsers keep nothing for files */ }
  const own = document.documentElement.dataset.lang;
  return [chosen, navigator.language.slice(0, 2), own].find((language) => ["en", "zh"].includes(language));
}

function chooseLanguage(language) {
  setLanguage(language);
  try { localStorage.setItem("crevice-language", language); } catch { /* as above */ }
}

function setUpLanguages() {
  const buttons = document.querySelectorAll("[data-set-lang]");
  if (buttons.length === 0) return;
  const asked = new URLSearchParams(location.search).get("lang");
  if (asked === "en" || asked === "zh") chooseLanguage(asked);
  else setLanguage(firstLanguage());
  for (const button of buttons) button.addEventListener("click", () => chooseLanguage(button.dataset.setLang));
}

// ---- mathematics and code ----------------------------------------------------------------------------------------

function setMathematics() {
  if (typeof katex === "undefined") return;
  for (const element of document.querySelectorAll("x-equation")) {
    const displayMode = element.getAttribute("type") === "display";
    katex.render(element.textContent, element, { displayMode, throwOnError: true });
    if (!displayMode) keepPunctuation(element);
  }
}

// A formula in a line is a block to the browser, which would begin the next line with the comma behind it. One of several
// blocks may be longer than a line, and stays.
function keepPunctuation(formula) {
  const next = formula.nextSibling;
  if (next === null || next.nodeType !== Node.TEXT_NODE || formula.querySelectorAll(".base").length !== 1) return;
  const [marks] = /^[.,;:!?)\]\u3001\u3002\uff01\uff09\uff0c\uff1a\uff1b\uff1f]*/.exec(next.data);
  if (marks === "") return;
  next.data = next.data.slice(marks.length);
  const whole = document.createElement("span");
  whole.className = "unbroken";
  formula.replaceWith(whole);
  whole.append(formula, marks);
}

function colourCode() {
  if (typeof hljs === "undefined") return;
  for (const element of document.querySelectorAll("code.language-cpp")) hljs.highlightBlock(element);
}

// ---- the lab ---------------------------------------------------------------------------------------------------------

// What a command draws in a terminal the lab draws in the browser. `./crevice.sh web` puts it beside these pages.
function linkCommandsToLab() {
  for (const code of document.querySelectorAll("code")) {
    if (!/^crevice (render|probe) /.test(code.textContent) || code.closest("pre, a") !== null) continue;
    const link = document.createElement("a");
    link.href = "lab.html#" + encodeURIComponent(code.textContent);
    link.title = "in the lab: ./crevice.sh web";
    code.replaceWith(link);
    link.append(code);
  }
}

// ---- values under the pointer ------------------------------------------------------------------------------------

// The floats of a picture travel as a grey PNG four times as high for each component: the bytes of all values of one
// significance lie together, the lowest on top.
const knownValues = new Map();

async function valuesOf(picture) {
  const name = picture.dataset.name;
  if (knownValues.has(name)) return knownValues.get(name);
  const source = picture.querySelector("script.values");
  const image = picture.querySelector("img");
  const shown = source === null;
  const loaded = new Image();
  loaded.src = shown ? image.src : "data:image/png;base64," + source.textContent;
  await loaded.decode();
  const canvas = document.createElement("canvas");
  canvas.width = loaded.naturalWidth;
  canvas.height = loaded.naturalHeight;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(loaded, 0, 0);
  const rgba = context.getImageData(0, 0, canvas.width, canvas.height).data;
  const width = Number(picture.dataset.width), height = Number(picture.dataset.height);
  const components = shown ? 1 : canvas.height / height / 4;
  const bits = new DataView(new ArrayBuffer(4));
  const read = (x, y) => {
    const at = (column, row) => rgba[4 * (row * width + column)];
    if (shown) {
      const first = 4 * (y * width + x);
      return [rgba[first], rgba[first + 1], rgba[first + 2]].map((byte) => String(byte)).join(" ") + " of 255";
    }
    const numbers = [];
    for (let c = 0; c < components; ++c) {
      for (let byte = 0; byte < 4; ++byte) bits.setUint8(byte, at(x, (4 * c + byte) * height + y));
      numbers.push(shortest(bits.getFloat32(0, true)));
    }
    return numbers.join(" ");
  };
  knownValues.set(name, read);
  return read;
}

// The fewest digits that read back as the same float.
function shortest(value) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf");
  for (let digits = 6; digits < 10; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === value) return String(Number(text));
  }
  return String(value);
}

const readout = document.createElement("div");
readout.id = "value";
readout.hidden = true;

async function tellValue(picture, image, event) {
  const box = image.getBoundingClientRect();
  const width = Number(picture.dataset.width), height = Number(picture.dataset.height);
  const x = Math.floor((event.clientX - box.left) / box.width * width);
  const y = Math.floor((event.clientY - box.top) / box.height * height);
  if (x < 0 || y < 0 || x >= width || y >= height) { readout.hidden = true; return; }
  const read = await valuesOf(picture);
  readout.textContent = `${picture.dataset.name} (${x}, ${y}) = ${read(x, y)}`;
  readout.hidden = false;
  const left = Math.min(event.clientX + 14, innerWidth - readout.offsetWidth - 8);
  readout.style.left = Math.max(left, 4) + "px";
  readout.style.top = (event.clientY + 18 + readout.offsetHeight > innerHeight ? event.clientY - 30 : event.clientY + 18) + "px";
}

function tellValuesOf(picture, image) {
  image.addEventListener("pointermove", (event) => tellValue(picture, image, event));
  image.addEventListener("pointerleave", () => { readout.hidden = true; });
}

// ---- a picture as large as the window ------------------------------------------------------------------------------

function openViewer(picture) {
  const dialog = document.createElement("dialog");
  dialog.className = "viewer";
  dialog.setAttribute("aria-label", picture.dataset.name);
  dialog.innerHTML =
    '<div class="bar-of-tools"><button data-step="1.5" aria-label="larger">+</button>' +
    '<button data-step="0.6667" aria-label="smaller">−</button><button data-step="0" aria-label="whole picture">0</button>' +
    '<button data-step="close" aria-label="close">✕</button></div><div class="view"></div>';
  const view = dialog.querySelector(".view");
  const image = picture.querySelector("img").cloneNode();
  image.removeAttribute("style");
  const width = Number(picture.dataset.width), height = Number(picture.dataset.height);
  image.style.width = width + "px";
  view.append(image);
  dialog.append(readout);
  document.body.append(dialog);
  let scale = 1, x = 0, y = 0;
  const place = () => { image.style.transform = `translate(${x}px, ${y}px) scale(${scale})`; };
  const whole = () => {
    scale = Math.min(view.clientWidth / width, view.clientHeight / height);
    x = (view.clientWidth - scale * width) / 2;
    y = (view.clientHeight - scale * height) / 2;
    place();
  };
  const zoom = (factor, at_x = view.clientWidth / 2, at_y = view.clientHeight / 2) => {
    const next = Math.min(Math.max(scale * factor, 0.1), 64);
    x = at_x - (at_x - x) * next / scale;
    y = at_y - (at_y - y) * next / scale;
    scale = next;
    place();
  };
  const step = (word) => {
    if (word === "close") dialog.close();
    else if (word === "0") whole();
    else zoom(Number(word));
  };
  dialog.addEventListener("click", (event) => {
    if (event.target.dataset.step !== undefined) step(event.target.dataset.step);
  });
  dialog.addEventListener("keydown", (event) => {
    const move = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] }[event.key];
    if (move) { x += move[0]; y += move[1]; place(); event.preventDefault(); }
    if (event.key === "+" || event.key === "=") zoom(1.5);
    if (event.key === "-") zoom(1 / 1.5);
    if (event.key === "0") whole();
  });
  view.addEventListener("wheel", (event) => {
    event.preventDefault();
    const box = view.getBoundingClientRect();
    zoom(Math.exp(-event.deltaY / 400), event.clientX - box.left, event.clientY - box.top);
  }, { passive: false });
  view.addEventListener("pointerdown", (event) => { view.setPointerCapture(event.pointerId); event.preventDefault(); });
  view.addEventListener("pointermove", (event) => {
    if (view.hasPointerCapture(event.pointerId)) { x += event.movementX; y += event.movementY; place(); }
    else tellValue(picture, image, event);
  });
  dialog.addEventListener("close", () => {
    readout.hidden = true;
    document.body.append(readout);
    dialog.remove();
    picture.querySelector("button.canvas").focus();
  });
  dialog.showModal();
  whole();
}

function setUpPictures() {
  document.body.append(readout);
  for (const picture of document.querySelectorAll(".picture")) {
    const button = picture.querySelector("button.canvas");
    if (button === null) continue;
    tellValuesOf(picture, picture.querySelector("img"));
    button.addEventListener("click", () => openViewer(picture));
  }
}

// ---- two pictures behind a slider ------------------------------------------------------------------------------------

function setUpPairs() {
  for (const figure of document.querySelectorAll("figure.with-pair")) {
    const pair = figure.querySelector(".pair"), slider = figure.querySelector("input[type=range]");
    const place = () => pair.style.setProperty("--at", slider.value + "%");
    slider.addEventListener("input", place);
    figure.querySelector("button.ab").addEventListener("click", () => {
      slider.value = Number(slider.value) > 50 ? 0 : 100;
      place();
    });
    place();
  }
}

setUpLanguages();
setMathematics();
colourCode();
linkCommandsToLab();
setUpPictures();
setUpPairs();
