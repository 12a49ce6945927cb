// The page: its fields, its picture, and what is told of it, all following one state.
import { CameraControl, CameraFields, followPointers } from "./camera.js";
import { shortest } from "./colour.js";
import { ParameterControls } from "./controls.js";
import { takeFiles } from "./dropped_files.js";
import { Engine, missingFeatures } from "./engine.js";
import { Frames } from "./frames.js";
import { PixelPanel } from "./pixel_panel.js";
import { commandOf, hashOf, paramsOf, stateOfHash, withPreset } from "./state.js";
import { showBuffers, showLines, showPasses } from "./tables.js";
import { tableText } from "./table_texts.js";
import { firstLanguage, setLanguage, translated } from "./texts.js";
import { kTruthBuffers, TruthPanel } from "./truth_panel.js";
import { drawHistogram, rangeOfWord, Viewer } from "./viewer.js";

const byId = (id) => document.getElementById(id);
const state = stateOfHash(location.hash);
const viewer = new Viewer(byId("stage"));
const pixel_panel = new PixelPanel(byId("pixel_answer"), byId("overlay"));
let catalogue = null, engine = null, frames = null, controls = null, camera_fields = null, truth = null;
let answered = null;  // {frame, pixel} that the panel tells of
const camera = new CameraControl(state, () => changed());

const methodRow = () => catalogue.methods.find((method) => method.name === state.ao) ?? catalogue.methods[0];
const buffersOfMethod = () => [...catalogue.buffer_names, ...(methodRow().bent_normals ? ["bent_normal"] : [])];

// ---- what follows from the state -----------------------------------------------------------------------------------

// Everything that a change of the state brings about.
function changed() {
  history.replaceState(null, "", hashOf(state));
  byId("command").textContent = commandOf(state);
  frames.ask();
}

function showFields() {
  for (const id of ["scene", "size", "ao", "show", "against", "view", "colours"]) byId(id).value = state[id];
  [byId("range_low").value, byId("range_high").value] = state.range.split(",").concat("");
  byId("preset").value = catalogue.presets.find(isChosen)?.name ?? "";
  [byId("pixel_x").value, byId("pixel_y").value] = state.pixel.split(",").concat("", "");
  byId("truth").checked = state.truth === "on";
  const method = methodRow();
  byId("method_about").textContent = `${tableText(method.title)}. ${method.source}`;
}

function isChosen(preset) {
  return preset.scene === state.scene && preset.method === state.ao &&
    JSON.stringify(paramsOf(preset)) === JSON.stringify(state.params);
}

function choose(next) {
  Object.assign(state, next);
  if ("ao" in next) controls.build(methodRow().parameters);
  truth.on = state.truth === "on";
  showFields();
  changed();
}

function showPicture() {
  const shows = viewer.show(state, frames.buffers);
  say(shows ? "" : translated(state.view === "difference" ? "no_difference" : "nothing_to_show"));
  const shown = viewer.shown;
  if (shown === undefined) return;
  const [low, high] = drawHistogram(byId("histogram"), shown.buffer, rangeOfWord(state.range));
  byId("histogram_low").textContent = shortest(Math.fround(low));
  byId("histogram_high").textContent = shortest(Math.fround(high));
  byId("histogram_name").textContent = shown.name;
}

function showFrame() {
  const { reply, settled } = frames;
  refuse("");
  camera.see(reply.camera, reply.scene.from_obj);
  showPicture();
  showPasses(byId("passes"), reply.passes, reply.unchanged);
  byId("rate").textContent = `${frames.frame_ms.toFixed(1)} ms` + (frames.rate > 0 ? `, ${frames.rate.toFixed(0)}/s` : "");
  if (settled) showRest(reply);
  const root = document.documentElement.dataset;
  root.settled = String(settled);
  root.firstPictureMs ??= performance.now().toFixed(0);
}

// What is told of a frame as soon as nothing moves.
function showRest(reply) {
  camera_fields.show(reply.camera);
  controls.show(reply.parameters, state.params);
  showBuffers(byId("buffers"), reply.buffers);
  showLines(byId("warnings"), reply.warnings);
  askPixel();
  truth.goOn();
}

// What the probe tells of the pixel, as soon as its frame stays.
async function askPixel() {
  const [x, y] = state.pixel.split(",").map(Number), of_frame = frames.reply;
  if (answered?.frame === of_frame && answered.pixel === state.pixel) return;
  answered = null;
  delete document.documentElement.dataset.probed;
  if (state.pixel === "") return pixel_panel.clear();
  const { reply } = await engine.ask({ ask: "probe", x, y });
  if (frames.reply !== of_frame || state.pixel !== `${x},${y}`) return;
  if (reply.error !== undefined) return refuse(reply.error);
  const [width, height] = of_frame.size;
  pixel_panel.show(reply, { size: { width, height }, camera: of_frame.camera, view_depth: frames.buffers.view_depth });
  answered = { frame: of_frame, pixel: state.pixel };
  document.documentElement.dataset.probed = state.pixel;
}

const say = (text) => { byId("said").textContent = text; };

function refuse(message) {
  byId("refused").textContent = message;
  byId("refused").hidden = message === "";
  if (message === "") return;
  say("");
  document.documentElement.dataset.settled = "refused";
}

// ---- what changes the state -------------------------------------------------------------------------------------------

