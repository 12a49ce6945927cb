// The report of a sweep as somebody reads it, in Chromium: opened from the disk at two widths, in the light and in the dark, nothing is
// asked of a network, nothing is complained of, nothing is wider than the window; points tell what they are to the pointer and to
// the keys, plots zoom, and what is chosen is shown. CTest runs it on a report that synthetic_report writes; by hand, on any:
//
//     npm install --prefix build/playwright playwright-core
//     NODE_PATH=build/playwright/node_modules node tests/pages/report_test.cjs build/release/tests/synthetic_report [SCREENSHOTS]
//     NODE_PATH=build/playwright/node_modules node tests/pages/report_test.cjs out/sweep_quick/report.html [SCREENSHOTS]
"use strict";
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { execFileSync } = require("node:child_process");
const { launched } = require("./chromium.cjs");

const [given, screenshots] = process.argv.slice(2);
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "crevice_report_"));
const failures = [];

function expect(where, claim, ok, detail = "") {
  if (!ok) failures.push(`${where}: ${claim}${detail === "" ? "" : ` (${detail})`}`);
}

function reportToRead() {
  if (given.endsWith(".html")) return path.resolve(given);
  execFileSync(path.resolve(given), [scratch]);
  return path.join(scratch, "report.html");
}

async function opened(browser, file, where, options) {
  const context = await browser.newContext(options);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) expect(where, "says nothing on the console", false, message.text());
  });
  page.on("pageerror", (error) => expect(where, "throws nothing", false, String(error)));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) expect(where, "asks nothing of a network", false, request.url());
  });
  await page.goto("file://" + file);
  return page;
}

async function screenshot(page, name) {
  if (screenshots === undefined) return;
  fs.mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: path.join(screenshots, `${name}.png`), fullPage: !name.startsWith("seen") });
}

async function checkLooks(browser, file) {
  for (const width of [1280, 390]) {
    for (const colorScheme of ["light", "dark"]) {
      const where = `report at ${width} px, ${colorScheme}`;
      const page = await opened(browser, file, where, { viewport: { width, height: 900 }, colorScheme });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(where, "is no wider than the window", wide <= 0, `${wide} px`);
      await screenshot(page, `report_${width}_${colorScheme}`);
      await page.context().close();
    }
  }
}

// Without its script everything still stands there.
async function checkStill(browser, file) {
  const where = "report without script";
  const page = await opened(browser, file, where, { viewport: { width: 1280, height: 900 }, javaScriptEnabled: false });
  const plots = page.locator(".choices").first();
  const shown = () => plots.locator(".choice:visible svg > title").textContent();
  expect(where, "shows RMSE first", (await shown()).startsWith("RMSE over time"), await shown());
  await plots.locator("label", { hasText: "FLIP" }).click();
  expect(where, "shows FLIP when that is chosen", (await shown()).startsWith("FLIP over time"), await shown());
  await page.context().close();
}

async function checkPoints(page) {
  const plot = page.locator(".choice:visible svg").first(), card = page.locator("#point");
  await plot.scrollIntoViewIfNeeded();
  const circle = plot.locator(".curve circle[data-point]").first();
  await circle.hover({ force: true });
  expect("hover", "tells of the point", await card.isVisible());
  const row = await circle.evaluate((element) => {
    const [view, number] = element.dataset.point.split("-");
    const cells = document.querySelectorAll(`#${view}-points tbody tr`)[Number(number)].cells;
    const heads = [...document.querySelectorAll(`#${view}-points thead th`)].map((head) => head.textContent);
    return Object.fromEntries(heads.map((head, i) => [head, cells[i].textContent]));
  });
  const told = await card.textContent();
  for (const name of ["method", "setting", "RMSE", "ms", "command"])
    expect("hover", `tells the ${name}`, told.includes(row[name]), `${row[name]} is not in ${told}`);
  const width = await card.locator("img").evaluate((image) => image.decode().then(() => image.naturalWidth, () => 0));
  expect("hover", "shows the picture", width > 0);
  await screenshot(page, "seen_hover");
  await circle.click({ force: true });
  await page.waitForFunction(() => document.querySelector("#point .told:last-child")?.textContent.includes("copied"), null, { timeout: 5000 })
    .catch(() => expect("click", "says that the command is copied", false));
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect("click", "copies the command", copied === row.command, copied);
  await page.mouse.move(5, 5);
  await plot.focus();
  await page.keyboard.press("Escape");
  await page.keyboard.press("ArrowRight");
  const first = await card.textContent();
  expect("keys", "tell of the first point", await card.isVisible());
  await page.keyboard.press("ArrowRight");
  expect("keys", "go on to the next", await card.textContent() !== first);
  await page.keyboard.press("Escape");
  expect("keys", "put the card away", !await card.isVisible());
}

