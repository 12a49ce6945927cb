// Files dropped on the page, or chosen: an OBJ, its materials and its textures, also in folders.

// The files below an entry of a drop, as [{name, file}], names with their folders.
async function filesBelow(entry, folder = "") {
  const name = folder + entry.name;
  if (entry.isFile) return [{ name, file: await new Promise((resolve, reject) => entry.file(resolve, reject)) }];
  const reader = entry.createReader();
  const found = [];
  // A folder is told in parts, until one is empty.
  for (;;) {
    const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (entries.length === 0) return found;
    for (const below of entries) found.push(...await filesBelow(below, `${name}/`));
  }
}

async function filesOfDrop(transfer) {
  // Before anything is waited for: afterwards the items are gone.
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (entries.length === 0) return [...transfer.files].map((file) => ({ name: file.name, file }));
  return (await Promise.all(entries.map((entry) => filesBelow(entry)))).flat();
}

// `dropped(files, objs)` is called with [{name, bytes}] and the names of the OBJ files among them.
export function takeFiles(input, dropped) {
  const take = async (found) => {
    const files = await Promise.all(found.map(async ({ name, file }) => ({ name, bytes: await file.arrayBuffer() })));
    await dropped(files, files.map(({ name }) => name).filter((name) => /\.obj$/i.test(name)).sort());
  };
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dragging");
  });
  for (const end of ["dragleave", "drop"]) document.addEventListener(end, () => document.body.classList.remove("dragging"));
  document.addEventListener("drop", async (event) => {
    event.preventDefault();
    take(await filesOfDrop(event.dataTransfer));
  });
  input.addEventListener("change", () => take([...input.files].map((file) => ({ name: file.name, file }))));
}
