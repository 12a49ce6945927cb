// The page under mouse, keys and eyes: views, camera, sizes of the window, languages, names for those who do not see it.
"use strict";
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { lab_page, expect, expectEqual, expectDrawn, openLab, rest, after, go, hashOf, addressOf, colourAt, drag, rendered } = require("./page.cjs");

const screenshots = process.argv[5];

async function checkViews(browser) {
  const page = await openLab(browser, "#size=160x90&scene=cornell");
  await rest(page);
  for (const name of ["normal", "view_depth", "ndc_depth", "ao_raw", "ao_blurred", "lit"]) {
    await page.locator("#show").selectOption(name);
    await expectDrawn(`${name} is shown`, () => page.locator("#stage .first figcaption").textContent(), name);
  }
  for (const view of ["pair", "split", "flip"]) {
    await page.locator("#view").selectOption(view);
    await page.locator("#against").selectOption("normal");
    await expectDrawn(`${view} has a second buffer`, () => page.locator("#stage .second figcaption").textContent(), "normal");
  }
  const visible = () => page.locator("#stage .second").evaluate((figure) => getComputedStyle(figure).visibility);
  await expectDrawn("flip begins with the first buffer", visible, "hidden");
  await page.locator("#flip").click();
  await expectDrawn("the button flips", visible, "visible");
  await page.locator("#stage").focus();
  await page.keyboard.press(" ");
  await expectDrawn("the space bar flips back", visible, "hidden");
  await page.locator("#view").selectOption("split");
  await page.locator("#edge").fill("25");
  const moved = () => page.locator("#stage .second").evaluate((figure) => getComputedStyle(figure).clipPath.includes("25%"));
  await expectDrawn("the slider moves the edge", moved, true);
  await page.locator("#view").selectOption("difference");
  await page.locator("#show").selectOption("ao_blurred");
  await page.locator("#against").selectOption("ao_blurred");
  await expectDrawn("a buffer less itself is white", async () => String(await colourAt(page, "first", 40, 20)), "255,255,255");
  await page.locator("#view").selectOption("one");
  await page.locator("#show").selectOption("ao_raw");
  await page.locator("#colours").selectOption("false");
  await after(page, async () => {
    await page.locator("#range_low").fill("2");
    await page.locator("#range_high").fill("3");
    await page.locator("#range_high").press("Tab");
  });
  await expectDrawn("what lies below the range has the first false colour", async () => String(await colourAt(page, "first", 40, 20)), "68,1,84");
  await expectDrawn("the histogram has the range", () => page.locator("#histogram_high").textContent(), "3");
  await after(page, () => page.locator("#range_auto").click());
  expect("the whole range is that of the values", Number(await page.locator("#histogram_high").textContent()) <= 1);
}

async function checkCamera(browser) {
  const page = await openLab(browser, "#size=160x90");
  await rest(page);
  const before = await hashOf(page, "view_depth");
  await after(page, () => drag(page, 60, 20));
  expect("a drag turns the camera", await hashOf(page, "view_depth") !== before && /eye=.*target=/.test(await addressOf(page)));
  for (const key of ["ArrowLeft", "ArrowUp", "w", "a", "e", "+", "-"]) {
    const last = await addressOf(page);
    await after(page, async () => {
      await page.locator("#stage").focus();
      await page.keyboard.press(key);
    });
    expect(`the key ${key} moves the camera`, await addressOf(page) !== last);
  }
  await page.locator("#camera_mode").selectOption("fly");
  const eye = new URLSearchParams((await addressOf(page)).slice(1)).get("eye");
  await after(page, () => page.keyboard.press("Tab").then(() => page.locator("#stage").press("ArrowRight")));
  expectEqual("who looks around stays where he is", new URLSearchParams((await addressOf(page)).slice(1)).get("eye"), eye);
  await after(page, () => page.locator("#stage").press("0"));
  expectEqual("0 brings the scene's own camera back", await hashOf(page, "view_depth"), before);
  for (const [field, flag, word] of [["fov_y", "--fov-y", "30"], ["far", "--far", "60"], ["ortho", "--ortho", "14"]]) {
    await after(page, async () => {
      await page.locator(`#camera_${field}`).fill(word);
      await page.locator(`#camera_${field}`).press("Tab");
    });
    const { buffers } = rendered(["columns", "--size", "160x90", `${flag}=${word}`]);
    expectEqual(`the field ${field} is the flag ${flag}`, await hashOf(page, "ndc_depth"), buffers.ndc_depth.hash);
    await after(page, () => page.locator("#camera_reset").click());
  }
}

