// Chromium for the tests of pages. Ends with 77, which CTest takes for skipped, where Chromium or playwright-core is missing, and names
// it.
"use strict";
const fs = require("node:fs");

const kSkipped = 77;
const program = process.env.CHROMIUM ?? "/usr/bin/chromium";

function skip(what) {
  console.log(`skipped: ${what}`);
  process.exit(kSkipped);
}

// The chromium of playwright-core.
function requiredChromium() {
  try {
    return require("playwright-core").chromium;
  } catch {
    return skip("playwright-core was not found; npm install --prefix build/playwright playwright-core");
  }
}

// Gives a launched browser.
async function launched(args = []) {
  const chromium = requiredChromium();
  if (!fs.existsSync(program)) skip(`${program} was not found; install chromium, or name one in CHROMIUM`);
  return chromium.launch({ executablePath: program, args: ["--no-sandbox", ...args] });
}

module.exports = { launched, skip };
