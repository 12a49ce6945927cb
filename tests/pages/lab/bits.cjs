// The page's bits are the program's: of every method, parameter, preset, link, and of files that are dropped.
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const { lab_page, scratch, expect, expectEqual, rendered, said, floatOf, openLab, openPage, rest, after, go, hashOf, addressOf, placeOf, drag } = require("./page.cjs");

async function checkHashes(browser) {
  const page = await openLab(browser, "#size=64x36");
  await rest(page);
  const methods = await page.locator("#ao option").allTextContents();
  const listed = said(["methods"]).stdout;
  expect("the page offers every method of the program", methods.every((name) => listed.includes(`${name} `)) && methods.length > 10, methods.join(" "));
  for (const size of ["96x54", "161x91"]) {
    for (const method of methods) {
      await go(page, `#scene=columns&ao=${method}&size=${size}`);
      const { buffers } = rendered(["columns", "--ao", method, "--size", size]);
      for (const [name, { hash }] of Object.entries(buffers))
        expectEqual(`${name} of ${method} at ${size} has the program's hash`, await hashOf(page, name), hash);
    }
  }
}

async function checkValue(browser) {
  const page = await openLab(browser, "#size=160x90&show=view_depth");
  await rest(page);
  await page.mouse.move(...await placeOf(page, 80, 60, 160, 90));
  const told = /^view_depth \(80, 60\) = (\S+)$/.exec(await page.locator("#value").textContent());
  rendered(["columns", "--size", "160x90", "--only", "view_depth"]);
  const wanted = floatOf("view_depth", 80, 60, 160);
  expect("the pointer tells the float of the buffer", told !== null && Math.fround(Number(told[1])) === wanted, `${told?.[1]}, not ${wanted}`);
}

async function checkParameters(browser) {
  const page = await openLab(browser, "#size=96x54&ao=luna");
  await rest(page);
  const listed = said(["params", "luna"]).stdout;
  const names = await page.locator(".parameter label").allTextContents();
  expect("every parameter is one of the program's", names.length > 20 && names.every((name) => listed.includes(`\n${name} `)), names.join(" "));
  await after(page, async () => {
    await page.locator("#param_radius").fill("1.25");
    await page.locator("#param_radius").press("Tab");
  });
  expect("the address holds a parameter", (await addressOf(page)).includes("param=radius=1.25"), await addressOf(page));
  const { buffers } = rendered(["columns", "--ao", "luna", "--size", "96x54", "--param", "radius=1.25"]);
  expectEqual("a parameter makes the program's bits", await hashOf(page, "ao_raw"), buffers.ao_raw.hash);
  await after(page, () => page.locator(".parameter:has(#param_radius) .back").click());
  expect("the arrow takes a parameter back", !(await addressOf(page)).includes("param="), await addressOf(page));
  await after(page, async () => {
    await page.locator("#param_radius").fill("-1");
    await page.locator("#param_radius").press("Tab");
  });
  const { stderr } = said(["render", "columns", "--ao", "luna", "--param", "radius=-1"]);
  expectEqual("a value out of range is refused in the program's words", await page.locator("#refused").textContent(), stderr);
  await after(page, () => page.locator("#all_defaults").click());
  expect("defaults mend it", await page.locator("#refused").isHidden());
}

async function checkPresets(browser) {
  const page = await openLab(browser, "#size=96x54");
  await rest(page);
  const names = (await page.locator("#preset option").allTextContents()).slice(1);
  expect("there are presets", names.length >= 8, names.join(" "));
  for (const name of names) {
    await after(page, () => page.locator("#preset").selectOption(name));
    const { buffers } = rendered(["--preset", name, "--size", "96x54"]);
    for (const buffer of ["ao_blurred", "lit"])
      expectEqual(`${buffer} of the preset ${name} has the program's hash`, await hashOf(page, buffer), buffers[buffer].hash);
  }
}

async function checkLink(browser) {
  const hash = "#scene=columns&ao=xjun&size=160x90&param=epsilon=0&eye=-12,9,-14&target=0,2,0&show=ao_raw&view=split&against=normal";
  const page = await openLab(browser, hash);
  await rest(page);
  expectEqual("a link shows its buffer", await page.locator("#show").inputValue(), "ao_raw");
  expectEqual("a link sets its parameter", await page.locator("#param_epsilon").inputValue(), "0");
  await page.locator("#copy_command").click();
  const command = await page.evaluate(() => navigator.clipboard.readText());
  expect("the command is the program's", command.startsWith("crevice render columns "), command);
  const { buffers } = rendered(command.split(" ").slice(2));
  for (const name of ["normal", "ndc_depth", "ao_raw", "ao_blurred", "lit"])
    expectEqual(`${name} of the copied command has the page's hash`, await hashOf(page, name), buffers[name].hash);
  await page.locator("#copy_link").click();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const again = await openLab(browser, new URL(link).hash);
  await rest(again);
  expectEqual("a copied link makes the same bits", await hashOf(again, "ao_raw"), await hashOf(page, "ao_raw"));
}

// A chapter's pictures and commands lead to the lab, which draws their bits and tells of their pixel.
async function checkBook(browser) {
  said(["chapter", "06", "--size", "160x90", "--quiet", "--out", scratch]);
  fs.copyFileSync(lab_page, path.join(scratch, "lab.html"));
  const file = path.join(scratch, "06_occlusion_test.html");
  const page = await openPage(browser, file);
  const link = page.locator("a:has(code)", { hasText: "crevice render" }).first();
  const command = await link.textContent();
  await link.click();
  await rest(page);
  const { buffers } = rendered([...command.split(" ").slice(2), "--size", "640x360"]);
  for (const name of ["normal", "ao_raw", "lit"])
    expectEqual(`${name} of ${command}, linked by a chapter, has the program's hash`, await hashOf(page, name), buffers[name].hash);
  await checkPictureLinks(await openPage(browser, file));
  await checkPresetLink(browser);
}

