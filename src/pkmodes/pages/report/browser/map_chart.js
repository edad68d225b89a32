// The drawing of a map: places as coloured cells or points over two components, or frequencies over one.

// Round numbers from low to high, about so many, but two at least.
function ticks(low, high, about) {
  const rough = (high - low) / about, power = 10 ** Math.floor(Math.log10(rough));
  const step = [10, 5, 2.5, 2, 1].map((k) => k * power).find((one, i, all) => {
    const next = all[i + 1] ?? 0;
    return next < rough * 0.999 && Math.floor(high / one + 1e-6) > Math.ceil(low / one - 1e-6);
  }) ?? power;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9) + (step / power === 2.5 ? 1 : 0));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; k++) found.push([k * step, fixed(k * step, digits)]);
  return found;
}

// Borders of the cells around ascending values.
function borders(values) {
  if (values.length === 1) return [values[0] - 0.5, values[0] + 0.5];
  const between = values.slice(1).map((value, i) => (value + values[i]) / 2);
  return [2 * values[0] - between[0], ...between, 2 * values.at(-1) - between.at(-1)];
}

class MapChart {
  constructor(canvas, colours) {
    this.canvas = canvas;
    this.colours = colours;
    this.layer = document.createElement("canvas");
  }

  // The space for the data: x and y as [low, high], `same` where both have one unit.
  frame(x, y, same) {
    const width = this.canvas.clientWidth, left = 60, right = 78, top = 30, bottom = 44;
    const inner = width - left - right, ratio = (y[1] - y[0]) / (x[1] - x[0]);
    let [w, h] = [inner, Math.min(Math.max(0.62 * inner, 200), 460)];
    if (same && ratio > 0.12 && ratio < 8) {
      h = Math.min(inner * ratio, 560);
      w = Math.min(inner, h / ratio);
    }
    Object.assign(this, { left, top, w, h, x, y, width, height: top + Math.max(h, 120) + bottom });
    const scale = window.devicePixelRatio || 1;
    for (const one of [this.canvas, this.layer]) [one.width, one.height] = [Math.round(width * scale), Math.round(this.height * scale)];
    this.canvas.style.height = `${this.height}px`;
    this.scale = scale;
    const style = getComputedStyle(this.canvas);
    this.ink = style.color;
    this.paper = style.getPropertyValue("--paper");
    this.line = style.getPropertyValue("--line");
    this.font = `12px ${style.fontFamily}`;
    this.pen = this.layer.getContext("2d");
    this.pen.setTransform(scale, 0, 0, scale, 0, 0);
    this.pen.clearRect(0, 0, width, this.height);
    Object.assign(this.pen, { font: this.font, fillStyle: this.ink, strokeStyle: this.ink, lineWidth: 1 });
  }

  across(value) {
    return this.left + ((value - this.x[0]) / (this.x[1] - this.x[0])) * this.w;
  }

  along(value) {
    return this.top + (1 - (value - this.y[0]) / (this.y[1] - this.y[0])) * this.h;
  }