// Fingers: one turns, two that part come nearer.
async function checkTouch(browser) {
  const page = await openLab(browser, "#size=160x90", { hasTouch: true });
  await rest(page);
  const box = await page.locator("#stage").boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", {
    type, touchPoints: points.map(([x, y], id) => ({ x: box.x + x, y: box.y + y, id })) });
  const eye = async () => (new URLSearchParams((await addressOf(page)).slice(1)).get("eye") ?? "0,0,-10").split(",").map(Number);
  const distance = async () => Math.hypot(...await eye());
  await after(page, async () => {
    await touch("touchStart", [200, 200]);
    for (const x of [220, 240, 260]) await touch("touchMove", [x, 200]);
    await touch("touchEnd");
  });
  expect("one finger turns the camera round its target", Math.abs(await distance() - 10) < 0.01 && Math.abs((await eye())[0]) > 1, String(await eye()));
  const before = await distance();
  await after(page, async () => {
    await touch("touchStart", [300, 200], [340, 200]);
    for (const by of [10, 20, 40]) await touch("touchMove", [300 - by, 200], [340 + by, 200]);
    await touch("touchEnd");
  });
  expect("two fingers that part come nearer", await distance() < 0.7 * before, `${await distance()}, before ${before}`);
}

async function checkLooks(browser) {
  for (const width of [1280, 390]) {
    for (const colorScheme of ["light", "dark"]) {
      for (const language of ["en", "zh"]) {
        const where = `at ${width} px, ${colorScheme}, ${language}`;
        const page = await openLab(browser, "#size=160x90&scene=columns&ao=xjun&show=ao_raw&pixel=70,60", { viewport: { width, height: 900 }, colorScheme });
        await rest(page);
        await page.locator(`[data-set-lang=${language}]`).click();
        expectEqual(`the page says its language ${where}`, await page.evaluate(() => document.documentElement.lang), language);
        const empty = await page.evaluate(() => [...document.querySelectorAll("[data-text]")].filter((place) => place.textContent === "").length);
        expectEqual(`every text is there ${where}`, empty, 0);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        expect(`the page is no wider than the window ${where}`, wide <= 0, `${wide} px`);
        if (screenshots !== undefined) {
          fs.mkdirSync(screenshots, { recursive: true });
          await page.screenshot({ path: path.join(screenshots, `lab_${width}_${colorScheme}_${language}.png`), fullPage: true });
        }
        await page.context().close();
      }
    }
  }
}

// What the tables of the program say is there in Chinese, too.
async function checkChinese(browser) {
  const page = await openLab(browser, "#size=64x36");
  await rest(page);
  await page.locator("[data-set-lang=zh]").click();
  for (const method of await page.locator("#ao option").allTextContents()) {
    await page.locator("#ao").selectOption(method);
    const texts = [await page.locator("#method_about").textContent(), ...await page.locator(".parameter .about").allTextContents()];
    for (const text of texts) expect(`${method} has its texts in Chinese`, /[\u4e00-\u9fff]/.test(text), text);
  }
  await checkChineseAnswers(page);
  await page.context().close();
}

