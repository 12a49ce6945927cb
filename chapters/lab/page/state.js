// All that a link must hold to show the same picture again: scene, method, parameters, camera, and how it is looked at.

// Words as `crevice render` takes them after its flags.
export const kCameraFlags = { eye: "--eye", target: "--target", fov_y: "--fov-y", near: "--near", far: "--far", ortho: "--ortho" };
const kChoices = {
  view: ["one", "pair", "split", "difference", "flip"],
  colours: ["own", "grey", "false"],
};

export function firstState() {
  return {
    scene: "columns",
    ao: "xjun",
    params: {},       // name: word; what is not in here has its default
    camera: {},       // flag: word; the same
    size: "640x360",
    show: "ao_blurred",
    against: "lit",
    view: "one",
    colours: "own",
    range: "",        // "low,high"; empty: from the values
    pixel: "",        // "x,y"; empty: none is asked about
    truth: "",        // "on": rays are cast
  };
}

// What is as it was at first stays out of the address.
export function hashOf(state) {
  const first = firstState();
  const words = new URLSearchParams();
  for (const key of ["scene", "ao", "size"]) words.set(key, state[key]);
  for (const [name, word] of Object.entries(state.params)) words.append("param", `${name}=${word}`);
  for (const [flag, word] of Object.entries(state.camera)) words.set(flag, word);
  for (const key of ["show", "against", "view", "colours", "range", "pixel", "truth"]) {
    if (state[key] !== first[key]) words.set(key, state[key]);
  }
  // Commas and equals signs may stand in an address as they are, and read better.
  return "#" + words.toString().replace(/%2C/g, ",").replace(/%3D/g, "=");
}

function setParam(state, word) {
  const equals = word.indexOf("=");
  if (equals > 0) state.params[word.slice(0, equals)] = word.slice(equals + 1);
}

// Empty where somebody has cut an address short.
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}

// The address of a picture; or, as the book's pages link here, a command of the terminal.
export function stateOfHash(hash) {
  const state = firstState();
  const command = decoded(hash.replace(/^#/, ""));
  if (/^crevice (render|probe) /.test(command)) return stateOfCommand(command);
  for (const [key, word] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (key === "param") {
      setParam(state, word);
    } else if (key in kCameraFlags) {
      state.camera[key] = word;
    } else if (key in kChoices) {
      if (kChoices[key].includes(word)) state[key] = word;
    } else if (typeof state[key] === "string") {
      state[key] = word;
    }
  }
  return state;
}

// "crevice render SCENE --flag word --flag=word ..." or "crevice probe SCENE X Y ...", which shows the raw AO; flags that mean
// nothing to the lab, such as --out, are passed over.
function stateOfCommand(command) {
  const state = { ...firstState(), ao: null, preset: null }, places = [];
  const [, what, ...words] = command.trim().split(/\s+/);
  if (what === "probe") state.show = "ao_raw";
  while (words.length > 0) {
    const [flag, joined] = words.shift().split(/=(.*)/s);
    if (!flag.startsWith("--")) {
      places.push(flag);
      continue;
    }
    const word = joined ?? words.shift() ?? "";
    const camera = Object.keys(kCameraFlags).find((name) => kCameraFlags[name] === flag);
    if (camera !== undefined) state.camera[camera] = word;
    else if (flag === "--param") setParam(state, word);
    else if (flag === "--ao-scale") state.params.ao_scale = word;
    else if (flag === "--only") [state.show] = word.split(",");
    else if (["--size", "--ao", "--preset"].includes(flag)) state[flag.slice(2)] = word;
  }
  if (places.length > 0) [state.scene] = places;
  if (what === "probe" && places.length === 3) state.pixel = `${places[1]},${places[2]}`;
  return state;
}

export const paramsOf = (preset) => Object.fromEntries(preset.params.map((word) => word.split("=")));

// A command's preset stands for its scene and its method, and has parameters for that method alone.
export function withPreset({ preset: name = null, ...state }, presets) {
  const preset = presets.find((one) => one.name === name);
  if (preset === undefined) return { ...state, ao: state.ao ?? firstState().ao };
  const ao = state.ao ?? preset.method;
  return { ...state, scene: preset.scene, ao, params: { ...(ao === preset.method ? paramsOf(preset) : {}), ...state.params } };
}

// What the module is asked for.
export function frameRequest(state, only, hashes) {
  const params = Object.entries(state.params).map(([name, word]) => `${name}=${word}`);
  return { ask: "frame", scene: state.scene, ao: state.ao, size: state.size, camera: state.camera, params, only, hashes };
}

const shellWord = (word) => (/^[\w.,=:/+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// The line that draws the same bits in a terminal.
export function commandOf(state) {
  const words = ["crevice", "render", state.scene, "--size", state.size, "--ao", state.ao];
  // With an equals sign: a number below 0 would be taken for a flag.
  for (const [flag, word] of Object.entries(state.camera)) words.push(`${kCameraFlags[flag]}=${word}`);
  for (const [name, word] of Object.entries(state.params)) words.push("--param", `${name}=${word}`);
  return words.map(shellWord).join(" ");
}
