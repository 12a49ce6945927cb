// Joins the lab's modules, its worker and its WebAssembly into one page that opens from the disk.
//   node join_page.cjs PAGE_DIRECTORY BOOK_CSS MODULE_JS OUT
// Of the ES modules of PAGE_DIRECTORY, main.js and what it imports become one script: names that a module declares at its
// top are unlike those of all others, so that the import lines and the word export can go.
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const zlib = require("node:zlib");

const [directory, book_css, module_js, out] = process.argv.slice(2);
const read = (name) => fs.readFileSync(path.join(directory, name), "utf8");
const joined = new Set();

// The text of a module after those of all that it imports.
function withImports(name) {
  if (joined.has(name)) return "";
  joined.add(name);
  let before = "";
  const text = read(name).replace(/^import \{[^}]*\} from "\.\/(.+)";\n/gm, (line, imported) => {
    before += withImports(imported);
    return "";
  });
  return `${before}\n// ---- ${name}\n${text.replace(/^export /gm, "")}`;
}

// Nothing inside a script element may end it.
const inScript = (text) => text.replace(/<(?=\/script|!--)/gi, "\\x3c");
const wasm = zlib.gzipSync(fs.readFileSync(module_js.replace(/\.js$/, ".wasm")), { level: 9 });
const parts = {
  style: fs.readFileSync(book_css, "utf8") + read("lab.css"),
  script: inScript(withImports("main.js")),
  worker: inScript(fs.readFileSync(module_js, "utf8") + "\n" + read("worker.js")),
  module: wasm.toString("base64"),
};
fs.writeFileSync(out, read("lab.html").replace(/<!-- (\w+) -->/g, (mark, part) => parts[part] ?? mark));
