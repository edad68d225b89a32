// The picture of a map: the components that it shows, the poses drawn over them, and the pose under the pointer.

function rangeOf(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
}

class MapPicture {
  constructor(data, bytes, canvas) {
    this.data = data;
    this.map = new MapValues(data, bytes);
    this.chart = new MapChart(canvas, data.colours);
    this.axisRanges = this.map.evaluatedRanges();
    this.mode = 0;
    this.band = null; // the range of frequencies that the user searches for
    this.poseIndex = this.pointerPose = -1;
  }

  // Choose the components to draw: two that vary, or one, over which the frequencies are drawn.
  chooseComponents() {
    const { data, map } = this, select = this.find("plane");
    const varying = data.components.map((_, k) => k).filter((k) => {
      const values = data.list ? data.list[k] : data.axes[map.axisOf[k]].values;
      return values.some((value) => value !== values[0]);
    });
    const names = select ? select.value.split(" ") : [];
    const indexOf = (name) => data.components.findIndex((c) => c.name === name);
    this.drawn = names.length ? names.map(indexOf) : varying.slice(0, 2);
    this.isPlane = this.drawn.length > 1;
    this.orderDrawnComponents();
  }

  // Choose which component is horizontal: in the plane of the page's figures as they have it, in another plane so
  // that the clearly longer component is vertical.
  orderDrawnComponents() {
    const { data, drawn } = this;
    if (!this.isPlane) return;
    drawn.sort((a, b) => a - b);
    const [first, second] = drawn.map((k) => data.components[k]), sides = data.section ? data.section.sides : [];
    const inSection = sides.includes(first.name) && sides.includes(second.name);
    const firstIsLonger = first.unit === second.unit && this.span(drawn[0]) > data.longer * this.span(drawn[1]);
    if (inSection ? sides[0] === second.name : firstIsLonger) drawn.reverse();
  }

  // Extent of a component [SI].
  span(k) {
    const { data, map } = this;
    const axis = map.axisOf[k];
    const [low, high] = data.list ? this.listRange(k) : this.axisRanges[axis].map((i) => data.axes[axis].values[i]);
    return high - low;
  }

  // Smallest and largest value of a component over the poses of a list that can be evaluated.
  listRange(k) {
    return rangeOf(this.data.list[k].filter((_, poseIndex) => this.map.isValid(this.robotIndex, poseIndex)));
  }

  // Index of the pose under the pointer, -1 without one.
  poseAtPointer(event) {
    const box = this.chart.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    if (this.cells) {
      const { xs, ys, poseAtCell } = this.cells, { chart } = this;
      const findCell = (values, pixel, isInside) => cellBorders(values).findIndex(
        (edge, i, edges) => i < values.length && isInside(pixel, edge, edges[i + 1]),
      );
      const column = findCell(xs, px, (pixel, a, b) => pixel >= chart.xPixel(a) && pixel < chart.xPixel(b));
      const row = findCell(ys, py, (pixel, a, b) => pixel <= chart.yPixel(a) && pixel > chart.yPixel(b));
      const poseIndex = column >= 0 && row >= 0 ? poseAtCell(column, row) : -1;
      return poseIndex >= 0 && this.map.isValid(this.robotIndex, poseIndex) ? poseIndex : -1;
    }
    // Where points coincide, repeated clicks go through them: the next one after the cursor.
    const candidates = [];
    let shortest = 24 ** 2;
    for (const [poseIndex, x, y] of this.points) {
      const distance = this.isPlane ? (x - px) ** 2 + (y - py) ** 2 : (x - px) ** 2;
      if (distance < shortest - 1) candidates.length = 0;
      if (distance <= shortest) { candidates.push(poseIndex); shortest = Math.min(shortest, distance); }
    }
    const next = candidates.indexOf(this.poseIndex) + 1;
    return candidates.length ? candidates[next % candidates.length] : -1;
  }

