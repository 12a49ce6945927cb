// What the page answers: why a pixel is as it is, and what rays say.
"use strict";
const { expect, expectEqual, expectDrawn, said, scratch, floatOf, openLab, rest, go, placeOf, hashOf, addressOf } = require("./page.cjs");

const kWidth = 96, kHeight = 54;
const kX = 48, kY = 40;  // on the floor, near the foot of a column

// Until the pixel of the present frame is answered.
const answered = (page) => page.waitForFunction(() => document.documentElement.dataset.probed !== undefined, null, { timeout: 60000 });

const probed = (...words) => JSON.parse(said(["probe", "columns", String(kX), String(kY), "--size", `${kWidth}x${kHeight}`, "--json", ...words]).stdout);

// The cells of a column of a table.
const cellsOf = (table_place, column) => table_place.evaluate((table, name) => {
  const at = [...table.tHead.rows[0].cells].findIndex((cell) => cell.textContent === name);
  return [...table.tBodies[0].rows].map((row) => row.cells[at].textContent);
}, column);

// Every method's samples are those of crevice probe.
async function checkSamples(browser) {
  const page = await openLab(browser, `#size=${kWidth}x${kHeight}`);
  await rest(page);
  for (const method of await page.locator("#ao option").allTextContents()) {
    await go(page, `#scene=columns&ao=${method}&size=${kWidth}x${kHeight}&pixel=${kX},${kY}`);
    await answered(page);
    const { ao } = probed("--ao", method).passes;
    if (ao.samples.length === 0) continue;
    const samples = page.locator("[data-pass=ao] .steps table");
    const told = await page.locator("[data-pass=ao] .step-bar output").textContent();
    expect(`${method}: the last step tells the value`, told.endsWith(` = ${shortest(ao.value)}`), told);
    const contributions = await cellsOf(samples, "contribution");
    expectEqual(`${method}: the table has the probe's samples`, contributions.join(), ao.samples.map(({ contribution }) => shortest(contribution)).join());
    expectEqual(`${method}: the table has the probe's sums`, (await cellsOf(samples, "sum")).join(), ao.samples.map(({ sum }) => shortest(sum)).join());
  }
}

// As cellText() of the page writes floats.
function shortest(value) {
  for (let digits = 6; digits < 10; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === Math.fround(value)) return String(Number(text));
  }
  return String(value);
}

// A click asks; rows light their samples up; steps make the sum grow.
async function checkSteps(browser) {
  const page = await openLab(browser, `#size=${kWidth}x${kHeight}&ao=luna&show=ao_raw`);
  await rest(page);
  await page.mouse.click(...await placeOf(page, kX, kY, kWidth, kHeight));
  await answered(page);
  expect("a click asks about its pixel", (await addressOf(page)).includes(`pixel=${kX},${kY}`), await addressOf(page));
  const { ao } = probed("--ao", "luna").passes;
  const dots = () => page.locator("#overlay circle").count();
  expectEqual("all samples are in the picture", await dots(), ao.samples.length);
  await page.locator("[data-pass=ao] .steps tbody tr").nth(3).hover();
  const lit = await page.locator("#overlay circle.lit").evaluate((circle) => [circle.getAttribute("cx"), circle.getAttribute("cy")].map(Number));
  expectEqual("a row lights its sample up in the picture", lit.join(), ao.samples[3].q_screen.join());
  expectEqual("and in the cut", await page.locator(".section circle.lit").count(), 1);
  const pass = page.locator("[data-pass=ao]");
  await pass.locator(".step-bar button").first().click();
  expectEqual("before the first step there is no sample", await dots(), 0);
  for (let step = 1; step <= ao.samples.length; ++step) {
    await pass.locator(".step-bar button").nth(2).click();
    expectEqual(`after step ${step} there are as many samples`, await dots(), step);
    const told = await pass.locator(".step-bar output").textContent();
    expect(`step ${step} tells the sum`, told.includes(`: ${shortest(ao.samples[step - 1].sum)}`), told);
  }
  const { passes } = probed("--ao", "luna").passes.blur;
  await page.locator("[data-pass=blur] > summary").click();
  const iterations = page.locator("[data-pass=blur] .iteration");
  expectEqual("the blur has the probe's passes", await iterations.count(), passes.length);
  const last = iterations.last();
  await last.locator("summary").click();
  await expectDrawn("its taps are in the picture", dots, passes.at(-1).taps.length);
  const sums = await cellsOf(last.locator("table"), "sum");
  expectEqual("their sum is the probe's", sums.at(-1), shortest(passes.at(-1).sum));
  await page.locator("#pixel_clear").click();
  expectEqual("none takes the answer away", await page.locator("#pixel_answer details").count(), 0);
}

async function checkTruth(browser) {
  const page = await openLab(browser, "#size=96x54&ao=luna&show=ao_error");
  await rest(page);
  await page.locator("#truth").check();
  const told = async (rays) => {
    await page.waitForFunction((least) => parseInt(document.getElementById("truth_told").textContent, 10) >= least, rays);
    return /^(\d+) .*RMSE ([\d.e-]+), bias (-?[\d.e-]+)/.exec(await page.locator("#truth_told").textContent());
  };
  const first = await told(8), later = await told(128);
  expect("the page tells an error", first !== null && later !== null);
  expect("rays refine", Number(later[1]) > Number(first[1]), `${first[1]}, ${later[1]}`);
  said(["truth", "columns", "--ao", "luna", "--size", "96x54", "--rays", "1024", "--limit-seeds", "0", "--no-cache", "--out", scratch]);
  expectEqual("the signed error is shown", await page.locator("#stage .first figcaption").textContent(), "ao_error");
  expect("the error is that of an approximation", Number(later[2]) > 0.005 && Number(later[2]) < 0.3, later[2]);
  await page.locator("#show").selectOption("truth");
  await told(512);
  await page.mouse.move(...await placeOf(page, 48, 40, 96, 54));
  const value = Number(/= (\S+)/.exec(await page.locator("#value").textContent())[1]);
  const wanted = floatOf("truth_soft", 48, 40, 96);
  expect("the truth is that of crevice truth", Math.abs(value - wanted) < 0.1, `${value}, not about ${wanted}`);
  await page.locator("#truth").uncheck();
  expectEqual("without rays nothing is told", await page.locator("#truth_told").textContent(), "");
}

module.exports = { samples: checkSamples, steps: checkSteps, truth: checkTruth };
