// What is drawn over the picture: the pixel that is asked about, its samples, the taps of its blur.

const kDot_px = 4, kLitDot_px = 8;  // of the screen

// `size` of the picture; `pixel`: {x, y} or null; `marks`: [{x, y: pixels of the picture, kind: occludes|open, lit}].
export function drawOverlay(svg, size, pixel, marks) {
  svg.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
  const screen_px = size.width / Math.max(svg.clientWidth, 1);
  const parts = marks.map(({ x, y, kind, lit }) =>
    `<circle class="${kind}${lit ? " lit" : ""}" cx="${x}" cy="${y}" r="${(lit ? kLitDot_px : kDot_px) * screen_px}" stroke-width="${screen_px}"/>`);
  if (pixel !== null) {
    const arm = 10 * screen_px, x = pixel.x + 0.5, y = pixel.y + 0.5;
    parts.push(`<path class="asked" stroke-width="${2 * screen_px}" d="M${x - arm} ${y}h${arm / 2}M${x + arm / 2} ${y}h${arm / 2}M${x} ${y - arm}v${arm / 2}M${x} ${y + arm / 2}v${arm / 2}"/>`);
    parts.push(`<rect class="asked" stroke-width="${screen_px}" x="${pixel.x}" y="${pixel.y}" width="1" height="1"/>`);
  }
  svg.innerHTML = parts.join("");
}
