// What a point of a report's plot is: a card that the page's script shows beside it, filled from the tables that stand in the page.
"use strict";

// The row of a view's table of all settings that a point names, as {column: text}.
function figuresOf(point) {
  const dash = point.lastIndexOf("-");
  const table = document.querySelector(`#${point.slice(0, dash)}-points table`);
  const row = table?.tBodies[0].rows[Number(point.slice(dash + 1))];
  if (row === undefined) return undefined;
  return Object.fromEntries([...table.tHead.rows[0].cells].map((head, i) => [head.textContent, row.cells[i].textContent]));
}

const card = document.createElement("aside");
card.id = "point";
card.hidden = true;
card.setAttribute("aria-live", "polite");

function paragraph(text, className = "") {
  const element = document.createElement("p");
  element.textContent = text;
  element.className = className;
  return element;
}

function fillCard(figures) {
  card.replaceChildren();
  if (figures.picture !== "") {
    const image = document.createElement("img");
    image.src = figures.picture;
    image.alt = `ambient occlusion of ${figures.method}, ${figures.setting}`;
    image.addEventListener("error", () => image.replaceWith(paragraph(`${figures.picture} is not beside this page`, "told")));
    card.append(image);
  }
  const title = document.createElement("strong");
  title.textContent = `${figures.method}, ${figures.setting}`;
  card.append(title);
  if (figures.RMSE !== "")
    card.append(paragraph(`RMSE ${figures.RMSE} ± ${figures["RMSE ±"]} · FLIP ${figures.FLIP} · bias ${figures.bias} · p99 ${figures.p99}`));
  if (figures.ms !== "")
    card.append(paragraph(`${figures.ms} ms, ${figures["ms low"]} to ${figures["ms high"]} · threads: ${figures.threads}`));
  if (figures.command !== "") {
    const code = document.createElement("code");
    code.textContent = figures.command;
    card.append(code, paragraph("Click the point, or press Enter, to copy the command.", "told"));
  }
  card.hidden = false;
}

function placeCard(circle) {
  const at = circle.getBoundingClientRect();
  const left = at.right + 14 + card.offsetWidth > innerWidth ? at.left - 14 - card.offsetWidth : at.right + 14;
  card.style.left = Math.max(left, 8) + "px";
  card.style.top = Math.max(8, Math.min(at.top - 20, innerHeight - card.offsetHeight - 8)) + "px";
}

let here = null;  // the circle that is told of

function showPoint(circle) {
  if (circle === here) return;
  here?.classList.remove("here");
  here = circle;
  card.hidden = true;
  const figures = circle === null ? undefined : figuresOf(circle.dataset.point);
  if (figures === undefined) return;
  circle.classList.add("here");
  fillCard(figures);
  placeCard(circle);
  for (const image of card.querySelectorAll("img")) image.addEventListener("load", () => { if (here === circle) placeCard(circle); });
}

async function copyCommand(circle) {
  const command = figuresOf(circle.dataset.point)?.command ?? "";
  if (command === "") return;
  try {
    await navigator.clipboard.writeText(command);
  } catch {
    const field = document.createElement("textarea");  // where the browser gives pages from the disk no clipboard
    field.value = command;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
  card.querySelector(".told:last-child").textContent = "The command is copied.";
}
