// The controls of a map: to choose a pose, a mode and a plane, and to search for a frequency.

class MapExplorer extends MapPicture {
  constructor(root, data, bytes) {
    const find = (name) => root.querySelector(`[data-part="${name}"]`);
    super(data, bytes, find("canvas"));
    this.find = find;
    this.findAll = (name) => [...root.querySelectorAll(`[data-part="${name}"]`)];
    this.table = new MapTable(this);
    this.indices = this.map.sizes.map(() => 0);
    this.chooseComponents();
    const { map } = this, startIndices = map.sizes.map((size) => Math.floor(size / 2));
    startIndices.fill(0, 0, map.firstPoseAxis); // the first robot of a sweep
    if (data.list) startIndices[map.firstPoseAxis] = 0;
    data.components.forEach((c, k) => { // begin in the section of the figures
      const sectionValue = data.section ? data.section.at[c.name] : undefined, axis = map.axisOf[k];
      if (sectionValue === undefined || axis < 0) return;
      const distances = data.axes[axis].values.map((value) => Math.abs(value - sectionValue));
      startIndices[axis] = distances.indexOf(Math.min(...distances));
    });
    this.poseIndex = this.nearest(startIndices);
    if (this.poseIndex >= 0) this.indices = map.withPose(startIndices, this.poseIndex);
    this.addListeners();
    this.refresh();
    this.moveMachine();
  }

  // Index of the evaluable pose whose indices are nearest to those given, and equal to them on `fixedAxes`.
  nearest(indices, fixedAxes = []) {
    const { map } = this;
    return map.nearestPose(this.robotIndex, (poseIndex) => {
      const candidate = map.withPose(indices, poseIndex);
      if (fixedAxes.some((k) => candidate[k] !== indices[k])) return Infinity;
      return candidate.reduce((sum, value, k) => sum + (k < map.firstPoseAxis ? 0 : (value - indices[k]) ** 2), 0);
    });
  }

  addListeners() {
    const canvas = this.chart.canvas;
    const on = (name, event, handler) => this.findAll(name).forEach(
      (part) => part.addEventListener(event, () => handler(part)),
    );
    on("mode", "change", (input) => { this.mode = Number(input.value); this.refresh(); this.announcePose(); });
    on("axis", "input", (slider) => this.moveSlider(Number(slider.dataset.axis), Number(slider.value)));
    on("plane", "change", () => { this.chooseComponents(); this.refresh(); });
    for (const name of ["target", "width"]) on(name, "input", () => this.searchBand());
    on("which", "change", () => this.searchBand());
    canvas.addEventListener("pointermove", (event) => this.setPointer(this.poseAtPointer(event)));
    canvas.addEventListener("pointerleave", () => this.setPointer(-1));
    canvas.addEventListener("click", (event) => {
      canvas.focus({ preventScroll: true });
      this.moveTo(this.poseAtPointer(event));
    });
    canvas.addEventListener("keydown", (event) => this.handleKey(event));
    this.find("rows").addEventListener("click", (event) => {
      const button = event.target.closest("button");
      if (button) this.moveTo(Number(button.dataset.poseIndex));
    });
    document.addEventListener("pkmodes-viewer", () => this.moveMachine());
    document.addEventListener("pkmodes-moved", (event) => this.followMachine(event.detail.pose));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    let width = 0;
    new ResizeObserver(() => {
      if (!canvas.clientWidth || canvas.clientWidth === width) return;
      width = canvas.clientWidth;
      this.draw();
    }).observe(canvas);
  }

  // Move the cursor, and tell the machine viewer of the page to follow.
  moveTo(poseIndex) {
    if (poseIndex < 0) return;
    this.poseIndex = poseIndex;
    this.indices = this.map.withPose(this.indices, poseIndex);
    this.requestedIndices = null;
    this.refresh();
    this.announcePose();
    this.moveMachine();
  }

  moveMachine() {
    if (this.poseIndex < 0) return;
    document.dispatchEvent(new CustomEvent("pkmodes-pose", { detail: { pose: this.map.pose(this.poseIndex) } }));
  }

  // The machine was moved elsewhere on the page: the cursor goes to the nearest pose.
  followMachine(pose) {
    const { map, data } = this, spans = data.components.map((_, k) => this.span(k));
    const distance = (candidate) => pose.reduce(
      (sum, value, k) => sum + (spans[k] ? ((map.componentAt(k, candidate) - value) / spans[k]) ** 2 : 0), 0,
    );
    const poseIndex = map.nearestPose(this.robotIndex, distance);
    if (poseIndex < 0) return;
    this.poseIndex = poseIndex;
    this.indices = map.withPose(this.indices, poseIndex);
    this.requestedIndices = null;
    this.refresh();
  }

  // Move a slider.  Where no pose can be evaluated, the other sliders give way; what they were set to is kept in
  // `requestedIndices`, and they return to it as soon as a pose can be evaluated there.
  moveSlider(axis, value) {
    const requested = (this.requestedIndices || this.indices).slice();
    requested[axis] = value;
    if (axis < this.map.firstPoseAxis) { // another robot: at the same pose if it can be evaluated
      this.indices = requested;
      this.poseIndex = this.nearest(requested);
      if (this.poseIndex >= 0) this.indices = this.map.withPose(requested, this.poseIndex);
      this.requestedIndices = requested;
      this.refresh();
      this.announcePose();
      return;
    }
    const isValid = this.map.isValid(this.robotIndex, this.map.poseIndex(requested));
    const poseIndex = isValid ? this.map.poseIndex(requested) : this.nearest(requested, [axis]);
    if (poseIndex < 0) {
      this.refresh();
      this.find("status").textContent = `No pose can be evaluated at ${this.axisLabel(axis, value)}.`;
      return;
    }
    this.moveTo(poseIndex);
    this.requestedIndices = requested;
    if (this.map.poseIndex(requested) !== poseIndex) this.find("status").textContent += " Moved to the nearest pose that can be evaluated.";
  }