// One link to a buffer, and one to the texel whose numbers the chapter carries along.
async function checkPictureLinks(page) {
  const links = page.locator("a.lab");
  expect("pictures of a chapter have links into the lab", await links.count() > 5, String(await links.count()));
  const commands = await links.evaluateAll((all) => all.map((link) => link.title));
  const drawn = commands.find((command) => command.startsWith("crevice render ")), probed = commands.find((command) => command.startsWith("crevice probe "));
  await page.locator(`a.lab[title=${JSON.stringify(drawn)}]`).first().click();
  await rest(page);
  const shown = await page.locator("#show").inputValue();
  expectEqual(`${shown} of ${drawn} has the program's hash`, await hashOf(page, shown), rendered(drawn.split(" ").slice(2)).buffers[shown].hash);
  await page.goBack();
  await page.locator(`a.lab[title=${JSON.stringify(probed)}]`).first().click();
  await rest(page);
  const [, , , x, y] = probed.split(" ");
  await page.waitForFunction((pixel) => document.documentElement.dataset.probed === pixel, `${x},${y}`, { timeout: 60000 });
  const { answer } = JSON.parse(said([...probed.split(" ").slice(1), "--json"]).stdout);
  expectEqual(`the answer to ${probed} is the program's`, await page.locator("#pixel_answer > p").textContent(), answer);
}

async function checkPresetLink(browser) {
  for (const command of ["crevice render --preset luna --size 96x54", "crevice render --preset xjun2020_published --ao none --size 96x54"]) {
    const page = await openPage(browser, lab_page, `#${encodeURIComponent(command)}`);
    await rest(page);
    expectEqual(`lit of ${command} has the program's hash`, await hashOf(page, "lit"), rendered(command.split(" ").slice(2)).buffers.lit.hash);
  }
}

// A square before a wall, with a texture; and files that are none.
function writeScenes() {
  rendered(["cornell", "--size", "32x32", "--only", "ao_raw"]);
  fs.renameSync(path.join(scratch, "ao_raw.png"), path.join(scratch, "squares.png"));
  fs.writeFileSync(path.join(scratch, "squares.mtl"), "newmtl wall\nKd 0.8 0.7 0.6\nmap_Kd squares.png\n");
  fs.writeFileSync(path.join(scratch, "squares.obj"), `mtllib squares.mtl
v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl wall
f 1/1 2/2 3/3 4/4
f 5/1 6/2 7/3 8/4
`);
  fs.writeFileSync(path.join(scratch, "bad.obj"), "v 0 0 0\nv 1 0 zero\nv 0 1 0\nf 1 2 3\n");
}

const drop = (page, names) => page.evaluate((files) => {
  const transfer = new DataTransfer();
  for (const { name, bytes } of files) transfer.items.add(new File([new Uint8Array(bytes)], name));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, names.map((name) => ({ name, bytes: [...fs.readFileSync(path.join(scratch, name))] })));

// The OBJ of writeScenes() in a directory of its own, without what it names.
function withLoneObj() {
  const directory = path.join(scratch, "lone");
  fs.mkdirSync(directory);
  fs.copyFileSync(path.join(scratch, "squares.obj"), path.join(directory, "lone.obj"));
  return directory;
}

async function checkFiles(browser) {
  writeScenes();
  const page = await openLab(browser, "#size=96x54");
  await rest(page);
  await after(page, () => drop(page, ["squares.obj", "squares.mtl", "squares.png"]));
  expectEqual("the dropped OBJ is the scene", await page.locator("#scene").inputValue(), "squares.obj");
  const { buffers } = rendered(["squares.obj", "--size", "96x54"]);
  for (const name of ["normal", "ao_blurred", "lit"])
    expectEqual(`${name} of a dropped OBJ with its texture has the program's hash`, await hashOf(page, name), buffers[name].hash);
  await after(page, () => drag(page, 40, -10));
  const command = await page.locator("#command").textContent();
  const turned = rendered(command.split(" ").slice(2)).buffers;
  expectEqual("an OBJ's camera is given in its own coordinates", await hashOf(page, "view_depth"), turned.view_depth.hash);
  expect("the camera has turned", turned.view_depth.hash !== buffers.view_depth.hash);
  await after(page, () => drop(page, ["bad.obj"]));
  expectEqual("a bad OBJ is refused in the program's words", await page.locator("#refused").textContent(),
    said(["render", "bad.obj"]).stderr);
  await after(page, () => page.locator("#files").setInputFiles([path.join(scratch, "squares.obj")]));
  const lone = said(["render", "lone.obj", "--size", "96x54"], withLoneObj()).stderr;
  const warnings = (await page.locator("#warnings li").allTextContents()).join("\n");
  expectEqual("what an OBJ lacks is said in the program's words", warnings, lone.replaceAll("lone.obj", "squares.obj"));
  await page.locator("#files").setInputFiles([path.join(scratch, "squares.mtl")]);
  await page.locator("#refused").waitFor({ state: "visible" });
  expect("files without an OBJ are refused", (await page.locator("#refused").textContent()).includes("OBJ"));
}

module.exports = { hashes: checkHashes, value: checkValue, parameters: checkParameters, presets: checkPresets, link: checkLink, book: checkBook, files: checkFiles };
