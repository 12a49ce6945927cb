// The camera under mouse, fingers and keys. It lives in the scene's own coordinates, as --eye and --target take them:
// left-handed for the built-in scenes, right-handed for an OBJ.
import { kCameraFlags } from "./state.js";
import { add, cross, length, subtract, times, unit } from "./vector.js";

const kSteepest_rad = 1.55;      // short of straight up and down, where no direction would be sideways
const kTurn_rad_per_px = 0.006;
const kKeyTurn_px = 24;
const kKeyMove = 0.06;           // of the distance between eye and target
const kKeyZoom = 1.12;
// Seven digits: an address stays short, and a step of them is below a thousandth of a pixel.
const kDigits = 7;

const pointWord = (p) => p.map((value) => String(Number(value.toPrecision(kDigits)))).join(",");

export class CameraControl {
  mode = "orbit";  // or fly: the eye stays, and looks around
  #state;
  #seen = null;    // the camera of the last frame
  #handed = 1;
  #changed;

  constructor(state, changed) {
    this.#state = state;
    this.#changed = changed;
  }

  // As the module tells it with a frame.
  see(camera, from_obj) {
    this.#seen = camera;
    this.#handed = from_obj ? -1 : 1;
  }

  reset() {
    this.#state.camera = {};
    this.#seen = null;
    this.#changed();
  }

  #point(name) {
    const word = this.#state.camera[name];
    return word === undefined ? this.#seen[name] : word.split(",").map(Number);
  }

  // Where the camera stands, and its directions: forward, right and up, unit.
  #frame() {
    const eye = this.#point("eye"), target = this.#point("target");
    const forward = unit(subtract(target, eye));
    const right = times(this.#handed, unit(cross(this.#seen.up, forward)));
    const up = times(this.#handed, cross(forward, right));
    return { eye, target, forward, right, up, distance: length(subtract(target, eye)) };
  }

  #place(eye, target) {
    this.#state.camera.eye = pointWord(eye);
    this.#state.camera.target = pointWord(target);
    this.#changed();
  }

  // By so many pixels to the right and down: round the target, or of the eye where it stands.
  turn(dx, dy) {
    if (this.#seen === null) return;
    const { eye, target, forward, right, distance } = this.#frame();
    const orbits = this.mode === "orbit";
    const sideways = (orbits ? 1 : -1) * kTurn_rad_per_px * dx, upward = (orbits ? 1 : -1) * kTurn_rad_per_px * dy;
    const horizontal = unit(subtract(forward, [0, forward[1], 0]));
    const turned = add(times(Math.cos(sideways), horizontal), times(Math.sin(sideways), right));
    const slope = Math.asin(forward[1]) - upward;
    const steep = Math.min(Math.max(slope, -kSteepest_rad), kSteepest_rad);
    const direction = add(times(Math.cos(steep), turned), [0, Math.sin(steep), 0]);
    if (orbits) this.#place(subtract(target, times(distance, direction)), target);
    else this.#place(eye, add(eye, times(distance, direction)));
  }

  // Eye and target together, in parts of the distance between them.
  move(ahead, to_right, upward) {
    if (this.#seen === null) return;
    const { eye, target, forward, right, up, distance } = this.#frame();
    const by = times(distance, add(times(ahead, forward), add(times(to_right, right), times(upward, up))));
    this.#place(add(eye, by), add(target, by));
  }

  // Nearer to the target, or a lower orthographic picture.
  zoom(factor) {
    if (this.#seen === null) return;
    if (this.#seen.ortho !== null) {
      const height = Number(this.#state.camera.ortho ?? this.#seen.ortho);
      this.#state.camera.ortho = String(Number((height / factor).toPrecision(kDigits)));
      this.#changed();
      return;
    }
    const { target, forward, distance } = this.#frame();
    this.#place(subtract(target, times(distance / factor, forward)), target);
  }

  // True where the key meant something.
  key(name) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const moves = { w: [1, 0, 0], s: [-1, 0, 0], a: [0, -1, 0], d: [0, 1, 0], q: [0, 0, -1], e: [0, 0, 1] };
    // A drag takes hold of what is seen; an arrow of somebody who looks around says where to.
    const along = this.mode === "orbit" ? kKeyTurn_px : -kKeyTurn_px;
    if (name in turns) this.turn(...turns[name].map((part) => part * along));
    else if (name in moves) this.move(...moves[name].map((part) => part * kKeyMove));
    else if (name === "+" || name === "=") this.zoom(kKeyZoom);
    else if (name === "-") this.zoom(1 / kKeyZoom);
    else if (name === "0") this.reset();
    else return false;
    return true;
  }
}

// Fields for what the flags of `crevice render` set; an empty one means: as the scene has it.
export class CameraFields {
  #inputs = new Map();
  #state;

  constructor(place, state, changed) {
    this.#state = state;
    for (const flag of Object.keys(kCameraFlags)) {
      const input = Object.assign(document.createElement("input"), { id: `camera_${flag}`, size: 12, spellcheck: false });
      input.addEventListener("change", () => {
        if (input.value.trim() === "") delete state.camera[flag];
        else state.camera[flag] = input.value.replaceAll(" ", "");
        changed();
      });
      const label = document.createElement("label");
      label.append(flag.replace("_", " "), " ", input);
      place.append(label);
      this.#inputs.set(flag, input);
    }
  }

  // As the module tells the camera with a frame.
  show(camera) {
    for (const [flag, input] of this.#inputs) {
      const seen = camera[flag];
      input.placeholder = seen === null ? "" : Array.isArray(seen) ? pointWord(seen) : String(Number(seen.toPrecision(kDigits)));
      if (input !== document.activeElement) input.value = this.#state.camera[flag] ?? "";
    }
  }
}

// Mouse and fingers on `stage`: one turns, two move and zoom; a tap or a click calls `clicked(event)`.
export function followPointers(stage, camera, clicked) {
  const kSlack_px = 4;
  const down = new Map();
  let travelled = 0;
  const spread = () => {
    const [a, b] = [...down.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  stage.addEventListener("pointerdown", (event) => {
    if (down.size === 0) travelled = 0;
    stage.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  stage.addEventListener("pointermove", (event) => {
    const last = down.get(event.pointerId);
    if (last === undefined) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    if (travelled <= kSlack_px) return;
    const before = down.size === 2 ? spread() : 0;
    last.x = event.clientX;
    last.y = event.clientY;
    if (down.size === 2) {
      camera.move(0, -dx / stage.clientHeight, dy / stage.clientHeight);
      if (before > 0) camera.zoom(spread() / before);
    } else if (event.buttons === 2 || event.shiftKey) {
      camera.move(0, -dx / stage.clientHeight, dy / stage.clientHeight);
    } else {
      camera.turn(dx, dy);
    }
  });
  const up = (event) => {
    const was_down = down.delete(event.pointerId);
    if (was_down && event.type === "pointerup" && down.size === 0 && travelled <= kSlack_px) clicked(event);
  };
  stage.addEventListener("pointerup", up);
  stage.addEventListener("pointercancel", up);
  stage.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY / 500));
  }, { passive: false });
}
