// One viewer: the stage, the panel, and what the user does.

// Size of the copy for paper.
const PAPER = [1600, 620];

class Viewer {
  constructor(root, text) {
    this.root = root;
    this.data = JSON.parse(text);
    this.states = new States(this.data);
    this.state = this.states.evaluated(this.data.chosen);
    this.panel = new Panel(root, this.data);
    this.canvas = root.querySelector("canvas");
    this.stage = this.start();
    this.mode = Math.min(this.data.rigid, this.data.frequencies[0].length - 1);
    this.amplitude = this.data.amplitude;
    this.time = 0.25 / this.panel.cycles; // begins at the largest displacement
    this.on = !!this.stage && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (this.stage) Object.assign(this.stage, this.beside());
    this.listen();
    this.panel.pose(this.state);
    this.panel.mode(this.state, this.mode, this.amplitude, false);
    this.panel.measured(this.state, this.mode, false);
    this.panel.declared(this.state, this.mode, this.states);
    this.panel.playing(this.on);
    if (this.stage) this.run();
  }

  // The evaluated state that is shown, or the nearest one.
  get pose() {
    return this.state.nearest;
  }

  // What stands beside the mode that is shown: a measured one, one of the declared robot, null for none.
  beside() {
    return { measured: measuredAt(this.data, this.state, this.mode), declared: this.states.declared(this.state, this.mode) };
  }

  start() {
    try {
      const stage = new Stage(this.canvas, this.data, this.state);
      this.root.classList.add("pkview-live"); // the picture takes the place of the still, and has a size
      this.canvas.addEventListener("webglcontextlost", () => this.fail("The graphics of the browser have stopped."));
      return stage;
    } catch (error) {
      this.fail("This browser cannot show the robot in three dimensions: WebGL is not available.");
      return null;
    }
  }

  fail(reason) {
    const message = this.panel.find("message");
    message.textContent = `${reason} All numbers are in the table below.`;
    message.hidden = false;
    this.root.classList.remove("pkview-live");
    this.root.classList.add("pkview-flat");
  }

  listen() {
    const { panel, canvas } = this, on = (name, event, act) => panel.all(name).forEach((part) => part.addEventListener(event, () => act(part)));
    on("mode", "change", (input) => this.choose(this.state, Number(input.value)));
    on("pose", "change", (select) => { this.choose(this.states.evaluated(Number(select.value)), this.mode); this.tell(); });
    on("level", "input", (slider) => this.slide(slider));
    on("amplitude", "input", (slider) => { this.amplitude = Number(slider.value) / 100; this.refresh(); });
    on("speed", "input", (slider) => { this.pace(Number(slider.value)); });
    on("play", "click", () => this.toggle());
    on("reset", "click", () => { if (this.stage) { this.turned = false; this.stage.resetView(); } });
    on("labels", "change", (box) => { if (this.stage) { this.stage.labels.visible = box.checked; this.stage.dirty = true; } });
    on("marks", "change", (box) => { if (this.stage) { this.stage.marks.group.visible = box.checked; this.stage.dirty = true; } });
    on("space", "change", (box) => { if (this.stage) { this.stage.workspace.visible = box.checked; this.stage.dirty = true; } });
    on("spring", "pointerenter", (row) => this.light(Number(row.dataset.spring)));
    on("spring", "pointerleave", () => this.light(-1));
    document.addEventListener("pkmodes-pose", (event) => this.go(event.detail.pose));
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("focus", () => this.zooming(true));
    canvas.addEventListener("blur", () => this.zooming(false));
    if (!this.stage) return;
    this.stage.controls.addEventListener("start", () => { this.turned = true; });
    const dark = matchMedia("(prefers-color-scheme: dark)"), print = matchMedia("print");
    const repaint = () => {
      this.stage.paint(PALETTES[dark.matches && !this.printing ? "dark" : "light"]);
      this.draw();
    };
    const printing = (on) => {
      this.printing = on;
      repaint();
      if (on) this.still();
    };
    dark.addEventListener("change", repaint);
    print.addEventListener("change", () => printing(print.matches));
    addEventListener("beforeprint", () => printing(true));
    addEventListener("afterprint", () => printing(false));
    repaint();
    this.fit(true);
    new ResizeObserver(() => this.fit(false)).observe(canvas.parentElement);
    new IntersectionObserver((entries) => { this.seen = entries.at(-1).isIntersecting; }).observe(canvas);
  }

  // A copy of the picture for paper: a browser may print the WebGL canvas as it was a frame ago.
  still() {
    if (!this.fitted) return; // opened on paper: the still of the page serves
    this.root.classList.add("pkview-copied");
    const copy = this.root.querySelector(".pkview-still"), { stage, canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas, seen = stage.view();
    stage.resize(...PAPER);
    if (!this.turned) stage.resetView();
    this.draw();
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext("2d").drawImage(canvas, 0, 0);
    if (width && height) stage.resize(width, height);
    stage.look(seen);
    this.draw();
  }

  zooming(on) {
    if (this.stage) this.stage.controls.enableZoom = on;
  }

  fit(first) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return; // hidden, as on paper
    const changed = this.stage.resize(width, height);
    if (first || !this.fitted || (changed && !this.turned)) this.stage.resetView();
    this.fitted = true;
    this.draw();
  }