  // Whether a mode is searched for and lies in the band; `anyModeInBand`: whether any mode does.
  inBand(mode, poseIndex) {
    const { band } = this;
    if (!band || poseIndex < 0 || !band.modes.includes(mode)) return false;
    const frequency = this.map.scaledFrequency(mode, this.robotIndex, poseIndex);
    return frequency !== MISSING && frequency >= band.low && frequency <= band.high;
  }

  anyModeInBand(poseIndex) {
    return !!this.band && this.band.modes.some((mode) => this.inBand(mode, poseIndex));
  }

  draw() {
    const { data, map, chart, drawn } = this, robotIndex = this.robotIndex, limits = data.limits[this.mode];
    if (!chart.canvas.clientWidth) return;
    this.cells = null;
    this.points = [];
    const axisTitle = (k) => `${data.components[k].name} [${data.components[k].unit}]`;
    const values = (k) => data.axes[map.axisOf[k]].values.map((value) => value * data.components[k].factor);
    const drawColourBar = () => chart.drawColourBar(limits, "f [Hz]");
    if (this.isPlane && !data.list) {
      const [xAxis, yAxis] = drawn.map((k) => map.axisOf[k]), indices = this.indices.slice();
      const [[left, right], [bottom, top]] = [this.axisRanges[xAxis], this.axisRanges[yAxis]];
      const xs = values(drawn[0]).slice(left, right + 1), ys = values(drawn[1]).slice(bottom, top + 1);
      const poseAtCell = (i, k) => { indices[xAxis] = left + i; indices[yAxis] = bottom + k; return map.poseIndex(indices); };
      const outerBorders = (centres) => [cellBorders(centres)[0], cellBorders(centres).at(-1)];
      chart.setFrame(outerBorders(xs), outerBorders(ys), data.components[drawn[0]].unit === data.components[drawn[1]].unit);
      this.cells = { xs, ys, poseAtCell };
      const frequencyAt = (i, k) => map.frequency(this.mode, robotIndex, poseAtCell(i, k));
      chart.drawCells(xs, ys, frequencyAt, limits, (i, k) => this.anyModeInBand(poseAtCell(i, k)));
      chart.drawAxes(axisTitle(drawn[0]), axisTitle(drawn[1]));
      drawColourBar();
    } else if (this.isPlane) {
      const xs = data.list[drawn[0]].map((value) => value * data.components[drawn[0]].factor);
      const ys = data.list[drawn[1]].map((value) => value * data.components[drawn[1]].factor);
      const paddedRange = (k) => {
        const [low, high] = this.listRange(k), { factor } = data.components[k], margin = 0.06 * (high - low) || 0.5 / factor;
        return [factor * (low - margin), factor * (high + margin)];
      };
      chart.setFrame(paddedRange(drawn[0]), paddedRange(drawn[1]), data.components[drawn[0]].unit === data.components[drawn[1]].unit);
      xs.forEach((x, poseIndex) => {
        const frequency = map.frequency(this.mode, robotIndex, poseIndex);
        if (Number.isNaN(frequency)) return;
        this.points.push([poseIndex, chart.xPixel(x), chart.yPixel(ys[poseIndex])]);
        chart.drawDot(chart.xPixel(x), chart.yPixel(ys[poseIndex]), chart.colour(frequency, limits), this.anyModeInBand(poseIndex));
      });
      chart.drawAxes(axisTitle(drawn[0]), axisTitle(drawn[1]));
      drawColourBar();
    } else {
      this.drawCurves(drawn[0], robotIndex);
    }
    this.drawMarks();
  }