  axes(xTitle, yTitle) {
    const { pen, left, top, w, h } = this;
    Object.assign(pen, { fillStyle: this.ink, strokeStyle: this.ink, lineWidth: 1, textAlign: "center" });
    pen.textBaseline = "top";
    for (const [value, text] of ticks(...this.x, Math.max(w / 80, 3))) {
      const at = this.across(value);
      this.stroke([[at, top + h], [at, top + h + 4]]);
      pen.fillText(text, at, top + h + 7);
    }
    pen.fillText(xTitle, left + w / 2, top + h + 25);
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const [value, text] of ticks(...this.y, Math.max(h / 45, 2))) {
      this.stroke([[left - 4, this.along(value)], [left, this.along(value)]]);
      pen.fillText(text, left - 7, this.along(value));
    }
    pen.save();
    pen.translate(10, top + h / 2);
    pen.rotate(-Math.PI / 2);
    pen.textAlign = "center";
    pen.fillText(yTitle, 0, 0);
    pen.restore();
    this.stroke([[left, top], [left, top + h], [left + w, top + h]]);
  }

  stroke(points) {
    const { pen } = this;
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.stroke();
  }

  colour(value, [low, high]) {
    const share = Math.min(Math.max((value - low) / (high - low), 0), 1);
    return this.colours[Math.round(share * (this.colours.length - 1))];
  }

  // The scale beside the data, with pointed ends: there are values beyond.  Its title is above it, apart from all axes.
  bar([low, high], title) {
    const { pen, top, h, colours } = this, left = this.left + this.w + 14, wide = 11, tall = h - 16;
    colours.forEach((colour, i) => {
      pen.fillStyle = colour;
      pen.fillRect(left, top + 8 + tall * (1 - (i + 1) / colours.length), wide, tall / colours.length + 0.6);
    });
    for (const [colour, y, tip] of [[colours.at(-1), top + 8, top], [colours[0], top + h - 8, top + h]]) {
      pen.fillStyle = colour;
      pen.fill(new Path2D(`M${left} ${y}L${left + wide / 2} ${tip}L${left + wide} ${y}`));
    }
    Object.assign(pen, { fillStyle: this.ink, textAlign: "left", textBaseline: "middle" });
    for (const [value, text] of ticks(low, high, Math.max(h / 45, 2))) {
      const y = top + 8 + tall * (1 - (value - low) / (high - low));
      this.stroke([[left + wide, y], [left + wide + 3, y]]);
      pen.fillText(text, left + wide + 5, y);
    }
    pen.textBaseline = "bottom";
    pen.fillText(title, left - 4, top - 6);
  }

  // Cells over a grid; `inside` says which are marked.
  cells(xs, ys, value, limits, inside) {
    const { pen } = this, marked = new Path2D(), edge = new Path2D();
    const x = borders(xs).map((one) => Math.round(this.across(one) * this.scale) / this.scale);
    const y = borders(ys).map((one) => Math.round(this.along(one) * this.scale) / this.scale);
    const is = (i, k) => i >= 0 && k >= 0 && i < xs.length && k < ys.length && inside(i, k);
    let some = false;
    for (let k = 0; k < ys.length; k++) for (let i = 0; i < xs.length; i++) {
      const one = value(i, k);
      if (Number.isNaN(one)) continue;
      pen.fillStyle = this.colour(one, limits);
      pen.fillRect(x[i], y[k + 1], x[i + 1] - x[i], y[k] - y[k + 1]);
      if (!is(i, k)) continue;
      some = true;
      marked.rect(x[i], y[k + 1], x[i + 1] - x[i], y[k] - y[k + 1]);
      for (const [other, a, b] of [
        [is(i - 1, k), [x[i], y[k]], [x[i], y[k + 1]]], [is(i + 1, k), [x[i + 1], y[k]], [x[i + 1], y[k + 1]]],
        [is(i, k - 1), [x[i], y[k]], [x[i + 1], y[k]]], [is(i, k + 1), [x[i], y[k + 1]], [x[i + 1], y[k + 1]]],
      ]) if (!other) { edge.moveTo(...a); edge.lineTo(...b); }
    }
    if (some) this.hatch(marked, edge);
  }

  // Black and white lines: they are seen on every colour of the scale, and without colours.
  hatch(area, edge) {
    const { pen } = this, lines = new Path2D();
    for (let x = this.left - this.h; x < this.left + this.w; x += 12) {
      lines.moveTo(x, this.top + this.h);
      lines.lineTo(x + this.h, this.top);
    }
    pen.save();
    pen.clip(area);
    Object.assign(pen, { strokeStyle: "#fff", lineWidth: 2.2 });
    pen.stroke(lines);
    Object.assign(pen, { strokeStyle: "#000", lineWidth: 0.9 });
    pen.stroke(lines);
    pen.restore();
    Object.assign(pen, { strokeStyle: "#fff", lineWidth: 3.5 });
    pen.stroke(edge);
    Object.assign(pen, { strokeStyle: "#000", lineWidth: 1.5 });
    pen.stroke(edge);
    pen.strokeStyle = this.ink;
  }

  dot(x, y, colour, marked) {
    const { pen } = this;
    pen.fillStyle = colour;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1;
    pen.beginPath();
    pen.arc(x, y, 5, 0, 7);
    pen.fill();
    pen.stroke();
    if (!marked) return;
    pen.lineWidth = 2;
    pen.strokeRect(x - 8.5, y - 8.5, 17, 17);
    pen.lineWidth = 1;
  }

  // The data with the marks of the cursor, and of the pointer.
  show(cursor, pointer, vertical) {
    const pen = this.canvas.getContext("2d");
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.layer, 0, 0);
    pen.setTransform(this.scale, 0, 0, this.scale, 0, 0);
    for (const [at, radius] of [[pointer, 4], [cursor, 7.5]]) {
      if (!at) continue;
      for (const [colour, wide] of [["#fff", 4.5], ["#000", 2]]) {
        pen.strokeStyle = colour;
        pen.lineWidth = wide;
        pen.beginPath();
        if (vertical) { pen.moveTo(at[0], this.top); pen.lineTo(at[0], this.top + this.h); }
        pen.moveTo(at[0] + radius, at[1]);
        pen.arc(at[0], at[1], radius, 0, 7);
        pen.stroke();
      }
    }
  }
}
