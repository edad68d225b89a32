// Each figure can be saved: as PNG, drawn from its SVG on white paper, and its numbers as CSV.

// Dots of a PNG per unit of an SVG from pkmodes, which is 1/72 inch: 300 per inch, for print.
const SCALE = 300 / 72;
const LONGEST = 60;
const DEFLATED = 'script[type="application/x-deflated-table"]';

// The light colours of the page, whatever its scheme: the variables of the first rule for the root.
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
  const short = [...words].slice(0, LONGEST).join("").replace(/^-+|-+$/g, "");
  return `${short || "figure"}.${suffix}`;
}

function save(content, name) {
  const address = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

async function asPng(svg) {
  const box = svg.viewBox.baseVal;
  const width = Math.round(box.width * SCALE);
  const height = Math.round(box.height * SCALE);
  const copy = svg.cloneNode(true);
  const colours = lightColours();
  for (const [name, value] of colours) copy.style.setProperty(name, value);
  copy.style.setProperty("color-scheme", "light");
  copy.style.setProperty("color", "var(--ink)");
  copy.style.setProperty("font-family", "var(--sans)");
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  const text = new XMLSerializer().serializeToString(copy);
  const address = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const image = new Image(width, height);
  image.src = address;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, width, height);
  context.drawImage(image, 0, 0, width, height);
  URL.revokeObjectURL(address);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

// The columns of the table are one after the other: cells in lines, a space for an empty one, an empty line between
// them.  A byte order mark lets spreadsheets know that the text is UTF-8.
async function asCsv(data) {
  const bytes = Uint8Array.from(atob(data.textContent.trim()), (one) => one.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const text = await new Response(stream).text();
  const columns = text.split("\n\n").map((column) => column.split("\n"));
  const rows = columns[0].map((_, i) => columns.map((column) => (column[i] === " " ? "" : column[i])).join(","));
  return new Blob(["\ufeff", rows.join("\r\n"), "\r\n"], { type: "text/csv;charset=utf-8" });
}

function button(title, form, make) {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = form;
  made.setAttribute("aria-label", `Save ${title} as ${form}`);
  made.addEventListener("click", async () => save(await make(), fileName(title, form.toLowerCase())));
  return made;
}

for (const figure of document.querySelectorAll("figure")) {
  const svg = figure.querySelector(".plot svg");
  if (!svg) continue;
  const title = svg.querySelector("title").textContent;
  const data = figure.querySelector(DEFLATED);
  const bar = document.createElement("p");
  bar.className = "save";
  bar.append("Save as", button(title, "PNG", () => asPng(svg)));
  if (data && typeof DecompressionStream === "function") bar.append(button(title, "CSV", () => asCsv(data)));
  figure.append(bar);
}
