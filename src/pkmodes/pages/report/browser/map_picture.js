// The picture of a map: which components it shows, what is where, and which pose is under the pointer.

function extent(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
}

class MapPicture {
  constructor(data, bytes, canvas) {
    this.data = data;
    this.map = new MapValues(data, bytes);
    this.chart = new MapChart(canvas, data.colours);
    this.ends = this.map.reached();
    this.mode = 0;
    this.band = null; // the frequencies that are looked for
    this.place = this.pointer = -1;
  }

  // Which components are drawn: two that vary, or one and the frequency.
  choosePlane() {
    const { data, map } = this, select = this.find("plane");
    const several = data.components.map((_, k) => k).filter((k) => {
      const values = data.list ? data.list[k] : data.axes[map.axisOf[k]].values;
      return values.some((value) => value !== values[0]);
    });
    const names = select ? select.value.split(" ") : [];
    this.shown = names.length ? names.map((name) => data.components.findIndex((c) => c.name === name)) : several.slice(0, 2);
    this.flat = this.shown.length > 1;
    this.turn();
  }

  // As in the figures of the page: in their plane as they draw it, in others the clearly longer component upright.
  turn() {
    const { data, shown } = this;
    if (!this.flat) return;
    shown.sort((a, b) => a - b);
    const [a, b] = shown.map((k) => data.components[k]), sides = data.section ? data.section.sides : [];
    const drawn = sides.includes(a.name) && sides.includes(b.name);
    if (drawn ? sides[0] === b.name : a.unit === b.unit && this.span(shown[0]) > data.longer * this.span(shown[1])) shown.reverse();
  }

  // Extent of a component [SI].
  span(k) {
    const { data, map } = this;
    const [low, high] = data.list ? this.listed(k) : this.ends[map.axisOf[k]].map((i) => data.axes[map.axisOf[k]].values[i]);
    return high - low;
  }

  // Least and largest value of a component in a list, of the poses that can be evaluated.
  listed(k) {
    return extent(this.data.list[k].filter((_, place) => this.map.valid(this.robot, place)));
  }

  // The place under the pointer, -1 without one.
  under(event) {
    const box = this.chart.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    if (this.cells) {
      const { xs, ys, place } = this.cells, { chart } = this;
      const at = (values, one, inside) => borders(values).findIndex((edge, i, all) => i < values.length && inside(one, edge, all[i + 1]));
      const i = at(xs, px, (one, a, b) => one >= chart.across(a) && one < chart.across(b));
      const k = at(ys, py, (one, a, b) => one <= chart.along(a) && one > chart.along(b));
      return i >= 0 && k >= 0 && this.map.valid(this.robot, place(i, k)) ? place(i, k) : -1;
    }
    // Of points on each other, the one after the cursor.
    const near = [];
    let least = 24 ** 2;
    for (const [place, x, y] of this.points) {
      const away = this.flat ? (x - px) ** 2 + (y - py) ** 2 : (x - px) ** 2;
      if (away < least - 1) near.length = 0;
      if (away <= least) { near.push(place); least = Math.min(least, away); }
    }
    const next = near.indexOf(this.place) + 1;
    return near.length ? near[next % near.length] : -1;
  }

  // Whether a mode lies in the band that is looked for, and whether any of those that are searched does.
  holds(mode, place) {
    const { band } = this;
    if (!band || place < 0 || !band.modes.includes(mode)) return false;
    const number = this.map.number(mode, this.robot, place);
    return number !== MISSING && number >= band.low && number <= band.high;
  }

  inside(place) {
    return !!this.band && this.band.modes.some((mode) => this.holds(mode, place));
  }