function setUpFields() {
  const fill = (id, rows) => byId(id).replaceChildren(...rows.map(({ name, title }) => Object.assign(new Option(name), { title })));
  fill("scene", catalogue.scenes.map(({ name, purpose }) => ({ name, title: purpose })));
  fill("ao", catalogue.methods);
  byId("preset").replaceChildren(Object.assign(new Option("", ""), { textContent: "–" }),
    ...catalogue.presets.map(({ name, title }) => Object.assign(new Option(name), { title })));
  const buffers = [...catalogue.buffer_names, "bent_normal", ...kTruthBuffers].map((name) => ({ name, title: name }));
  fill("show", buffers);
  fill("against", buffers);
  byId("scene").addEventListener("change", (event) => choose({ scene: event.target.value, camera: {} }));
  byId("ao").addEventListener("change", (event) => choose({ ao: event.target.value, params: {} }));
  byId("preset").addEventListener("change", (event) => {
    const preset = catalogue.presets.find(({ name }) => name === event.target.value);
    if (preset !== undefined) choose({ scene: preset.scene, ao: preset.method, params: paramsOf(preset), camera: {} });
  });
  for (const id of ["size", "show", "against", "view", "colours"])
    byId(id).addEventListener("change", (event) => choose({ [id]: event.target.value }));
  for (const id of ["range_low", "range_high"])
    byId(id).addEventListener("change", () => choose({ range: `${byId("range_low").value},${byId("range_high").value}` }));
  byId("range_auto").addEventListener("click", () => choose({ range: "" }));
  byId("pixel_ask").addEventListener("click", () => choose({ pixel: `${byId("pixel_x").value},${byId("pixel_y").value}` }));
  byId("pixel_clear").addEventListener("click", () => choose({ pixel: "" }));
  byId("truth").addEventListener("change", (event) => choose({ truth: event.target.checked ? "on" : "" }));
  byId("all_defaults").addEventListener("click", () => choose({ params: {} }));
  camera_fields = new CameraFields(byId("camera_fields"), state, changed);
  controls = new ParameterControls(byId("parameters"), (name, word) => {
    if (word === null) delete state.params[name];
    else state.params[name] = word;
    changed();
  });
  controls.build(methodRow().parameters);
}

function setUpStage() {
  const stage = byId("stage");
  const flip = () => {
    viewer.flipped = !viewer.flipped;
    showPicture();
  };
  followPointers(stage, camera, (event) => {
    const [width, height] = frames.reply.size;
    const pixel = viewer.pixelAt(event, { width, height });
    if (pixel !== null) choose({ pixel: `${pixel.x},${pixel.y}` });
  });
  stage.addEventListener("pointermove", (event) => { byId("value").textContent = viewer.valuesAt(event); });
  stage.addEventListener("pointerleave", () => { byId("value").textContent = ""; });
  stage.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === " " && state.view === "flip") flip();
    else if (!camera.key(event.key)) return;
    event.preventDefault();
  });
  byId("flip").addEventListener("click", flip);
  byId("edge").addEventListener("input", (event) => {
    viewer.edge_percent = Number(event.target.value);
    stage.style.setProperty("--edge", `${viewer.edge_percent}%`);
  });
  byId("camera_mode").addEventListener("change", (event) => { camera.mode = event.target.value; });
  byId("camera_reset").addEventListener("click", () => camera.reset());
}

function setUpCopies() {
  const copy = async (text) => {
    try {
      await navigator.clipboard.writeText(text);
      say(translated("copied"));
    } catch {
      // Some browsers keep the clipboard from pages on the disk: there it can be copied by hand.
      say(text);
    }
  };
  byId("copy_link").addEventListener("click", () => copy(location.href));
  byId("copy_command").addEventListener("click", () => copy(commandOf(state)));
  // A link that is followed within the page.
  window.addEventListener("hashchange", () => choose(withPreset(stateOfHash(location.hash), catalogue.presets)));
}

// Texts that stand on the page change at once; the others are made again.
function speak(language) {
  setLanguage(language);
  if (!frames?.settled) return;
  answered = null;
  controls.build(methodRow().parameters);
  showFields();
  showFrame();
}

// The scenes of the last drop stand among the built-in ones, under the names of their OBJ files.
function setUpFiles() {
  takeFiles(byId("files"), async (files, objs) => {
    if (objs.length === 0) return refuse(translated("no_obj"));
    await engine.keep(files);
    await engine.ask({ ask: "forget" });
    frames.forget();
    for (const option of byId("scene").querySelectorAll(".dropped")) option.remove();
    byId("scene").append(...objs.map((name) => Object.assign(new Option(name), { className: "dropped" })));
    choose({ scene: objs[0], camera: {}, pixel: "" });
  });
}

async function start() {
  setLanguage(firstLanguage(new URLSearchParams(location.search).get("lang")));
  for (const button of document.querySelectorAll("[data-set-lang]"))
    button.addEventListener("click", () => speak(button.dataset.setLang));
  const missing = missingFeatures();
  if (missing.length > 0) {
    byId("lacks").textContent = `${translated("needs")} ${missing.map(translated).join("; ")}`;
    byId("lacks").hidden = false;
    return;
  }
  say(translated("starting"));
  engine = new Engine(byId("worker_text").textContent);
  await engine.start(byId("module_bytes").textContent);
  catalogue = (await engine.ask({ ask: "catalogue" })).reply;
  Object.assign(state, withPreset(state, catalogue.presets));
  frames = new Frames(engine, state, { all: buffersOfMethod, drawn: showFrame, slow: () => say(translated("drawing")), refused: refuse });
  truth = new TruthPanel(engine, frames, byId("truth_told"), showPicture);
  truth.on = state.truth === "on";
  setUpFields();
  setUpStage();
  setUpCopies();
  setUpFiles();
  showFields();
  changed();
}

start().catch((error) => refuse(String(error.message ?? error)));
