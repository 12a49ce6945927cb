// Fields for every parameter of a method, from the table's own ranges.
import { tableText } from "./table_texts.js";
import { translated } from "./texts.js";

// Sliders of open ranges end at so many times the default.
const kReach = 4;
const kParts = ["method", "denoiser", "buffers", "light"];

// The ends of "[0, 1]", "(0, 1e15]" or "1..64"; null where there are none.
function endsOf(range) {
  const numbers = /^[[(]([^,]+), ([^\])]+)[\])]$/.exec(range) ?? /^(-?[\d.e]+)\.\.(-?[\d.e]+)$/.exec(range);
  return numbers === null ? null : [Number(numbers[1]), Number(numbers[2])];
}

function sliderEnds(parameter, value) {
  const [low, high] = endsOf(parameter.range) ?? [-Infinity, Infinity];
  const reach = kReach * Math.max(Math.abs(value), 1e-6);
  const near = Number.isFinite(low) && Math.abs(low) <= Math.max(reach, 64) ? low : -reach;
  const far = Number.isFinite(high) && high <= Math.max(reach, 64) ? high : Math.max(reach, near + 1);
  return [near, far];
}

// The words of a parameter that has few: choices, and ranges such as "0.5|1".
function wordsOf(parameter) {
  return parameter.range.includes("|") && !/^[[(]/.test(parameter.range) ? parameter.range.split("|") : null;
}

function element(tag, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(tag), attributes);
  made.append(...children);
  return made;
}

// The field of one parameter; `changed(word)` is told what it is set to.
function fieldOf(parameter, id, changed) {
  const words = wordsOf(parameter);
  if (parameter.kind === "yes_no") {
    const box = element("input", { type: "checkbox", id });
    box.addEventListener("change", () => changed(String(box.checked)));
    return { inputs: [box], set: (word) => { box.checked = word === "true"; } };
  }
  if (words !== null) {
    const select = element("select", { id }, ...words.map((word) => new Option(word)));
    select.addEventListener("change", () => changed(select.value));
    return { inputs: [select], set: (word) => { select.value = word; } };
  }
  const number = element("input", { type: "text", inputMode: "decimal", id, size: 9 });
  const slider = element("input", { type: "range", tabIndex: -1, ariaHidden: "true" });
  const [low, high] = sliderEnds(parameter, Number(parameter.default));
  Object.assign(slider, { min: low, max: high, step: parameter.kind === "whole" ? 1 : (high - low) / 400 });
  slider.addEventListener("input", () => {
    const value = Number(slider.value);
    number.value = parameter.kind === "whole" ? String(value) : String(Number(value.toPrecision(4)));
    changed(number.value);
  });
  number.addEventListener("change", () => changed(number.value));
  const set = (word) => {
    number.value = word;
    const value = Number(word);
    // A length of a scene in other units.
    if (value > Number(slider.max) || value < Number(slider.min)) [slider.min, slider.max] = sliderEnds(parameter, value);
    slider.value = value;
  };
  return { inputs: [slider, number], set };
}

export class ParameterControls {
  #place;
  #changed;
  #fields = new Map();

  // `changed(name, word)`; a word of null means: as the method has it.
  constructor(place, changed) {
    this.#place = place;
    this.#changed = changed;
  }

  // Fields for the parameters of a method, see chapters/lab/catalogue.h.
  build(parameters) {
    this.#fields.clear();
    const groups = kParts.map((part) => {
      const rows = parameters.filter((parameter) => parameter.part === part).map((parameter) => this.#row(parameter));
      const title = element("summary", {}, translated(`part_${part}`));
      title.dataset.text = `part_${part}`;
      return rows.length === 0 ? "" : element("details", { open: part === "method" || part === "denoiser" }, title, ...rows);
    });
    this.#place.replaceChildren(...groups);
  }

  #row(parameter) {
    const id = `param_${parameter.name}`;
    const field = fieldOf(parameter, id, (word) => this.#changed(parameter.name, word));
    const back = element("button", { type: "button", className: "back", textContent: "↺", hidden: true });
    back.setAttribute("aria-label", `${parameter.name} = ${parameter.default}`);
    back.addEventListener("click", () => this.#changed(parameter.name, null));
    const unit = parameter.unit === "-" ? "" : ` ${parameter.unit}`;
    const label = element("label", { htmlFor: id, textContent: parameter.name });
    const about = element("p", { className: "about", textContent: `${tableText(parameter.effect)} (${parameter.range}${unit})`, id: `about_${id}` });
    for (const input of field.inputs) input.setAttribute("aria-describedby", about.id);
    this.#fields.set(parameter.name, { ...field, back });
    return element("div", { className: "parameter" }, label, element("span", { className: "field" }, ...field.inputs, back), about);
  }

  // The values of a frame, by name; `set`: those that are not the method's own.
  show(values, set) {
    for (const [name, { inputs, set: setField, back }] of this.#fields) {
      back.hidden = !(name in set);
      if (!inputs.includes(document.activeElement)) setField(set[name] ?? values[name]);
    }
  }
}
