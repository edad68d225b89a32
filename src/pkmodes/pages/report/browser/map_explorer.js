// What the user does with a map: choose a pose, a mode and a plane, and look for a frequency.

class MapExplorer extends MapPicture {
  constructor(root, data, bytes) {
    const find = (name) => root.querySelector(`[data-part="${name}"]`);
    super(data, bytes, find("canvas"));
    this.find = find;
    this.all = (name) => [...root.querySelectorAll(`[data-part="${name}"]`)];
    this.table = new MapTable(this);
    this.at = this.map.sizes.map(() => 0);
    this.choosePlane();
    const { map } = this, middle = map.sizes.map((size) => Math.floor(size / 2));
    middle.fill(0, 0, map.first); // the first robot of a sweep
    if (data.list) middle[map.first] = 0;
    data.components.forEach((c, k) => { // in the section of the figures
      const at = data.section ? data.section.at[c.name] : undefined, axis = map.axisOf[k];
      if (at === undefined || axis < 0) return;
      const away = data.axes[axis].values.map((value) => Math.abs(value - at));
      middle[axis] = away.indexOf(Math.min(...away));
    });
    this.place = this.nearest(middle);
    if (this.place >= 0) this.at = map.put(middle, this.place);
    this.listen();
    this.refresh();
  }

  // The place with numbers nearest to these, on the chosen values of some axes.
  nearest(at, held = []) {
    const { map } = this;
    return map.least(this.robot, (place) => {
      const other = map.put(at, place);
      if (held.some((k) => other[k] !== at[k])) return Infinity;
      return other.reduce((sum, value, k) => sum + (k < map.first ? 0 : (value - at[k]) ** 2), 0);
    });
  }

