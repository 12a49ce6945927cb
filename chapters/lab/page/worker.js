// What runs beside the page: the WebAssembly module, its files, and copies of its buffers. The module's own script, which
// defines labModule, stands before this one. Every message has a number, and is answered under it:
//   {id, start: bytes}             the module's bytes, gzipped        -> {id}
//   {id, files: [{name, bytes}]}   files dropped on the page          -> {id}
//   {id, ask: request}             as chapters/lab/lab.h says         -> {id, reply, buffers: {name: {size, components, values}}}
// and where that fails: {id, failure: message}.
"use strict";

let lab = null;
let drops = 0;

async function start(bytes) {
  const unzipped = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
  lab = await labModule({ wasmBinary: await unzipped.arrayBuffer() });
}

// The files of each drop get a directory of their own, and paths start there: messages name a file as it was dropped.
function keepFiles(files) {
  const root = `/dropped_${++drops}`;
  lab.FS.mkdir(root);
  lab.FS.chdir(root);
  for (const { name, bytes } of files) {
    const folders = name.split("/").slice(0, -1);
    for (let depth = 1; depth <= folders.length; ++depth) {
      const folder = folders.slice(0, depth).join("/");
      if (!lab.FS.analyzePath(folder).exists) lab.FS.mkdir(folder);
    }
    lab.FS.writeFile(name, new Uint8Array(bytes));
  }
}

// Rows without their padding, one plane after the other.
function copyOf({ shape, stride, planes }) {
  const [height, width, components = 1] = shape;
  const values = new Float32Array(width * height * components);
  planes.forEach((address, plane) => {
    const first = address / Float32Array.BYTES_PER_ELEMENT;
    for (let y = 0; y < height; ++y) {
      const row = first + y * stride;
      values.set(lab.HEAPF32.subarray(row, row + width), (plane * height + y) * width);
    }
  });
  return { width, height, components, values };
}

function answer(request) {
  const reply = JSON.parse(lab.ccall("lab_reply", "string", ["string"], [JSON.stringify(request)]));
  const buffers = {};
  for (const [name, told] of Object.entries(reply.buffers ?? {})) {
    if (told.shape[0] * told.shape[1] > 0) buffers[name] = copyOf(told);
  }
  return { reply, buffers };
}

self.onmessage = async ({ data: { id, start: bytes, files, ask } }) => {
  try {
    if (bytes !== undefined) await start(bytes);
    if (files !== undefined) keepFiles(files);
    const { reply, buffers } = ask === undefined ? {} : answer(ask);
    const moved = Object.values(buffers ?? {}).map((buffer) => buffer.values.buffer);
    self.postMessage({ id, reply, buffers }, moved);
  } catch (error) {
    self.postMessage({ id, failure: String(error?.message ?? error) });
  }
};
