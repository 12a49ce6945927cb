// Tables: of buffers with their hashes, of the time of each pass, and of whatever lists of numbers a probe tells.
import { shortest } from "./colour.js";
import { probeText } from "./probe_texts.js";
import { translated } from "./texts.js";

const kCellDigits = 6;

const rounded = (value) => (value === null ? "inf" : String(Number(value.toPrecision(kCellDigits))));

// A number that came as a float has its fewest digits, null stands for what is not finite, and words are in the page's language.
export function cellText(value) {
  if (value === null) return "inf";
  if (Array.isArray(value)) return value.map(cellText).join(", ");
  if (typeof value === "object") return Object.entries(value).map(([name, part]) => `${name} ${cellText(part)}`).join("; ");
  if (typeof value === "number" && !Number.isInteger(value)) return shortest(Math.fround(value));
  return probeText(String(value));
}

function cellOf(tag, text) {
  return Object.assign(document.createElement(tag), { textContent: text });
}

function rowOf([head, ...cells]) {
  const row = document.createElement("tr");
  row.append(Object.assign(cellOf("th", head), { scope: "row" }), ...cells.map((text) => cellOf("td", text)));
  return row;
}

// `buffers` as buffer_json() tells them.
export function showBuffers(body, buffers) {
  body.replaceChildren(...Object.entries(buffers).map(([name, { shape, min, mean, max, hash }]) => {
    const row = rowOf([name, `${shape[1]}x${shape[0]}`, rounded(min), rounded(mean), rounded(max), hash]);
    row.dataset.buffer = name;
    row.lastChild.className = "hash";
    return row;
  }));
}

// Those that ran, with their times, and those whose finding is that of the frame before.
export function showPasses(body, passes, unchanged) {
  const timed = passes.map(({ name, wall_ms }) => rowOf([name, `${wall_ms.toFixed(2)} ms`]));
  body.replaceChildren(...timed, ...unchanged.map((name) => rowOf([name, translated("unchanged")])));
}

export function showLines(list, lines) {
  list.replaceChildren(...lines.map((text) => cellOf("li", text)));
  list.hidden = lines.length === 0;
}

// Objects as rows, their members as columns; numbers that only some of them have stand empty in the others. Members in
// `nested` are objects whose own members are columns.
export function tableOf(objects, nested = "numbers") {
  const flat = objects.map(({ [nested]: more = {}, ...members }) => ({ ...members, ...more }));
  const columns = [...new Set(flat.flatMap(Object.keys))];
  const head = document.createElement("tr");
  head.append(...columns.map((name) => Object.assign(cellOf("th", name.replaceAll("_", " ")), { scope: "col" })));
  const table = document.createElement("table"), body = document.createElement("tbody");
  table.createTHead().append(head);
  body.append(...flat.map((members) => rowOf(columns.map((name) => (name in members ? cellText(members[name]) : "")))));
  table.append(body);
  return table;
}

// The members of an object that are no lists of objects.
export function membersOf(object) {
  const list = Object.assign(document.createElement("ul"), { className: "members" });
  const plain = Object.entries(object).filter(([, value]) => !isList(value));
  list.append(...plain.map(([name, value]) => cellOf("li", `${name.replaceAll("_", " ")}: ${cellText(value)}`)));
  return list;
}

export const isList = (value) => Array.isArray(value) && typeof value[0] === "object" && !Array.isArray(value[0]) && value[0] !== null;