  // Frequencies of all modes over component k, or over the position of each pose in a list if k is undefined.
  drawCurves(k, robotIndex) {
    const { data, map, chart, band } = this, poses = Array.from({ length: map.poseCount }, (_, poseIndex) => poseIndex);
    const xs = poses.map((poseIndex) => (k === undefined ? poseIndex + 1 : map.componentAt(k, poseIndex) * data.components[k].factor));
    const order = poses.slice().sort((a, b) => xs[a] - xs[b]), [low, high] = rangeOf(data.limits.flat()), pad = 0.06 * (high - low);
    const [left, right] = rangeOf(xs);
    chart.setFrame([left, right > left ? right : left + 1], [Math.max(low - pad, Math.min(low, 0)), high + pad], false);
    const { pen } = chart;
    pen.save();
    pen.clip(new Path2D(`M${chart.left - 9} ${chart.top}h${chart.plotWidth + 18}v${chart.plotHeight}h${-chart.plotWidth - 18}Z`));
    if (band) {
      const [top, bottom] = [band.high, band.low].map((frequency) => chart.yPixel(frequency / map.unitsPerHertz)), area = new Path2D();
      area.rect(chart.left, top, chart.plotWidth, bottom - top);
      pen.globalAlpha = 0.35;
      chart.hatch(area, area);
      pen.globalAlpha = 1;
    }
    data.modes.forEach((_, mode) => {
      const isChosen = mode === this.mode;
      pen.lineWidth = isChosen ? 2.5 : 1;
      pen.globalAlpha = isChosen ? 1 : 0.55;
      pen.beginPath();
      let penDown = false;
      for (const poseIndex of order) {
        const frequency = map.frequency(mode, robotIndex, poseIndex);
        if (Number.isNaN(frequency)) { penDown = false; continue; }
        const [x, y] = [chart.xPixel(xs[poseIndex]), chart.yPixel(frequency)];
        if (penDown) pen.lineTo(x, y); else pen.moveTo(x, y);
        penDown = true;
        if (isChosen) this.points.push([poseIndex, x, y]);
      }
      pen.stroke();
    });
    pen.globalAlpha = 1;
    for (const [poseIndex, x] of this.points) data.modes.forEach((_, mode) => {
      if (this.inBand(mode, poseIndex)) chart.drawDot(x, chart.yPixel(map.frequency(mode, robotIndex, poseIndex)), chart.paper, false);
    });
    pen.restore();
    Object.assign(pen, { fillStyle: chart.ink, strokeStyle: chart.ink, lineWidth: 1 });
    chart.drawAxes(k === undefined ? "number in the list" : `${data.components[k].name} [${data.components[k].unit}]`, "f [Hz]");
    Object.assign(pen, { textAlign: "left", textBaseline: "middle" });
    const lastPose = order.findLast((poseIndex) => map.isValid(robotIndex, poseIndex));
    if (lastPose === undefined) return;
    let lowestFreeY = Infinity; // labels do not cover each other
    data.modes.forEach((number, mode) => {
      const y = Math.min(Math.max(chart.yPixel(map.frequency(mode, robotIndex, lastPose)), chart.top + 6), lowestFreeY - 14);
      if (Number.isNaN(y)) return;
      lowestFreeY = y;
      pen.font = `${mode === this.mode ? "bold " : ""}${chart.font}`;
      pen.fillText(`mode ${number}`, chart.left + chart.plotWidth + 12, y);
    });
  }

  drawMarks() {
    const { chart } = this, positionOf = (poseIndex) => {
      if (poseIndex < 0) return null;
      const point = this.points.find((candidate) => candidate[0] === poseIndex);
      if (point) return point.slice(1);
      if (!this.isPlane) return null;
      return [chart.xPixel(this.drawnValue(0, poseIndex)), chart.yPixel(this.drawnValue(1, poseIndex))];
    };
    if (chart.pen) chart.drawCursors(positionOf(this.poseIndex), positionOf(this.pointerPose), !this.isPlane);
  }

  drawnValue(i, poseIndex) {
    const k = this.drawn[i];
    return this.map.componentAt(k, poseIndex) * this.data.components[k].factor;
  }

  get robotIndex() {
    return this.map.robotIndex(this.indices);
  }
}