  listen() {
    const canvas = this.chart.canvas;
    const on = (name, event, act) => this.all(name).forEach((part) => part.addEventListener(event, () => act(part)));
    on("mode", "change", (input) => { this.mode = Number(input.value); this.refresh(); this.say(); });
    on("axis", "input", (slider) => this.slide(Number(slider.dataset.axis), Number(slider.value)));
    on("plane", "change", () => { this.choosePlane(); this.refresh(); });
    for (const name of ["target", "width"]) on(name, "input", () => this.search());
    on("which", "change", () => this.search());
    canvas.addEventListener("pointermove", (event) => this.point(this.under(event)));
    canvas.addEventListener("pointerleave", () => this.point(-1));
    canvas.addEventListener("click", (event) => {
      canvas.focus({ preventScroll: true });
      this.go(this.under(event));
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
    this.find("rows").addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button) this.go(Number(button.dataset.place));
    });
    document.addEventListener("pkmodes-moved", (event) => this.follow(event.detail.pose));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    let width = 0;
    new ResizeObserver(() => {
      if (!canvas.clientWidth || canvas.clientWidth === width) return;
      width = canvas.clientWidth;
      this.draw();
    }).observe(canvas);
  }

  // Move the cursor, and the machine with it.
  go(place) {
    if (place < 0) return;
    this.place = place;
    this.at = this.map.put(this.at, place);
    this.wanted = null;
    this.refresh();
    this.say();
    document.dispatchEvent(new CustomEvent("pkmodes-pose", { detail: { pose: this.map.pose(place) } }));
  }

  // The machine was moved elsewhere on the page: the cursor goes to the nearest pose.
  follow(pose) {
    const { map, data } = this, size = data.components.map((_, k) => this.span(k));
    const place = map.least(this.robot, (one) => pose.reduce((sum, value, k) => sum + (size[k] ? ((map.component(k, one) - value) / size[k]) ** 2 : 0), 0));
    if (place < 0) return;
    this.place = place;
    this.at = map.put(this.at, place);
    this.wanted = null;
    this.refresh();
  }

  // What the other sliders were set to is kept: they return to it where a pose can be evaluated there again.
  slide(axis, value) {
    const wanted = (this.wanted || this.at).slice();
    wanted[axis] = value;
    if (axis < this.map.first) { // another robot: at the same place if it can be evaluated
      this.at = wanted;
      this.place = this.nearest(wanted);
      if (this.place >= 0) this.at = this.map.put(wanted, this.place);
      this.wanted = wanted;
      this.refresh();
      this.say();
      return;
    }
    const place = this.map.valid(this.robot, this.map.place(wanted)) ? this.map.place(wanted) : this.nearest(wanted, [axis]);
    if (place < 0) {
      this.refresh();
      this.find("status").textContent = `No pose can be evaluated at ${this.label(axis, value)}.`;
      return;
    }
    this.go(place);
    this.wanted = wanted;
    if (this.map.place(wanted) !== place) this.find("status").textContent += " Moved to the nearest pose that can be evaluated.";
  }

  label(axis, value) {
    const one = this.data.axes[axis];
    return `${one.name} ${one.labels[value]} ${one.unit}`.trim();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { map } = this, step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1] }[event.key];
    if (!step) return;
    event.preventDefault();
    let axis = map.first;
    if (!this.data.list) {
      const drawn = this.shown.map((k) => map.axisOf[k]);
      const rest = map.axisOf.filter((k) => map.sizes[k] > 1 && !drawn.includes(k));
      axis = [drawn[0], drawn[1], rest[0]][step[0]];
    }
    if (axis === undefined) return;
    const next = this.at.slice();
    for (next[axis] += step[1]; next[axis] >= 0 && next[axis] < map.sizes[axis]; next[axis] += step[1]) {
      if (map.valid(this.robot, map.place(next))) return this.go(map.place(next));
    }
    this.find("status").textContent = "There is no further pose in this direction.";
  }

  point(place) {
    if (place === this.pointer) return;
    this.pointer = place;
    this.read();
    this.marks();
  }

  search() {
    const { map, data } = this, target = this.find("target").valueAsNumber, width = this.find("width").valueAsNumber;
    this.band = null;
    if (target > 0 && width >= 0) {
      const modes = this.find("which").value === "any" ? data.modes.map((_, k) => k) : [this.mode];
      const [low, high] = [target - width, target + width].map((one) => Math.round(one * map.unit));
      this.band = { modes, low, high, target: target * map.unit };
    }
    this.draw();
    this.read();
    this.table.show();
  }

  refresh() {
    const which = this.find("which");
    which.options[1].textContent = `mode ${this.data.modes[this.mode]}`;
    this.all("axis").forEach((slider) => {
      const axis = Number(slider.dataset.axis), text = this.label(axis, this.at[axis]).slice(this.data.axes[axis].name.length + 1);
      slider.value = this.at[axis];
      slider.setAttribute("aria-valuetext", text);
      slider.closest("label").querySelector("output").textContent = text;
    });
    const key = `${this.robot} ${this.mode} ${which.value}`;
    if (key !== this.searched) {
      this.searched = key;
      this.search();
    } else {
      this.draw();
      this.read();
      this.table.mark();
    }
  }

  words(place) {
    const { data, map } = this, values = map.pose(place);
    const pose = data.components.map((c, k) => `${c.name}\u00a0${fixed(values[k] * c.factor, c.decimals)}\u00a0${c.unit}`).join(", ");
    return data.list ? `${data.axes[map.first].labels[place]}: ${pose}` : pose;
  }

  hertz(mode, place) {
    const one = this.map.frequency(mode, this.robot, place);
    if (Number.isNaN(one)) return "\u2013";
    return Math.abs(one) >= this.data.largest ? "over 1 MHz" : fixed(one, this.data.decimals);
  }

  say() {
    this.find("status").textContent = this.place < 0 ? "" : `${this.words(this.place)}; mode ${this.data.modes[this.mode]}: ${this.hertz(this.mode, this.place)} Hz.`;
  }

  // Pose and frequencies at the pointer, or else at the cursor.
  read() {
    const place = this.pointer >= 0 ? this.pointer : this.place;
    this.find("where").textContent = this.pointer >= 0 ? "At the pointer" : "At the cursor";
    this.find("pose").textContent = place < 0 ? "No pose can be evaluated." : this.words(place);
    this.all("frequency").forEach((cell, mode) => {
      cell.textContent = place < 0 ? "\u2013" : this.hertz(mode, place);
      cell.parentElement.querySelector("[data-part='in']").textContent = this.holds(mode, place) ? "in the band" : "";
    });
  }
}

document.querySelectorAll(".explorer").forEach(async (root) => {
  const data = JSON.parse(root.querySelector("script[type='application/json']").textContent);
  let bytes;
  try {
    bytes = await inflated(data.packed);
  } catch {
    return; // an old browser: the sentence stays that says so
  }
  root.querySelector("[data-part='waiting']").hidden = true;
  root.querySelector("[data-part='all']").hidden = false;
  root.explorer = new MapExplorer(root, data, bytes);
});