  draw() {
    const { data, map, chart, shown } = this, robot = this.robot, limits = data.limits[this.mode];
    if (!chart.canvas.clientWidth) return;
    this.cells = null;
    this.points = [];
    const name = (k) => `${data.components[k].name} [${data.components[k].unit}]`;
    const values = (k) => data.axes[map.axisOf[k]].values.map((one) => one * data.components[k].factor);
    const colours = () => chart.bar(limits, "f [Hz]");
    if (this.flat && !data.list) {
      const [h, v] = shown.map((k) => map.axisOf[k]), at = this.at.slice();
      const [[left, right], [bottom, top]] = [this.ends[h], this.ends[v]];
      const xs = values(shown[0]).slice(left, right + 1), ys = values(shown[1]).slice(bottom, top + 1);
      const place = (i, k) => { at[h] = left + i; at[v] = bottom + k; return map.place(at); };
      const ends = (all) => [borders(all)[0], borders(all).at(-1)];
      chart.frame(ends(xs), ends(ys), data.components[shown[0]].unit === data.components[shown[1]].unit);
      this.cells = { xs, ys, place };
      chart.cells(xs, ys, (i, k) => map.frequency(this.mode, robot, place(i, k)), limits, (i, k) => this.inside(place(i, k)));
      chart.axes(name(shown[0]), name(shown[1]));
      colours();
    } else if (this.flat) {
      const xs = data.list[shown[0]].map((one) => one * data.components[shown[0]].factor);
      const ys = data.list[shown[1]].map((one) => one * data.components[shown[1]].factor);
      const ends = (k) => {
        const [a, b] = this.listed(k), { factor } = data.components[k], half = 0.06 * (b - a) || 0.5 / factor;
        return [factor * (a - half), factor * (b + half)];
      };
      chart.frame(ends(shown[0]), ends(shown[1]), data.components[shown[0]].unit === data.components[shown[1]].unit);
      xs.forEach((x, place) => {
        const one = map.frequency(this.mode, robot, place);
        if (Number.isNaN(one)) return;
        this.points.push([place, chart.across(x), chart.along(ys[place])]);
        chart.dot(chart.across(x), chart.along(ys[place]), chart.colour(one, limits), this.inside(place));
      });
      chart.axes(name(shown[0]), name(shown[1]));
      colours();
    } else {
      this.curves(shown[0], robot);
    }
    this.marks();
  }

  // Frequencies of all modes over one component, or over the number in a list.
  curves(k, robot) {
    const { data, map, chart, band } = this, places = Array.from({ length: map.places }, (_, place) => place);
    const xs = places.map((place) => (k === undefined ? place + 1 : map.component(k, place) * data.components[k].factor));
    const order = places.slice().sort((a, b) => xs[a] - xs[b]), [low, high] = extent(data.limits.flat()), pad = 0.06 * (high - low);
    const [left, right] = extent(xs);
    chart.frame([left, right > left ? right : left + 1], [Math.max(low - pad, Math.min(low, 0)), high + pad], false);
    const { pen } = chart;
    pen.save();
    pen.clip(new Path2D(`M${chart.left - 9} ${chart.top}h${chart.w + 18}v${chart.h}h${-chart.w - 18}Z`));
    if (band) {
      const [top, bottom] = [band.high, band.low].map((one) => chart.along(one / map.unit)), area = new Path2D();
      area.rect(chart.left, top, chart.w, bottom - top);
      pen.globalAlpha = 0.35;
      chart.hatch(area, area);
      pen.globalAlpha = 1;
    }
    data.modes.forEach((_, mode) => {
      const own = mode === this.mode;
      pen.lineWidth = own ? 2.5 : 1;
      pen.globalAlpha = own ? 1 : 0.55;
      pen.beginPath();
      let begun = false;
      for (const place of order) {
        const one = map.frequency(mode, robot, place);
        if (Number.isNaN(one)) { begun = false; continue; }
        const [x, y] = [chart.across(xs[place]), chart.along(one)];
        if (begun) pen.lineTo(x, y); else pen.moveTo(x, y);
        begun = true;
        if (own) this.points.push([place, x, y]);
      }
      pen.stroke();
    });
    pen.globalAlpha = 1;
    for (const [place, x] of this.points) data.modes.forEach((_, mode) => {
      if (this.holds(mode, place)) chart.dot(x, chart.along(map.frequency(mode, robot, place)), chart.paper, false);
    });
    pen.restore();
    Object.assign(pen, { fillStyle: chart.ink, strokeStyle: chart.ink, lineWidth: 1 });
    chart.axes(k === undefined ? "number in the list" : `${data.components[k].name} [${data.components[k].unit}]`, "f [Hz]");
    Object.assign(pen, { textAlign: "left", textBaseline: "middle" });
    const last = order.findLast((place) => map.valid(robot, place));
    if (last === undefined) return;
    let above = Infinity; // labels do not cover each other
    data.modes.forEach((number, mode) => {
      const y = Math.min(Math.max(chart.along(map.frequency(mode, robot, last)), chart.top + 6), above - 14);
      if (Number.isNaN(y)) return;
      above = y;
      pen.font = `${mode === this.mode ? "bold " : ""}${chart.font}`;
      pen.fillText(`mode ${number}`, chart.left + chart.w + 12, y);
    });
  }

  marks() {
    const { chart } = this, spot = (place) => {
      if (place < 0) return null;
      const point = this.points.find((one) => one[0] === place);
      if (point) return point.slice(1);
      if (!this.flat) return null;
      return [chart.across(this.value(0, place)), chart.along(this.value(1, place))];
    };
    if (chart.pen) chart.show(spot(this.place), spot(this.pointer), !this.flat);
  }

  value(i, place) {
    const k = this.shown[i];
    return this.map.component(k, place) * this.data.components[k].factor;
  }

  get robot() {
    return this.map.robot(this.at);
  }
}
