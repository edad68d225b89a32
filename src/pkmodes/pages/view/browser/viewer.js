// One viewer of a page: it connects the controls of the user to the stage (the picture) and the panel (the texts).

// Size of the copy of the picture for printing [px].
const PRINT_SIZE = [1600, 620];
// Poses that differ by less in every component are one [m or rad]: data have six decimals.
const POSE_TOLERANCE = 2e-6;

class Viewer {
  constructor(root, json) {
    this.root = root;
    this.data = JSON.parse(json);
    this.states = new States(this.data);
    this.state = this.states.evaluatedState(this.data.chosen);
    this.panel = new Panel(root, this.data);
    this.canvas = root.querySelector("canvas");
    this.stage = this.createStage();
    this.mode = Math.min(this.data.rigid, this.data.frequencies[0].length - 1);
    this.amplitude = this.data.amplitude;
    this.time = 0.25 / this.panel.cycles; // begins at the largest displacement
    this.isPlaying = !!this.stage && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (this.stage) Object.assign(this.stage, this.comparedModes());
    this.addListeners();
    this.panel.showState(this.state);
    this.panel.showMode(this.state, this.mode, this.amplitude, false);
    this.panel.showMeasured(this.state, this.mode, false);
    this.panel.showDeclared(this.state, this.mode, this.states);
    this.panel.showPlaying(this.isPlaying);
    if (this.stage) this.run();
    document.dispatchEvent(new CustomEvent("pkmodes-viewer")); // a map of the page says where its cursor is
  }

  // Index of the evaluated state that is shown or is nearest to the one shown.
  get stateIndex() {
    return this.state.nearest;
  }

  // The modes that are compared with the one shown: the measured one and that of the declared robot; null for none.
  comparedModes() {
    const { data, state, mode } = this;
    return { measured: measuredMode(data, state, mode), declared: this.states.declaredMode(state, mode) };
  }

  createStage() {
    try {
      const stage = new Stage(this.canvas, this.data, this.state);
      this.root.classList.add("pkview-live"); // the picture takes the place of the still, and has a size
      this.canvas.addEventListener("webglcontextlost", () => this.showFailure("The graphics of the browser have stopped."));
      return stage;
    } catch (error) {
      this.showFailure("This browser cannot show the robot in three dimensions: WebGL is not available.");
      return null;
    }
  }

  showFailure(reason) {
    const message = this.panel.find("message");
    message.textContent = `${reason} All numbers are in the table below.`;
    message.hidden = false;
    this.root.classList.remove("pkview-live");
    this.root.classList.add("pkview-flat");
  }

  addListeners() {
    const { panel, canvas } = this;
    const on = (name, event, handler) => panel.findAll(name).forEach(
      (part) => part.addEventListener(event, () => handler(part)),
    );
    on("mode", "change", (input) => this.select(this.state, Number(input.value)));
    on("pose", "change", (list) => { this.select(this.states.evaluatedState(Number(list.value)), this.mode); this.notifyMoved(); });
    on("level", "input", (slider) => this.moveSlider(slider));
    on("amplitude", "input", (slider) => { this.amplitude = Number(slider.value) / 100; this.refresh(); });
    on("speed", "input", (slider) => { this.setSpeed(Number(slider.value)); });
    on("play", "click", () => this.togglePlaying());
    on("reset", "click", () => { if (this.stage) { this.viewTurned = false; this.stage.resetView(); } });
    on("labels", "change", (box) => { if (this.stage) { this.stage.labels.visible = box.checked; this.stage.dirty = true; } });
    on("marks", "change", (box) => { if (this.stage) { this.stage.marks.group.visible = box.checked; this.stage.dirty = true; } });
    on("space", "change", (box) => { if (this.stage) { this.stage.workspace.visible = box.checked; this.stage.dirty = true; } });
    on("spring", "pointerenter", (row) => this.highlightSpring(Number(row.dataset.spring)));
    on("spring", "pointerleave", () => this.highlightSpring(-1));
    document.addEventListener("pkmodes-pose", (event) => this.moveToPose(event.detail.pose));
    canvas.addEventListener("keydown", (event) => this.handleKey(event));
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("focus", () => this.enableZoom(true));
    canvas.addEventListener("blur", () => this.enableZoom(false));
    if (!this.stage) return;
    this.stage.controls.addEventListener("start", () => { this.viewTurned = true; });
    const dark = matchMedia("(prefers-color-scheme: dark)"), print = matchMedia("print");
    const repaint = () => {
      this.stage.paint(PALETTES[dark.matches && !this.printing ? "dark" : "light"]);
      this.draw();
    };
    const setPrinting = (printing) => {
      this.printing = printing;
      repaint();
      if (printing) this.copyForPrint();
    };
    dark.addEventListener("change", repaint);
    print.addEventListener("change", () => setPrinting(print.matches));
    addEventListener("beforeprint", () => setPrinting(true));
    addEventListener("afterprint", () => setPrinting(false));
    repaint();
    this.fitCanvas(true);
    new ResizeObserver(() => this.fitCanvas(false)).observe(canvas.parentElement);
    new IntersectionObserver((entries) => { this.isVisible = entries.at(-1).isIntersecting; }).observe(canvas);
  }

  // Copy the picture for printing: a browser may print the WebGL canvas as it was a frame earlier.
  copyForPrint() {
    if (!this.fitted) return; // the page was opened for printing: its still picture is printed
    this.root.classList.add("pkview-copied");
    const copy = this.root.querySelector(".pkview-still"), { stage, canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas, cameraView = stage.cameraView();
    stage.resize(...PRINT_SIZE);
    if (!this.viewTurned) stage.resetView();
    this.draw();
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext("2d").drawImage(canvas, 0, 0);
    if (width && height) stage.resize(width, height);
    stage.setCameraView(cameraView);
    this.draw();
  }

  enableZoom(enabled) {
    if (this.stage) this.stage.controls.enableZoom = enabled;
  }

  fitCanvas(isFirst) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return; // hidden, as in print
    const changed = this.stage.resize(width, height);
    if (isFirst || !this.fitted || (changed && !this.viewTurned)) this.stage.resetView();
    this.fitted = true;
    this.draw();
  }

