// From floats to colours. A buffer is {width, height, components, values}: planes of values, one after the other.
// The mappings that are a buffer's own are those of the pictures that `crevice render` writes (chapters/notebook/picture.h).

const kDifferenceScale = 0.25;  // that all differences of AO share
const kFarthestGrey = 0.1;      // of view depth, so that the background's black is no depth
const kBlue = [0.02, 0.3, 0.75], kRed = [0.8, 0.05, 0.1];
// The colours of viridis (van der Walt and Smith 2015), every eighth.
const kViridis = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];

const clamped = (value) => (value > 0 ? (value < 1 ? value : 1) : 0);

// As a display shows linear light, at so many steps.
const kCurveSteps = 4096;
const srgb_curve = Float32Array.from({ length: kCurveSteps + 1 }, (_, step) => {
  const linear = step / kCurveSteps;
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
});

// One number a pixel: the mean of its components.
export function scalarAt(buffer, pixel) {
  const plane = buffer.width * buffer.height;
  let sum = 0;
  for (let c = 0; c < buffer.components; ++c) sum += buffer.values[c * plane + pixel];
  return sum / buffer.components;
}

// The smallest and the largest finite value; [0, 1] where they are one.
export function rangeOf(buffer) {
  let low = Infinity, high = -Infinity;
  for (let pixel = 0; pixel < buffer.width * buffer.height; ++pixel) {
    const value = scalarAt(buffer, pixel);
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low < high ? [low, high] : [0, 1];
}

// Colours are three numbers in [0,1], written into `out`: a new list for each pixel would take most of the time.
function grey(value, out) {
  out[0] = out[1] = out[2] = value;
}

function falseColour(share, out) {
  const at = clamped(share) * (kViridis.length - 1), below = Math.min(Math.floor(at), kViridis.length - 2);
  const from = kViridis[below], to = kViridis[below + 1];
  for (let c = 0; c < 3; ++c) out[c] = (from[c] + (at - below) * (to[c] - from[c])) / 255;
}

function diverging(value, out) {
  const strength = clamped(Math.abs(value) / kDifferenceScale), end = value < 0 ? kBlue : kRed;
  for (let c = 0; c < 3; ++c) out[c] = 1 + strength * (end[c] - 1);
}

// The component farthest from 0.
function farthest(buffer, pixel) {
  const plane = buffer.width * buffer.height;
  let value = 0;
  for (let c = 0; c < buffer.components; ++c) {
    const next = buffer.values[c * plane + pixel];
    if (Math.abs(next) > Math.abs(value)) value = next;
  }
  return value;
}

// (pixel, out): the colours that a buffer has in the program's pictures.
function ownColours(name, buffer) {
  const plane = buffer.width * buffer.height, { values } = buffer;
  switch (name) {
    case "normal":
    case "bent_normal":
      return (i, out) => {
        const background = values[i] === 0 && values[plane + i] === 0 && values[2 * plane + i] === 0;
        for (let c = 0; c < 3; ++c) out[c] = background ? 0 : values[c * plane + i] / 2 + 0.5;
      };
    case "lit":
      return (i, out) => {
        for (let c = 0; c < 3; ++c) out[c] = srgb_curve[Math.round(clamped(values[c * plane + i]) * kCurveSteps)];
      };
    case "view_depth": {
      const [low, high] = rangeOf(buffer);
      return (i, out) => grey(values[i] === Infinity ? 0 : 1 - (1 - kFarthestGrey) * (values[i] - low) / (high - low), out);
    }
    case "ndc_depth": {
      const [low] = rangeOf(buffer);
      return (i, out) => grey((1 - values[i]) / (1 - low), out);
    }
    case "truth_error": {
      const [, high] = rangeOf(buffer);
      return (i, out) => grey(values[i] / high, out);
    }
    case "ao_error":
    case "difference":
      return (i, out) => diverging(farthest(buffer, i), out);
    default:
      return (i, out) => grey(values[i], out);
  }
}

// (pixel, out): what one number of a pixel is within a range, as grey or as false colour.
function rangedColours(buffer, colours, range) {
  const [low, high] = range ?? rangeOf(buffer), paint = colours === "grey" ? grey : falseColour;
  return (i, out) => paint((scalarAt(buffer, i) - low) / (high - low), out);
}

// `colours`: own, grey or false; `range`: [low, high] of the last two, null: of the values. NaN is magenta.
export function imageOf(name, buffer, colours, range) {
  const image = new ImageData(buffer.width, buffer.height), { data } = image;
  const colourAt = colours === "own" ? ownColours(name, buffer) : rangedColours(buffer, colours, range);
  const colour = [0, 0, 0];
  for (let i = 0; i < buffer.width * buffer.height; ++i) {
    if (Number.isNaN(scalarAt(buffer, i))) colour.splice(0, 3, 1, 0, 1);
    else colourAt(i, colour);
    // A clamped array rounds to the nearest byte by itself.
    for (let c = 0; c < 3; ++c) data[4 * i + c] = 255 * colour[c];
    data[4 * i + 3] = 255;
  }
  return image;
}

// a - b in float at the larger of both sizes, the other one read at its nearest pixels; 0 where both are the same infinity.
// Null where one has more components than the other.
export function differenceOf(a, b) {
  if (a.components !== b.components) return null;
  const width = Math.max(a.width, b.width), height = Math.max(a.height, b.height);
  const values = new Float32Array(width * height * a.components);
  const at = (buffer, c, x, y) => {
    const column = Math.floor(x * buffer.width / width), row = Math.floor(y * buffer.height / height);
    return buffer.values[(c * buffer.height + row) * buffer.width + column];
  };
  let i = 0;
  for (let c = 0; c < a.components; ++c) {
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, ++i) {
        const of_a = at(a, c, x, y), of_b = at(b, c, x, y);
        values[i] = of_a === of_b ? 0 : of_a - of_b;
      }
    }
  }
  return { width, height, components: a.components, values };
}

// The fewest digits that read back as the same float.
export function shortest(value) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf");
  for (let digits = 6; digits < 10; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === value) return String(Number(text));
  }
  return String(value);
}
