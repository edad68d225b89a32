// The drawing of a map: poses as coloured cells or points over two components, or frequencies over one.

// Tick marks at round numbers from low to high, each [value, label]: about `targetCount` of them, but at least two.
function ticks(low, high, targetCount) {
  const roughStep = (high - low) / targetCount, power = 10 ** Math.floor(Math.log10(roughStep));
  const step = [10, 5, 2.5, 2, 1].map((k) => k * power).find((candidate, i, candidates) => {
    const smaller = candidates[i + 1] ?? 0;
    return smaller < roughStep * 0.999 && Math.floor(high / candidate + 1e-6) > Math.ceil(low / candidate - 1e-6);
  }) ?? power;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9) + (step / power === 2.5 ? 1 : 0));
  const tickMarks = [];
  for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; k++) tickMarks.push([k * step, formatFixed(k * step, digits)]);
  return tickMarks;
}

// Borders of the cells around ascending values.
function cellBorders(values) {
  if (values.length === 1) return [values[0] - 0.5, values[0] + 0.5];
  const midpoints = values.slice(1).map((value, i) => (value + values[i]) / 2);
  return [2 * values[0] - midpoints[0], ...midpoints, 2 * values.at(-1) - midpoints.at(-1)];
}

class MapChart {
  constructor(canvas, colours) {
    this.canvas = canvas;
    this.colours = colours;
    this.layer = document.createElement("canvas");
  }

  // Lay out the area for the data; the ranges are [low, high].  Where both have the same unit, so has their scale.
  setFrame(xRange, yRange, sameUnit) {
    const width = this.canvas.clientWidth, left = 60, right = 78, top = 30, bottom = 44;
    const maxWidth = width - left - right, aspect = (yRange[1] - yRange[0]) / (xRange[1] - xRange[0]);
    let [plotWidth, plotHeight] = [maxWidth, Math.min(Math.max(0.62 * maxWidth, 200), 460)];
    if (sameUnit && aspect > 0.12 && aspect < 8) {
      plotHeight = Math.min(maxWidth * aspect, 560);
      plotWidth = Math.min(maxWidth, plotHeight / aspect);
    }
    Object.assign(this, { left, top, plotWidth, plotHeight, xRange, yRange, width, height: top + Math.max(plotHeight, 120) + bottom });
    const scale = window.devicePixelRatio || 1;
    for (const surface of [this.canvas, this.layer]) [surface.width, surface.height] = [Math.round(width * scale), Math.round(this.height * scale)];
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

  xPixel(value) {
    return this.left + ((value - this.xRange[0]) / (this.xRange[1] - this.xRange[0])) * this.plotWidth;
  }

  yPixel(value) {
    return this.top + (1 - (value - this.yRange[0]) / (this.yRange[1] - this.yRange[0])) * this.plotHeight;
  }

  drawAxes(xTitle, yTitle) {
    const { pen, left, top, plotWidth, plotHeight } = this;
    Object.assign(pen, { fillStyle: this.ink, strokeStyle: this.ink, lineWidth: 1, textAlign: "center" });
    pen.textBaseline = "top";
    for (const [value, text] of ticks(...this.xRange, Math.max(plotWidth / 80, 3))) {
      const x = this.xPixel(value);
      this.strokeLine([[x, top + plotHeight], [x, top + plotHeight + 4]]);
      pen.fillText(text, x, top + plotHeight + 7);
    }
    pen.fillText(xTitle, left + plotWidth / 2, top + plotHeight + 25);
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const [value, text] of ticks(...this.yRange, Math.max(plotHeight / 45, 2))) {
      this.strokeLine([[left - 4, this.yPixel(value)], [left, this.yPixel(value)]]);
      pen.fillText(text, left - 7, this.yPixel(value));
    }
    pen.save();
    pen.translate(10, top + plotHeight / 2);
    pen.rotate(-Math.PI / 2);
    pen.textAlign = "center";
    pen.fillText(yTitle, 0, 0);
    pen.restore();
    this.strokeLine([[left, top], [left, top + plotHeight], [left + plotWidth, top + plotHeight]]);
  }

  strokeLine(points) {
    const { pen } = this;
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.stroke();
  }

  colour(value, [low, high]) {
    const fraction = Math.min(Math.max((value - low) / (high - low), 0), 1);
    return this.colours[Math.round(fraction * (this.colours.length - 1))];
  }