const ticksOf = (plot) => plot.locator("g.grid text").evaluateAll((texts) => texts.map((text) => text.textContent).join(" "));
const xOf = (circle) => circle.getAttribute("cx").then(Number);

async function checkZoom(page) {
  const plot = page.locator(".choice:visible svg").first();
  const tools = page.locator(".choice:visible .plot-tools").first();
  await plot.scrollIntoViewIfNeeded();
  const circle = plot.locator(".curve circle[data-point]").first();
  const [x, ticks] = [await xOf(circle), await ticksOf(plot)];
  const isWhole = async (how) => {
    expect(how, "puts every point back", Math.abs(await xOf(circle) - x) < 1e-6, String(await xOf(circle)));
    expect(how, "names the same values", await ticksOf(plot) === ticks);
  };
  await tools.getByText("+", { exact: true }).click();
  expect("button +", "names other values", await ticksOf(plot) !== ticks, ticks);
  expect("button +", "moves the points", await xOf(circle) !== x);
  await tools.getByText("whole", { exact: true }).click();
  await isWhole("button whole");
  await plot.focus();
  const box = await plot.boundingBox();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height * 0.4);
  await page.mouse.wheel(0, -400);
  await page.waitForTimeout(100);
  expect("wheel", "zooms", await ticksOf(plot) !== ticks);
  await page.keyboard.press("0");
  await isWhole("key 0");
  await page.mouse.move(box.x + box.width * 0.2, box.y + box.height * 0.2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.6, { steps: 4 });
  await page.mouse.up();
  expect("drag", "zooms into what was dragged over", await ticksOf(plot) !== ticks);
  expect("drag", "leaves no box behind", await plot.locator("rect.area").count() === 0);
  await screenshot(page, "seen_zoomed");
  await page.keyboard.press("0");
  await isWhole("key 0 after a drag");
}

async function checkFilters(page) {
  const filters = page.locator("form.filters");
  const curves = () => page.locator(".choice:visible svg").first().locator("g.curve:visible").count();
  const rings = () => page.locator(".choice:visible svg").first().locator("g.front circle").count();
  const [all_curves, all_rings] = [await curves(), await rings()];
  const boxes = filters.locator("input[name=method]");
  const method = await boxes.first().getAttribute("value");
  await boxes.first().uncheck();
  expect("filter", "hides the curve of a method", await curves() === all_curves - 1, `${await curves()} of ${all_curves}`);
  expect("filter", "hides its rows", await page.locator(`tbody tr:visible td:first-child:text-is("${method}")`).count() === 0);
  await screenshot(page, "seen_filtered");
  await boxes.first().check();
  expect("filter", "brings the curve back", await curves() === all_curves);
  expect("filter", "brings the front back", await rings() === all_rings, `${await rings()} of ${all_rings}`);
  for (const [name, of] of [["scene", "section[data-scene]"], ["threads", "[data-threads]"]]) {
    const select = filters.locator(`select[name=${name}]`);
    if (await select.count() === 0) continue;
    const chosen = await select.locator("option").nth(1).getAttribute("value");
    const attribute = `data-${name}`, all = await page.locator(`${of}:visible`).count();
    await select.selectOption(chosen);
    const shown = await page.locator(`${of}:visible`).evaluateAll((elements, key) => elements.map((element) => element.getAttribute(key)), attribute);
    expect("filter", `shows the chosen ${name} alone`, shown.length > 0 && shown.every((value) => value === chosen), shown.join(" "));
    await select.selectOption("");
    expect("filter", `shows all of ${name} again`, await page.locator(`${of}:visible`).count() === all);
  }
}

async function main() {
  const file = reportToRead();
  const browser = await launched(["--allow-file-access-from-files"]);
  try {
    await checkLooks(browser, file);
    await checkStill(browser, file);
    const page = await opened(browser, file, "report", { viewport: { width: 1280, height: 900 } });
    await checkPoints(page);
    await checkZoom(page);
    await checkFilters(page);
  } catch (error) {
    failures.push(String(error.stack ?? error));
  }
  await browser.close();
  fs.rmSync(scratch, { recursive: true });
  for (const failure of failures) console.log(failure);
  console.log(`report: ${failures.length} failures`);
  process.exit(failures.length === 0 ? 0 : 1);
}

if (given === undefined) {
  console.error("give the program synthetic_report or a report.html");
  process.exit(2);
}
main();