  // The place of the sliders, or the nearest one that the robot can reach with the slider that moved.  What the other
  // sliders were set to is kept: they return to it where the robot can reach it again.
  slide(moved) {
    const { panel, states } = this, axis = panel.all("level").indexOf(moved), wanted = (this.wanted || this.state.place).slice();
    wanted[axis] = Number(moved.value) / FINE;
    const place = states.nearest(wanted, axis);
    this.choose(states.at(place), this.mode);
    this.wanted = wanted;
    const { varied } = this.data, status = panel.find("status");
    if (place[axis] !== wanted[axis]) status.textContent += varied ? " With that value the robot cannot be at the pose." : " No pose that was computed is reachable there.";
    else if (place !== wanted) status.textContent += varied ? " Moved to the nearest values with which the robot can be at the pose." : " Moved to the nearest pose that the robot can reach.";
    this.tell();
  }

  // Move to the pose given in SI units, as another part of the page asks, or as near to it as the poses here allow.
  go(values) {
    const { data, states } = this, { poses } = data;
    if (data.varied || values.length !== poses[0].length) return;
    if (data.levels) {
      this.choose(states.at(states.nearest(states.placed(values))), this.mode);
      return;
    }
    const spans = values.map((_, i) => span(poses.map((pose) => pose[i])));
    const far = (pose) => pose.reduce((sum, value, i) => sum + ((value - values[i]) / spans[i]) ** 2, 0);
    const best = poses.reduce((found, pose, i) => (far(pose) < far(poses[found]) ? i : found), 0);
    this.choose(states.evaluated(best), this.mode);
  }

  // Tell other parts of the page that the controls moved the robot.
  tell() {
    if (this.data.varied) return;
    const detail = { pose: this.state.pose };
    document.dispatchEvent(new CustomEvent("pkmodes-moved", { detail }));
  }

  choose(state, mode) {
    if (state !== this.state) this.wanted = null;
    this.state = state;
    this.mode = mode;
    this.panel.pose(state);
    this.panel.mode(state, mode, this.amplitude, true);
    this.panel.measured(state, mode, true);
    this.panel.declared(state, mode, this.states);
    if (!this.stage) return;
    Object.assign(this.stage, { state, mode, ...this.beside() });
    this.stage.show();
    this.draw();
  }

  light(spring) {
    if (!this.stage || this.stage.lit === spring) return;
    this.stage.lit = spring;
    this.stage.show();
    this.draw();
  }

  pace(cycles) {
    const turn = this.time * this.panel.cycles; // the phase does not jump
    this.panel.cycles = cycles;
    this.time = turn / cycles;
    this.refresh();
  }

  refresh() {
    this.panel.motion(this.state.frequencies[this.mode], this.amplitude);
    this.draw();
  }

  toggle() {
    this.on = !this.on;
    this.panel.playing(this.on);
  }

  key(event) {
    const turn = 0.09, acts = {
      ArrowLeft: () => this.stage.orbit(-turn, 0), ArrowRight: () => this.stage.orbit(turn, 0),
      ArrowUp: () => this.stage.orbit(0, -turn), ArrowDown: () => this.stage.orbit(0, turn),
      "+": () => this.stage.zoom(0.9), "=": () => this.stage.zoom(0.9), "-": () => this.stage.zoom(1 / 0.9),
      Home: () => this.stage.resetView(), 0: () => this.stage.resetView(), " ": () => this.toggle(),
    };
    if (!this.stage || !acts[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.turned = event.key !== "Home" && event.key !== "0";
    acts[event.key]();
  }

  draw() {
    if (!this.stage) return;
    this.stage.amplitude = this.amplitude;
    this.stage.phase = this.printing ? 1 : Math.sin(2 * Math.PI * this.panel.cycles * this.time);
    this.stage.render();
  }

  run() {
    let before = performance.now();
    const step = (now) => {
      const passed = Math.min((now - before) / 1000, 0.1);
      before = now;
      if (this.on && this.seen !== false && !this.printing) {
        this.time += passed;
        this.draw();
      } else if (this.stage.dirty) {
        this.draw();
      }
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}

function span(values) {
  return Math.max(...values) - Math.min(...values) || 1;
}

// The text of a zlib stream in base 64.
async function inflatedText(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
}

document.querySelectorAll(".pkview:not([data-started])").forEach(async (root) => {
  root.dataset.started = "";
  const plain = root.querySelector("script[type='application/json']");
  let text;
  try {
    text = plain ? plain.textContent : await inflatedText(root.querySelector("script[type='application/x-deflated-json']").textContent);
  } catch {
    return; // an old browser: the still stays
  }
  root.viewer = new Viewer(root, text);
});