  // The colour scale beside the data; its pointed ends mean that there are values beyond them.  Its title is above
  // it, away from those of the axes.
  drawColourBar([low, high], title) {
    const { pen, top, plotHeight, colours } = this, left = this.left + this.plotWidth + 14, barWidth = 11, barHeight = plotHeight - 16;
    colours.forEach((colour, i) => {
      pen.fillStyle = colour;
      pen.fillRect(left, top + 8 + barHeight * (1 - (i + 1) / colours.length), barWidth, barHeight / colours.length + 0.6);
    });
    for (const [colour, y, tip] of [[colours.at(-1), top + 8, top], [colours[0], top + plotHeight - 8, top + plotHeight]]) {
      pen.fillStyle = colour;
      pen.fill(new Path2D(`M${left} ${y}L${left + barWidth / 2} ${tip}L${left + barWidth} ${y}`));
    }
    Object.assign(pen, { fillStyle: this.ink, textAlign: "left", textBaseline: "middle" });
    for (const [value, text] of ticks(low, high, Math.max(plotHeight / 45, 2))) {
      const y = top + 8 + barHeight * (1 - (value - low) / (high - low));
      this.strokeLine([[left + barWidth, y], [left + barWidth + 3, y]]);
      pen.fillText(text, left + barWidth + 5, y);
    }
    pen.textBaseline = "bottom";
    pen.fillText(title, left - 4, top - 6);
  }

  // Coloured cells over a grid; those for which `isMarked(i, k)` holds are hatched.
  drawCells(xs, ys, value, limits, isMarked) {
    const { pen } = this, markedArea = new Path2D(), outline = new Path2D();
    const x = cellBorders(xs).map((border) => Math.round(this.xPixel(border) * this.scale) / this.scale);
    const y = cellBorders(ys).map((border) => Math.round(this.yPixel(border) * this.scale) / this.scale);
    const isMarkedCell = (i, k) => i >= 0 && k >= 0 && i < xs.length && k < ys.length && isMarked(i, k);
    let anyMarked = false;
    for (let k = 0; k < ys.length; k++) for (let i = 0; i < xs.length; i++) {
      const cellValue = value(i, k);
      if (Number.isNaN(cellValue)) continue;
      pen.fillStyle = this.colour(cellValue, limits);
      pen.fillRect(x[i], y[k + 1], x[i + 1] - x[i], y[k] - y[k + 1]);
      if (!isMarkedCell(i, k)) continue;
      anyMarked = true;
      markedArea.rect(x[i], y[k + 1], x[i + 1] - x[i], y[k] - y[k + 1]);
      for (const [neighbourMarked, start, end] of [
        [isMarkedCell(i - 1, k), [x[i], y[k]], [x[i], y[k + 1]]], [isMarkedCell(i + 1, k), [x[i + 1], y[k]], [x[i + 1], y[k + 1]]],
        [isMarkedCell(i, k - 1), [x[i], y[k]], [x[i + 1], y[k]]], [isMarkedCell(i, k + 1), [x[i], y[k + 1]], [x[i + 1], y[k + 1]]],
      ]) if (!neighbourMarked) { outline.moveTo(...start); outline.lineTo(...end); }
    }
    if (anyMarked) this.hatch(markedArea, outline);
  }

  // Hatching in black and white: visible on every colour of the scale, and to readers who see no colours.
  hatch(area, outline) {
    const { pen } = this, lines = new Path2D();
    for (let x = this.left - this.plotHeight; x < this.left + this.plotWidth; x += 12) {
      lines.moveTo(x, this.top + this.plotHeight);
      lines.lineTo(x + this.plotHeight, this.top);
    }
    pen.save();
    pen.clip(area);
    Object.assign(pen, { strokeStyle: "#fff", lineWidth: 2.2 });
    pen.stroke(lines);
    Object.assign(pen, { strokeStyle: "#000", lineWidth: 0.9 });
    pen.stroke(lines);
    pen.restore();
    Object.assign(pen, { strokeStyle: "#fff", lineWidth: 3.5 });
    pen.stroke(outline);
    Object.assign(pen, { strokeStyle: "#000", lineWidth: 1.5 });
    pen.stroke(outline);
    pen.strokeStyle = this.ink;
  }

  drawDot(x, y, colour, marked) {
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

  // Copy the drawn data to the canvas, with marks at the cursor and at the pointer.
  drawCursors(cursor, pointer, vertical) {
    const pen = this.canvas.getContext("2d");
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.layer, 0, 0);
    pen.setTransform(this.scale, 0, 0, this.scale, 0, 0);
    for (const [position, radius] of [[pointer, 4], [cursor, 7.5]]) {
      if (!position) continue;
      for (const [colour, lineWidth] of [["#fff", 4.5], ["#000", 2]]) {
        pen.strokeStyle = colour;
        pen.lineWidth = lineWidth;
        pen.beginPath();
        if (vertical) { pen.moveTo(position[0], this.top); pen.lineTo(position[0], this.top + this.plotHeight); }
        pen.moveTo(position[0] + radius, position[1]);
        pen.arc(position[0], position[1], radius, 0, 7);
        pen.stroke();
      }
    }
  }
}
