// The book's pages as a reader meets them, in Chromium: opened from the disk at two widths, in the light and in the dark,
// in each language; nothing is asked of a network, nothing is complained of, nothing is wider than the window; sliders,
// enlarged pictures and the values under the pointer work. By hand, since it needs playwright-core from npm:
//
//     crevice chapter all --out OUT
//     npm install --prefix build/playwright playwright-core
//     NODE_PATH=build/playwright/node_modules node tests/pages/pages_test.cjs OUT [DIRECTORY_FOR_SCREENSHOTS]
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const { chromium } = require("playwright-core");

const [out, screenshots] = process.argv.slice(2);
if (out === undefined) {
  console.error("give the directory that `crevice chapter all --out` wrote");
  process.exit(2);
}
const program = process.env.CHROMIUM ?? "/usr/bin/chromium";
const failures = [];

function expect(page, claim, ok, detail = "") {
  if (!ok) failures.push(`${page}: ${claim}${detail === "" ? "" : ` (${detail})`}`);
}

// The float at a pixel of a .npy file: version 1.0, float32, C order.
function npyValue(file, x, y, width) {
  const bytes = fs.readFileSync(file);
  return bytes.readFloatLE(10 + bytes.readUInt16LE(8) + 4 * (y * width + x));
}

async function checkPair(name, page) {
  const figure = page.locator("figure.with-pair").first();
  if (await figure.count() === 0) return;
  await figure.scrollIntoViewIfNeeded();
  const at = () => figure.locator(".pair").evaluate((pair) => pair.style.getPropertyValue("--at"));
  await figure.locator("input[type=range]").fill("20");
  expect(name, "the slider moves the edge between two pictures", await at() === "20%", await at());
  await figure.locator("button.ab").click();
  expect(name, "A | B shows the first picture whole", await at() === "100%", await at());
  await figure.locator("button.ab").click();
  expect(name, "A | B shows the second picture whole", await at() === "0%", await at());
}

async function checkViewer(name, page) {
  const picture = page.locator(".picture:has(button.canvas)").first();
  if (await picture.count() === 0) return;
  // At its left: of a pair, the right half shows the other picture.
  await picture.locator("button.canvas").click({ position: { x: 8, y: 8 } });
  const dialog = page.locator("dialog.viewer");
  expect(name, "a click enlarges a picture", await dialog.isVisible());
  const transform = () => dialog.locator("img").evaluate((image) => image.style.transform);
  const before = await transform();
  await page.keyboard.press("+");
  expect(name, "the key + enlarges it further", await transform() !== before);
  await page.keyboard.press("0");
  expect(name, "the key 0 shows it whole again", await transform() === before);
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached", timeout: 5000 }).catch(() => {});
  expect(name, "Escape closes it", await dialog.count() === 0);
}

// What the pointer is told of the middle of the first picture that has values: as .npy holds it, where the chapter was
// asked for that cell.
async function checkValue(name, page) {
  const picture = page.locator(".row .picture:has(script.values), .pictures > .picture:has(script.values)").first();
  if (await picture.count() === 0) return;
  await picture.locator("img").scrollIntoViewIfNeeded();
  const box = await picture.locator("img").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const readout = page.locator("#value");
  await readout.waitFor({ state: "visible", timeout: 5000 }).catch(() => {});
  const words = /^(\S+) \((\d+), (\d+)\) = (.+)$/.exec(await readout.textContent() ?? "");
  expect(name, "the pointer tells a pixel's value", words !== null, await readout.textContent());
  if (words === null) return;
  const file = path.join(out, name, `${words[1]}.npy`);
  if (!fs.existsSync(file)) return;
  const width = Number(await picture.getAttribute("data-width"));
  const expected = npyValue(file, Number(words[2]), Number(words[3]), width);
  const told = words[4].replace("inf", "Infinity").split(" ");
  if (told.length === 1)
    expect(name, "the value is the buffer's", Math.fround(Number(told[0])) === expected || Object.is(Number(told[0]), expected),
           `${told[0]}, not ${expected}`);
}

// Films wait, closed, for the reader who wants to see something move.
async function checkFilms(name, page) {
  for (const film of await page.locator("details.film").all()) {
    const image = film.locator("img");
    expect(name, "a film is closed at first", !await image.isVisible());
    await film.locator("summary").click();
    const width = await image.evaluate((shown) => shown.decode().then(() => shown.naturalWidth, () => 0));
    expect(name, "a film can be played", await image.isVisible() && width > 0);
  }
}

async function checkLanguages(name, page) {
  for (const language of ["zh", "en"]) {
    const button = page.locator(`[data-set-lang=${language}]`);
    if (await button.count() === 0) return;
    await button.click();
    const other = language === "zh" ? "en" : "zh";
    expect(name, `${language} hides the other language`, await page.locator(`main .${other}:visible`).count() === 0);
  }
}

async function checkPage(browser, file, width, scheme) {
  const name = path.basename(file, ".html");
  const where = `${name} at ${width} px, ${scheme}`;
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme });
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) expect(where, "says nothing on the console", false, message.text());
  });
  page.on("pageerror", (error) => expect(where, "throws nothing", false, String(error)));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) expect(where, "asks nothing of a network", false, request.url());
  });
  await page.goto("file://" + path.resolve(file));
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  expect(where, "is no wider than the window", wide <= 0, `${wide} px`);
  const unset = await page.evaluate(() => [...document.querySelectorAll("x-equation")].filter((e) => e.querySelector(".katex") === null).length);
  expect(where, "sets all mathematics", unset === 0, `${unset} are not`);
  if (screenshots !== undefined)
    await page.screenshot({ path: path.join(screenshots, `${name}_${width}_${scheme}.png`), fullPage: true });
  if (width > 1000 && scheme === "light") {
    await checkValue(name, page);
    await checkViewer(name, page);
    await checkPair(name, page);
    await checkFilms(name, page);
    await checkLanguages(name, page);
  }
  await context.close();
}

// Who opens the book for the first time reads it in the language of the browser.
async function checkFirstLanguage(browser, file) {
  for (const [locale, language] of [["zh-CN", "zh"], ["en-GB", "en"], ["fr-FR", "en"]]) {
    const context = await browser.newContext({ locale });
    const page = await context.newPage();
    await page.goto("file://" + path.resolve(file));
    const shown = await page.evaluate(() => document.documentElement.lang);
    expect(path.basename(file), `a browser in ${locale} begins with ${language}`, shown === language, shown);
    await context.close();
  }
}

async function main() {
  const pages = fs.readdirSync(out).filter((file) => file.endsWith(".html")).sort();
  if (screenshots !== undefined) fs.mkdirSync(screenshots, { recursive: true });
  const browser = await chromium.launch({ executablePath: program, args: ["--no-sandbox", "--allow-file-access-from-files"] });
  for (const page of pages) {
    for (const width of [1280, 390])
      for (const scheme of ["light", "dark"]) await checkPage(browser, path.join(out, page), width, scheme);
    process.stdout.write(`${page}\n`);
  }
  await checkFirstLanguage(browser, path.join(out, "index.html"));
  await browser.close();
  for (const failure of failures) console.log(failure);
  console.log(`${pages.length} pages, ${failures.length} failures`);
  process.exit(failures.length === 0 ? 0 : 1);
}

main();
