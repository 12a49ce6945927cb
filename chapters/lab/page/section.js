// A cut through the depth buffer in the plane of the eye's ray through p and one sample: what the method knows of the scene
// there. To the right is away from the eye, up is towards the sample on the screen.
import { translated } from "./texts.js";

const kWidth = 560, kHeight = 300, kMargin = 14;
const kSteps = 240;  // of the cut
const kWider = 1.25; // than the farthest sample is from p

// The view-space position that the depth buffer shows at a point of the screen, pixels; null where it shows none.
function surfaceAt(view_depth, camera, x, y) {
  const column = Math.floor(x), row = Math.floor(y);
  if (column < 0 || row < 0 || column >= view_depth.width || row >= view_depth.height) return null;
  const z = view_depth.values[row * view_depth.width + column];
  if (!Number.isFinite(z)) return null;
  const [scale_x, scale_y] = camera.ray_scale, depth = camera.ortho === null ? z : 1;
  return [(2 * (column + 0.5) / view_depth.width - 1) * scale_x * depth, (1 - 2 * (row + 0.5) / view_depth.height) * scale_y * depth, z];
}

// Where a view-space position falls on the screen, pixels.
function screenOf(view_depth, camera, [x, y, z]) {
  const [scale_x, scale_y] = camera.ray_scale, depth = camera.ortho === null ? z : 1;
  return [(x / (scale_x * depth) + 1) / 2 * view_depth.width, (1 - y / (scale_y * depth)) / 2 * view_depth.height];
}

const apart = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

// Rays that go on for ever have no point q.
const isPlaced = ({ q_view }) => q_view.every(Number.isFinite);

// The one that takes most.
const darkestOf = (samples) => samples.reduce((darkest, sample) => (sample.contribution > darkest.contribution ? sample : darkest));

// The direction of the cut on the screen: unit, view space x and y.
function directionOf(p, sample) {
  const across = isPlaced(sample) ? [sample.q_view[0] - p[0], sample.q_view[1] - p[1]] : [0, 0];
  const distance = Math.hypot(...across);
  return distance > 0 ? across.map((value) => value / distance) : [1, 0];
}

// The cut as an SVG. `ao` as a probe tells it; `lit`: the number of the sample that gives the plane, null: the one
// that takes most does; `done`: so many samples are drawn.
export function sectionOf({ ao, camera, view_depth, lit, done }) {
  const { p_view: p, n_view: n, samples } = ao;
  const towards = directionOf(p, lit === null ? darkestOf(samples) : samples[lit]);
  const half = kWider * Math.max(...samples.filter(isPlaced).map(({ q_view }) => apart(q_view, p)), 1e-6);
  const scale = Math.min(kWidth, kHeight) / 2 / half - kMargin / half;
  // In the plane, from p on: away from the eye, and towards the sample.
  const at = ([x, y, z]) => [kWidth / 2 + scale * (z - p[2]), kHeight / 2 - scale * ((x - p[0]) * towards[0] + (y - p[1]) * towards[1])];
  const place = (point) => at(point).map((value) => value.toFixed(1)).join(" ");
  const parts = [`<path class="cut" d="${cutPath(view_depth, camera, p, towards, half * kWidth / kHeight, place)}"/>`];
  const [nx, ny, nz] = n;
  const tip = [p[0] + half / 3 * nx, p[1] + half / 3 * ny, p[2] + half / 3 * nz];
  parts.push(`<path class="normal" d="M${place(p)}L${place(tip)}"/>`);
  samples.slice(0, done).forEach((sample, number) => {
    if (!isPlaced(sample)) return;
    const kind = sample.contribution > 0 ? "occludes" : "open";
    const bright = number === lit ? " lit" : "";
    if (number === lit && sample.r_view.every(Number.isFinite)) {
      parts.push(`<path class="ray" d="M${place(sample.q_view)}L${place(sample.r_view)}"/>`);
      parts.push(`<rect class="r" x="${at(sample.r_view)[0] - 4}" y="${at(sample.r_view)[1] - 4}" width="8" height="8"/>`);
    }
    const [x, y] = at(sample.q_view);
    parts.push(`<circle class="${kind}${bright}" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${number === lit ? 6 : 3.5}"/>`);
  });
  const [px, py] = at(p);
  parts.push(`<circle class="p" cx="${px}" cy="${py}" r="5"/><text x="${px + 8}" y="${py + 14}">p</text>`);
  return `<svg viewBox="0 0 ${kWidth} ${kHeight}" class="section" role="img" aria-label="${translated("cut")}">${parts.join("")}</svg>`;
}

// What the depth buffer shows from `half` scene units on one side of p to as many on the other, broken where it shows nothing.
function cutPath(view_depth, camera, p, towards, half, place) {
  let path = "", broken = true;
  for (let step = -kSteps; step <= kSteps; ++step) {
    const along = half * step / kSteps;
    const [x, y] = screenOf(view_depth, camera, [p[0] + along * towards[0], p[1] + along * towards[1], p[2]]);
    const surface = surfaceAt(view_depth, camera, x, y);
    if (surface !== null) path += `${broken ? "M" : "L"}${place(surface)}`;
    broken = surface === null;
  }
  return path;
}
