// The lab's page as somebody uses it, in Chromium. CTest runs one group of checks after the other (lab_hashes, lab_views, ...);
// by hand, after ./crevice.sh web:
//
//     npm install --prefix build/playwright playwright-core
//     NODE_PATH=build/playwright/node_modules node tests/pages/lab_test.cjs GROUP build/wasm/lab.html build/release/crevice [SCREENSHOTS]
//
// Ends with 77, which CTest takes for skipped, where the page, Chromium or playwright-core is missing, and names it.
"use strict";
const fs = require("node:fs");
const { launched, skip } = require("./chromium.cjs");

const [group, lab_page] = process.argv.slice(2);

async function main() {
  if (lab_page === undefined || !fs.existsSync(lab_page)) skip(`${lab_page} was not found; ./crevice.sh web makes it`);
  const browser = await launched();
  const { failures, scratch } = require("./lab/page.cjs");
  const groups = { ...require("./lab/bits.cjs"), ...require("./lab/use.cjs"), ...require("./lab/answers.cjs") };
  if (!(group in groups)) {
    console.error(`give one of ${Object.keys(groups).join(", ")}`);
    process.exit(2);
  }
  try {
    await groups[group](browser);
  } catch (error) {
    failures.push(String(error.stack ?? error));
  }
  await browser.close();
  fs.rmSync(scratch, { recursive: true });
  for (const failure of failures) console.log(failure);
  console.log(`lab ${group}: ${failures.length} failures`);
  process.exit(failures.length === 0 ? 0 : 1);
}

main();