  // Move to the position of the sliders or, where the robot cannot be there, to the nearest one with the slider that
  // moved.  The other sliders then give way; what they were set to is kept in `requestedPosition`, and they return to
  // it as soon as the robot can be there again.
  moveSlider(slider) {
    const { panel, states } = this, axis = panel.findAll("level").indexOf(slider);
    const requested = (this.requestedPosition || this.state.gridPosition).slice();
    requested[axis] = Number(slider.value) / SLIDER_STEPS;
    const position = states.nearestReachable(requested, axis);
    this.select(states.stateAt(position), this.mode);
    this.requestedPosition = requested;
    const { varied } = this.data, status = panel.find("status");
    if (position[axis] !== requested[axis]) {
      status.textContent += varied ? " With that value the robot cannot be at the pose." : " No pose that was computed is reachable there.";
    } else if (position !== requested) {
      status.textContent += varied
        ? " Moved to the nearest values with which the robot can be at the pose."
        : " Moved to the nearest pose that the robot can reach.";
    }
    this.notifyMoved();
  }

  // Move to a pose [SI] that another part of the page asks for, or to the nearest one that can be shown.
  moveToPose(values) {
    const { data, states } = this, { poses } = data;
    if (data.varied || values.length !== poses[0].length) return;
    if (values.every((value, i) => Math.abs(value - this.state.pose[i]) < POSE_TOLERANCE)) return;
    if (data.levels) {
      this.select(states.stateAt(states.nearestReachable(states.gridPositionOf(values))), this.mode);
      return;
    }
    const spans = values.map((_, i) => spread(poses.map((pose) => pose[i])));
    const distance = (pose) => pose.reduce((sum, value, i) => sum + ((value - values[i]) / spans[i]) ** 2, 0);
    const nearest = poses.reduce((best, pose, i) => (distance(pose) < distance(poses[best]) ? i : best), 0);
    this.select(states.evaluatedState(nearest), this.mode);
  }

  // Tell other parts of the page that the controls moved the robot.
  notifyMoved() {
    if (this.data.varied) return;
    const detail = { pose: this.state.pose };
    document.dispatchEvent(new CustomEvent("pkmodes-moved", { detail }));
  }

  select(state, mode) {
    if (state !== this.state) this.requestedPosition = null;
    this.state = state;
    this.mode = mode;
    this.panel.showState(state);
    this.panel.showMode(state, mode, this.amplitude, true);
    this.panel.showMeasured(state, mode, true);
    this.panel.showDeclared(state, mode, this.states);
    if (!this.stage) return;
    Object.assign(this.stage, { state, mode, ...this.comparedModes() });
    this.stage.show();
    this.draw();
  }

  highlightSpring(spring) {
    if (!this.stage || this.stage.highlightedSpring === spring) return;
    this.stage.highlightedSpring = spring;
    this.stage.show();
    this.draw();
  }

  setSpeed(cycles) {
    const periods = this.time * this.panel.cycles; // the phase does not jump
    this.panel.cycles = cycles;
    this.time = periods / cycles;
    this.refresh();
  }

  refresh() {
    this.panel.showMotion(this.state.shares[this.mode] ? this.state.frequencies[this.mode] : 0, this.amplitude);
    this.draw();
  }

  togglePlaying() {
    this.isPlaying = !this.isPlaying;
    this.panel.showPlaying(this.isPlaying);
  }

  handleKey(event) {
    const angle = 0.09, actions = {
      ArrowLeft: () => this.stage.orbit(-angle, 0), ArrowRight: () => this.stage.orbit(angle, 0),
      ArrowUp: () => this.stage.orbit(0, -angle), ArrowDown: () => this.stage.orbit(0, angle),
      "+": () => this.stage.zoom(0.9), "=": () => this.stage.zoom(0.9), "-": () => this.stage.zoom(1 / 0.9),
      Home: () => this.stage.resetView(), 0: () => this.stage.resetView(), " ": () => this.togglePlaying(),
    };
    if (!this.stage || !actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (event.key !== " ") this.viewTurned = event.key !== "Home" && event.key !== "0";
    actions[event.key]();
  }

  draw() {
    if (!this.stage) return;
    this.stage.amplitude = this.amplitude;
    this.stage.phase = this.printing ? 1 : Math.sin(2 * Math.PI * this.panel.cycles * this.time);
    this.stage.render();
  }

  run() {
    let previous = performance.now();
    const advance = (now) => {
      const elapsed = Math.min((now - previous) / 1000, 0.1);
      previous = now;
      if (this.isPlaying && this.isVisible !== false && !this.printing) {
        this.time += elapsed;
        this.draw();
      } else if (this.stage.dirty) {
        this.draw();
      }
      requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }
}

// Largest minus smallest value, but 1 for equal values.
function spread(values) {
  return Math.max(...values) - Math.min(...values) || 1;
}

// The text of a zlib stream in Base64.
async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
}

document.querySelectorAll(".pkview:not([data-started])").forEach(async (root) => {
  root.dataset.started = "";
  const plain = root.querySelector("script[type='application/json']");
  let json;
  try {
    const deflated = root.querySelector("script[type='application/x-deflated-json']");
    json = plain ? plain.textContent : await inflate(deflated.textContent);
  } catch {
    return; // an old browser: the still picture stays
  }
  root.viewer = new Viewer(root, json);
});
