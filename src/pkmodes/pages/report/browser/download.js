// Buttons under each figure that save it as PNG, drawn from its SVG on a white ground, and its numbers as CSV.

// Pixels of a PNG per unit of an SVG from pkmodes, which is 1/72 inch: 300 per inch, for print.
const PIXELS_PER_UNIT = 300 / 72;
const MAX_NAME_LENGTH = 60;
const TABLE_SELECTOR = 'script[type="application/x-deflated-table"]';

// The colours of the light scheme, whichever is in use: the variables of the first rule for the root.
function lightColours() {
  for (const sheet of document.styleSheets) {
    for (const rule of sheet.cssRules) {
      if (rule.selectorText === ":root") {
        const names = [...rule.style].filter((name) => name.startsWith("--"));
        return names.map((name) => [name, rule.style.getPropertyValue(name).trim()]);
      }
    }
  }
  return [];
}

function fileName(title, suffix) {
  const words = title.normalize("NFKC").toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-");
  const stem = [...words].slice(0, MAX_NAME_LENGTH).join("").replace(/^-+|-+$/g, "");
  return `${stem || "figure"}.${suffix}`;
}

function saveFile(blob, name) {
  const url = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

async function pngBlob(svg) {
  const box = svg.viewBox.baseVal;
  const width = Math.round(box.width * PIXELS_PER_UNIT);
  const height = Math.round(box.height * PIXELS_PER_UNIT);
  const copy = svg.cloneNode(true);
  for (const [name, value] of lightColours()) copy.style.setProperty(name, value);
  copy.style.setProperty("color-scheme", "light");
  copy.style.setProperty("color", "var(--ink)");
  copy.style.setProperty("font-family", "var(--sans)");
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  const text = new XMLSerializer().serializeToString(copy);
  const url = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const image = new Image(width, height);
  image.src = url;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, width, height);
  context.drawImage(image, 0, 0, width, height);
  URL.revokeObjectURL(url);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

// The page holds the table column by column: a cell per line, a space for an empty cell, and an empty line between
// columns.  The byte order mark tells spreadsheets that the text is UTF-8.
async function csvBlob(table) {
  const bytes = Uint8Array.from(atob(table.textContent.trim()), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const text = await new Response(stream).text();
  const columns = text.split("\n\n").map((column) => column.split("\n"));
  const rows = columns[0].map((_, i) => columns.map((column) => (column[i] === " " ? "" : column[i])).join(","));
  return new Blob(["\ufeff", rows.join("\r\n"), "\r\n"], { type: "text/csv;charset=utf-8" });
}

function saveButton(title, format, makeBlob) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = format;
  button.setAttribute("aria-label", `Save ${title} as ${format}`);
  button.addEventListener("click", async () => saveFile(await makeBlob(), fileName(title, format.toLowerCase())));
  return button;
}

for (const figure of document.querySelectorAll("figure")) {
  const svg = figure.querySelector(".plot svg");
  if (!svg) continue;
  const title = svg.querySelector("title").textContent;
  const table = figure.querySelector(TABLE_SELECTOR);
  const bar = document.createElement("p");
  bar.className = "save";
  bar.append("Save as", saveButton(title, "PNG", () => pngBlob(svg)));
  if (table && typeof DecompressionStream === "function") bar.append(saveButton(title, "CSV", () => csvBlob(table)));
  figure.append(bar);
}
