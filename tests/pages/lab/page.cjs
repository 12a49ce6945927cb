// The lab's page in Chromium, opened from the disk, and the program beside it: what all checks of lab_test.cjs share.
"use strict";
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { execFileSync, spawnSync } = require("node:child_process");

const [, lab_page, program] = process.argv.slice(2).map((word) => path.resolve(word));
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "crevice_lab_"));
const failures = [];

function expect(claim, ok, detail = "") {
  if (!ok) failures.push(`${claim}${detail === "" ? "" : ` (${detail})`}`);
}
function expectEqual(claim, found, wanted) {
  expect(claim, found === wanted, `${JSON.stringify(found)}, not ${JSON.stringify(wanted)}`);
}

// What the page draws with its next frame: `find` is asked until it finds what is wanted, or five seconds have passed.
async function expectDrawn(claim, find, wanted) {
  const end = Date.now() + 5000;
  let found = await find();
  while (found !== wanted && Date.now() < end) {
    await new Promise((go_on) => setTimeout(go_on, 20));
    found = await find();
  }
  expectEqual(claim, found, wanted);
}

// ---- the program ------------------------------------------------------------------------------------------------------

// What the program writes of these words: passes.json.
function rendered(words) {
  execFileSync(program, ["render", ...words, "--out", scratch], { stdio: "ignore", cwd: scratch });
  return JSON.parse(fs.readFileSync(path.join(scratch, "passes.json"), "utf8"));
}

// What it says, on both its outputs; `directory`: where it is started.
function said(words, directory = scratch) {
  const { stdout, stderr } = spawnSync(program, words, { encoding: "utf8", cwd: directory });
  return { stdout, stderr: stderr.trim() };
}

// The float at a pixel of NAME.npy, as it was rendered last.
function floatOf(name, x, y, width) {
  const bytes = fs.readFileSync(path.join(scratch, `${name}.npy`));
  return bytes.readFloatLE(10 + bytes.readUInt16LE(8) + 4 * (y * width + x));
}

// ---- the page -----------------------------------------------------------------------------------------------------------

// A page of the disk that must neither complain nor ask anything of a network.
async function openPage(browser, file, hash = "", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, locale: "en-GB", ...options });
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) expect("the page says nothing on the console", false, message.text());
  });
  page.on("pageerror", (error) => expect("the page throws nothing", false, String(error)));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) expect("the page asks nothing of a network", false, request.url());
  });
  await page.goto(`file://${file}${hash}`);
  return page;
}

const openLab = (browser, hash, options) => openPage(browser, lab_page, hash, options);

// Until all buffers of the present state are there, or it was refused.
async function rest(page) {
  await page.waitForFunction(() => ["true", "refused"].includes(document.documentElement.dataset.settled), null, { timeout: 60000 });
}

// Changes something, and waits until the page has answered it.
async function after(page, change) {
  await page.evaluate(() => { delete document.documentElement.dataset.settled; });
  await change();
  await rest(page);
}

const go = (page, hash) => after(page, () => page.evaluate((next) => { location.hash = next; }, hash));
const hashOf = (page, buffer) => page.locator(`tr[data-buffer=${buffer}] .hash`).textContent();
const addressOf = (page) => page.evaluate(() => location.hash);

// The colour of a canvas' pixel, of a copy: a canvas that is read from is drawn more slowly.
const colourAt = (page, which, x, y) => page.locator(`#stage .${which} canvas`).evaluate((canvas, [column, row]) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  return [...copy.getImageData(column, row, 1, 1).data].slice(0, 3);
}, [x, y]);

// Where the middle of a pixel of the picture, of `width` x `height`, lies in the window.
async function placeOf(page, x, y, width, height) {
  const canvas = page.locator("#stage .first canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  return [box.x + box.width * (x + 0.5) / width, box.y + box.height * (y + 0.5) / height];
}

async function drag(page, dx, dy) {
  await page.locator("#stage").scrollIntoViewIfNeeded();
  const box = await page.locator("#stage").boundingBox();
  await page.mouse.move(box.x + 150, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 150 + dx, box.y + 100 + dy, { steps: 5 });
  await page.mouse.up();
}

module.exports = {
  lab_page, program, scratch, failures, expect, expectEqual, expectDrawn, rendered, said, floatOf, openPage, openLab, rest, after, go, hashOf, addressOf,
  colourAt, placeOf, drag,
};