  axisLabel(axis, value) {
    const axisData = this.data.axes[axis];
    return `${axisData.name} ${axisData.labels[value]} ${axisData.unit}`.trim();
  }

  handleKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    // Horizontal, vertical or further axis, and direction.
    const { map } = this, moves = {
      ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1],
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    let axis = map.firstPoseAxis;
    if (!this.data.list) {
      const drawnAxes = this.drawn.map((k) => map.axisOf[k]);
      const furtherAxes = map.axisOf.filter((k) => map.sizes[k] > 1 && !drawnAxes.includes(k));
      axis = [drawnAxes[0], drawnAxes[1], furtherAxes[0]][move[0]];
    }
    if (axis === undefined) return;
    const indices = this.indices.slice();
    for (indices[axis] += move[1]; indices[axis] >= 0 && indices[axis] < map.sizes[axis]; indices[axis] += move[1]) {
      if (map.isValid(this.robotIndex, map.poseIndex(indices))) return this.moveTo(map.poseIndex(indices));
    }
    this.find("status").textContent = "There is no further pose in this direction.";
  }

  setPointer(poseIndex) {
    if (poseIndex === this.pointerPose) return;
    this.pointerPose = poseIndex;
    this.showReadout();
    this.drawMarks();
  }

  searchBand() {
    const { map, data } = this, target = this.find("target").valueAsNumber, width = this.find("width").valueAsNumber;
    this.band = null;
    if (target > 0 && width >= 0) {
      const modes = this.find("which").value === "any" ? data.modes.map((_, k) => k) : [this.mode];
      const [low, high] = [target - width, target + width].map((frequency) => Math.round(frequency * map.unitsPerHertz));
      this.band = { modes, low, high, target: target * map.unitsPerHertz };
    }
    this.draw();
    this.showReadout();
    this.table.show();
  }

  refresh() {
    const which = this.find("which");
    which.options[1].textContent = `mode ${this.data.modes[this.mode]}`;
    this.findAll("axis").forEach((slider) => {
      const axis = Number(slider.dataset.axis), label = this.axisLabel(axis, this.indices[axis]);
      const text = label.slice(this.data.axes[axis].name.length + 1);
      slider.value = this.indices[axis];
      slider.setAttribute("aria-valuetext", text);
      slider.closest("label").querySelector("output").textContent = text;
    });
    const key = `${this.robotIndex} ${this.mode} ${which.value}`;
    if (key !== this.searchKey) {
      this.searchKey = key;
      this.searchBand();
    } else {
      this.draw();
      this.showReadout();
      this.table.mark();
    }
  }

  poseText(poseIndex) {
    const { data, map } = this, values = map.pose(poseIndex);
    const pose = data.components.map((c, k) => `${c.name}\u00a0${formatFixed(values[k] * c.factor, c.decimals)}\u00a0${c.unit}`).join(", ");
    return data.list ? `${data.axes[map.firstPoseAxis].labels[poseIndex]}: ${pose}` : pose;
  }

  frequencyText(mode, poseIndex) {
    const frequency = this.map.frequency(mode, this.robotIndex, poseIndex);
    if (Number.isNaN(frequency)) return "\u2013";
    return Math.abs(frequency) >= this.data.largest ? "over 1 MHz" : formatFixed(frequency, this.data.decimals);
  }

  announcePose() {
    const { poseIndex, mode } = this;
    const text = poseIndex < 0 ? "" : `${this.poseText(poseIndex)}; mode ${this.data.modes[mode]}: ${this.frequencyText(mode, poseIndex)} Hz.`;
    this.find("status").textContent = text;
  }

  // Pose and frequencies at the pointer, or else at the cursor.
  showReadout() {
    const poseIndex = this.pointerPose >= 0 ? this.pointerPose : this.poseIndex;
    this.find("where").textContent = this.pointerPose >= 0 ? "At the pointer" : "At the cursor";
    this.find("pose").textContent = poseIndex < 0 ? "No pose can be evaluated." : this.poseText(poseIndex);
    this.findAll("frequency").forEach((cell, mode) => {
      cell.textContent = poseIndex < 0 ? "\u2013" : this.frequencyText(mode, poseIndex);
      cell.parentElement.querySelector("[data-part='in']").textContent = this.inBand(mode, poseIndex) ? "in the band" : "";
    });
  }
}

document.querySelectorAll(".explorer").forEach(async (root) => {
  const data = JSON.parse(root.querySelector("script[type='application/json']").textContent);
  let bytes;
  try {
    bytes = await inflate(data.packed);
  } catch {
    return; // an old browser: the sentence about it stays on the page
  }
  root.querySelector("[data-part='waiting']").hidden = true;
  root.querySelector("[data-part='all']").hidden = false;
  root.explorer = new MapExplorer(root, data, bytes);
});