// Whatever the probe says of pixels: the foot of a column, its edge before the sky, the open floor, the sky.
async function checkChineseAnswers(page) {
  const places = ["15,27", "20,20", "32,34", "32,2"], columns = ["verdict", "why", "term"];
  for (const [method, param] of [...await page.locator("#ao option").allTextContents()].flatMap((name) => [[name, ""], [name, "&param=blur_iterations=0"]])) {
    for (const place of param === "" ? places : places.slice(0, 1)) {
      await go(page, `#scene=columns&ao=${method}&size=64x36&pixel=${place}${param}`);
      if (await page.locator("#refused").isVisible()) continue;  // a method without a blur
      await page.waitForFunction((asked) => document.documentElement.dataset.probed === asked, place, { timeout: 60000 });
      const said = await page.evaluate((names) => [
        document.querySelector("#pixel_answer > p").textContent,
        ...[...document.querySelectorAll("#pixel_answer .iteration > summary")].map((summary) => summary.textContent),
        ...[...document.querySelectorAll("#pixel_answer li")].map((item) => /^left out: (.*)/.exec(item.textContent)?.[1]).filter((text) => text !== undefined),
        ...[...document.querySelectorAll("#pixel_answer table")].flatMap((table) => {
          const at = [...table.tHead.rows[0].cells].flatMap((cell, index) => (names.includes(cell.textContent) ? [index] : []));
          return [...table.tBodies[0].rows].flatMap((row) => at.map((index) => row.cells[index].textContent));
        })], columns);
      for (const text of said) {
        const english = text.replace(/blur_iterations|none|sum|total|AO/g, "").match(/[A-Za-z]{2,}/);
        expect(`${method}${param} at ${place} answers in Chinese`, english === null && /[\u4e00-\u9fff]/.test(text), text);
      }
    }
  }
}

async function checkLabels(browser) {
  const page = await openLab(browser, "#size=96x54&view=flip");
  await rest(page);
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas, svg[role=img], [role=application]")]
    .filter((place) => place.getAttribute("aria-hidden") !== "true")
    .filter((place) => !place.getAttribute("aria-label") && !(place.labels?.length > 0) && place.textContent.trim() === "")
    .map((place) => place.outerHTML.slice(0, 80)));
  expectEqual("everything that one can use or see has a name", nameless.join("; "), "");
  const reached = new Set();
  for (let step = 0; step < 120; ++step) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id));
  }
  for (const id of ["scene", "preset", "size", "show", "view", "against", "colours", "flip", "stage", "ao", "param_radius", "truth", "files", "copy_link", "copy_command", "pixel_x", "pixel_ask"])
    expect(`the tab key reaches ${id}`, reached.has(id));
}

async function checkLacks(browser) {
  for (const [lack, word] of [["WebAssembly", "WebAssembly"], ["Worker", "workers"], ["DecompressionStream", "DecompressionStream"]]) {
    const context = await browser.newContext({ locale: "en-GB" });
    const page = await context.newPage();
    await page.addInitScript((name) => { delete window[name]; }, lack);
    await page.goto(`file://${lab_page}`);
    await page.locator("#lacks").waitFor({ state: "visible" });
    const line = await page.locator("#lacks").textContent();
    expect(`a browser without ${lack} is told so`, line.includes(word), line);
    await context.close();
  }
}

// By hand, on a quiet machine: it prints what it measures, and the load.
async function measureSpeed(browser) {
  const page = await openLab(browser, "#size=640x360&ao=xjun&param=samples=14");
  await rest(page);
  const first = await page.evaluate(() => document.documentElement.dataset.firstPictureMs);
  console.log(`first picture after ${first} ms; load ${os.loadavg()[0].toFixed(1)}`);
  const box = await page.locator("#stage").boundingBox();
  for (const show of ["ao_blurred", "lit"]) {
    await page.locator("#show").selectOption(show);
    await page.mouse.move(box.x + 300, box.y + 150);
    await page.mouse.down();
    for (let step = 0; step < 90; ++step) {
      await page.mouse.move(box.x + 300 + 2 * step, box.y + 150);
      await page.waitForTimeout(15);
    }
    console.log(`${show}: ${await page.locator("#rate").textContent()}`);
    await page.mouse.up();
  }
}

module.exports = { views: checkViews, camera: checkCamera, touch: checkTouch, looks: checkLooks, chinese: checkChinese, labels: checkLabels, lacks: checkLacks, speed: measureSpeed };
