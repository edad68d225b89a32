// The three-dimensional part: camera, lights, the robot at a pose, and its motion in a mode.

// Where a label may stand, in widths and heights of a label from its place: there, above, below, beside it.
const SHIFTS = [[0, 0], [0, 1.05], [0, -1.05], [-0.6, 0], [0.6, 0], [-0.6, 1.05], [0.6, 1.05], [-0.6, -1.05], [0.6, -1.05]];

class Stage {
  constructor(canvas, data, state) {
    this.data = data;
    this.vertical = new T.Vector3(...data.vertical);
    this.renderer = new T.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.world = new T.Scene();
    this.camera = new T.PerspectiveCamera(32, 1, data.size / 200, data.size * 60);
    this.camera.up.copy(this.vertical);
    this.controls = new T.OrbitControls(this.camera, canvas);
    this.controls.enableZoom = false; // a page scrolls over the picture until it is focused
    this.controls.addEventListener("change", () => { this.dirty = true; });
    canvas.style.touchAction = "pan-y";
    this.lights();
    this.shapes = data.elements.map((e) => new SHAPES[e.shape](e, data.size, this.vertical));
    this.shapes.forEach((shape) => this.world.add(shape.group));
    this.ghost = new T.LineSegments(new T.BufferGeometry(), new T.LineBasicMaterial({ transparent: true, opacity: 0.5 }));
    this.trace = [0, 1, 2].map((i) => mesh(i ? new T.CylinderGeometry(0, 1, 1, 18) : UNIT_BAR, new T.MeshBasicMaterial()));
    this.world.add(this.ghost, ...this.trace);
    this.marks = new MeasuredMarks(data.size);
    this.world.add(this.marks.group);
    this.measured = null;
    this.declared = null;
    this.addWorkspace();
    this.labels = new T.Group();
    this.world.add(this.labels);
    this.state = state;
    this.mode = Math.min(data.rigid, data.frequencies[0].length - 1);
    this.amplitude = data.amplitude;
    this.lit = -1;
    this.phase = 1;
    this.dirty = true;
  }

  lights() {
    const [side, front] = this.horizontal();
    const key = new T.DirectionalLight("#ffffff", 1.9);
    key.position.copy(this.vertical).multiplyScalar(2).addScaledVector(front, -1.2).addScaledVector(side, 0.9);
    const fill = new T.DirectionalLight("#ffffff", 0.6);
    fill.position.copy(this.vertical).multiplyScalar(-1).addScaledVector(side, -1.2).addScaledVector(front, -0.4);
    this.world.add(new T.AmbientLight("#ffffff", 1.25), key, fill);
  }

  // Two horizontal directions: to the right and away from the viewer.
  horizontal() {
    const axes = [new T.Vector3(0, 1, 0), new T.Vector3(0, 0, -1)];
    const front = axes.find((a) => Math.abs(a.dot(this.vertical)) < 0.7);
    front.addScaledVector(this.vertical, -front.dot(this.vertical)).normalize();
    return [front.clone().cross(this.vertical), front];
  }

  addWorkspace() {
    const w = this.data.workspace;
    this.workspace = new T.Group();
    this.world.add(this.workspace);
    if (!w) return;
    const geometry = new T.BufferGeometry();
    geometry.setAttribute("position", new T.BufferAttribute(new Float32Array(w.vertices), 3));
    if (w.corners === 2) {
      geometry.setIndex(w.faces);
      this.workspace.add(new T.LineSegments(geometry, new T.LineBasicMaterial()));
      return;
    }
    const triangles = [];
    for (let i = 0; i < w.faces.length; i += 4) {
      const [a, b, c, d] = w.faces.slice(i, i + 4);
      triangles.push(a, b, c, a, c, d);
    }
    geometry.setIndex(triangles);
    geometry.computeVertexNormals();
    // Depth first, then colour: only the nearest layer shows, so that folds of the surface do not add up.
    const options = { transparent: true, side: T.DoubleSide };
    const depth = mesh(geometry, new T.MeshBasicMaterial({ ...options, colorWrite: false }));
    const skin = mesh(geometry, new T.MeshStandardMaterial({ ...options, opacity: 0.2, depthWrite: false, roughness: 0.9 }));
    [depth.renderOrder, skin.renderOrder] = [1, 2];
    this.workspace.add(depth, skin);
  }

  paint(palette) {
    this.palette = palette;
    this.world.background = new T.Color(palette.background);
    this.ghost.material.color.set(palette.ghost);
    this.trace.forEach((part) => part.material.color.set(palette.trace));
    this.marks.material.color.set(palette.measured);
    this.workspace.children.forEach((part) => part.material.color.set(palette.workspace));
    this.drawFloor();
    this.show();
  }

  drawFloor() {
    if (this.floor) this.world.remove(this.floor);
    const grid = new T.GridHelper(2.2 * this.data.size, 22, this.palette.grid, this.palette.grid);
    grid.quaternion.setFromUnitVectors(Y, this.vertical);
    const { centre, lowest } = this.bounds();
    grid.position.copy(centre).addScaledVector(this.vertical, lowest - 0.05 * this.data.size - centre.dot(this.vertical));
    this.floor = grid;
    this.world.add(grid);
  }

  // Box of the robot and its workspace at the pose shown first.
  bounds() {
    const low = new T.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    let lowest = Infinity;
    const take = (flat) => {
      for (let i = 0; i < flat.length / 3; i++) {
        const p = vector(flat, i);
        low.min(p); high.max(p);
        lowest = Math.min(lowest, p.dot(this.vertical));
      }
    };
    take(this.data.points[this.data.chosen]);
    if (this.data.workspace) take(this.data.workspace.vertices);
    return { centre: low.clone().add(high).divideScalar(2), extent: high.clone().sub(low), lowest };
  }

  // Look at a flat robot along its normal, at any other from the front, a little from above and from the right.
  resetView() {
    const { extent } = this.bounds(), [side, front] = this.horizontal();
    const sizes = ["x", "y", "z"].map((k) => extent[k]), least = sizes.indexOf(Math.min(...sizes));
    const flat = sizes[least] < 0.15 * Math.max(...sizes), normal = new T.Vector3().setComponent(least, 1);
    const from = new T.Vector3();
    if (flat && Math.abs(normal.dot(this.vertical)) > 0.9) {
      from.copy(this.vertical).addScaledVector(front, -0.9).addScaledVector(side, 0.14);
    } else if (flat) {
      from.copy(normal).addScaledVector(this.vertical, 0.18).addScaledVector(side, 0.25);
    } else {
      from.copy(front).multiplyScalar(-1).addScaledVector(side, 0.75).addScaledVector(this.vertical, 0.5);
    }
    this.frame(from.normalize());
    this.controls.update();
    this.dirty = true;
  }

  // Shares of the height of the picture that its caption covers at the top, and scale and buttons at the bottom.
  covered() {
    const canvas = this.renderer.domElement, box = canvas.getBoundingClientRect(), frame = canvas.parentElement;
    if (!box.height) return [0, 0];
    const ends = (part) => frame.querySelector(part)?.getBoundingClientRect(), share = (part) => Math.min(Math.max(part, 0) / box.height, 0.4);
    const [title, legend] = [ends(".pkview-title"), ends(".pkview-legend")];
    return [title ? share(title.bottom - box.top) : 0, legend ? share(box.bottom - legend.top) : 0];
  }

  // Place the camera in a direction so that everything fits into the picture, as large as possible.
  frame(from) {
    const right = this.vertical.clone().cross(from).normalize(), up = from.clone().cross(right);
    const slope = Math.tan((this.camera.fov * Math.PI) / 360), room = [(this.camera.aspect < 1 ? 0.74 : 0.84) * slope * this.camera.aspect, 0.76 * slope];
    const most = [-Infinity, -Infinity], least = [Infinity, Infinity];
    const { centre } = this.bounds();
    const take = (flat, part) => {
      for (let i = 0; i < flat.length / 3; i++) {
        const p = vector(flat, i).lerp(centre, 1 - part), near = p.dot(from);
        [right, up].forEach((axis, k) => {
          most[k] = Math.max(most[k], p.dot(axis) + room[k] * near);
          least[k] = Math.min(least[k], p.dot(axis) - room[k] * near);
        });
      }
    };
    take(this.data.points[this.data.chosen], 1);
    if (this.data.workspace) take(this.data.workspace.vertices, 0.75); // its edge may lie outside the picture
    let distance = Math.max(this.data.size, ...room.map((r, k) => (most[k] - least[k]) / (2 * r)));
    const depth = centre.dot(from), edge = 0.98 * slope * this.camera.aspect, [top, bottom] = this.covered();
    const above = (1 - 2 * top) * slope, below = (1 - 2 * bottom) * slope, shift = Math.max(0.06, top - bottom);
    for (let i = 0; i < 20; i++) {
      const aim = new T.Vector3();
      [right, up].forEach((axis, k) => aim.addScaledVector(axis, (most[k] + least[k]) / 2));
      aim.addScaledVector(up, shift * slope * distance); // the title is above
      this.camera.position.copy(aim).addScaledVector(from, distance);
      this.controls.target.copy(aim).addScaledVector(from, depth);
      // Labels keep their size: step back until they fit beside the robot, and below the caption.
      const cut = this.labels.children.some((label) => {
        const seen = label.position.clone().sub(this.camera.position);
        const wide = Math.abs(seen.dot(right) / seen.dot(from)), high = seen.dot(up) / -seen.dot(from);
        return wide + label.scale.x / 2 > edge || high + label.scale.y / 2 > above || label.scale.y / 2 - high > below;
      });
      if (!cut) return;
      distance *= 1.03;
    }
  }

  // From where the camera looks, and back there.
  view() {
    return [this.camera.position.clone(), this.controls.target.clone()];
  }

  look([position, target]) {
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.controls.update();
  }

  orbit(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = this.camera.getWorldDirection(new T.Vector3()).cross(this.vertical).normalize();
    offset.applyQuaternion(new T.Quaternion().setFromAxisAngle(this.vertical, right));
    const tilted = offset.clone().applyQuaternion(new T.Quaternion().setFromAxisAngle(side, up));
    if (Math.abs(tilted.clone().normalize().dot(this.vertical)) < 0.99) offset.copy(tilted);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  resize(width, height) {
    const before = this.camera.aspect;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.dirty = true;
    return Math.abs(before - this.camera.aspect) > 0.05;
  }

  // Colours and rest position for the present pose and mode.
  show() {
    const { data, palette, state } = this, { points } = state, shares = state.shares[this.mode];
    this.shapes.forEach((shape) => {
      const { spring } = shape.element, held = spring >= 0 ? (shares ? shares[spring] : 0) : null;
      if (shape.rest) shape.rest(points);
      shape.paint(palette, held, spring >= 0 && spring === this.lit);
    });
    this.drawGhost(points);
    this.marks.show(this.measured, data.elements);
    this.drawLabels(points);
    this.dirty = true;
  }

  // Thin lines: the robot at rest, or, where its values vary, the declared robot in its mode.
  drawGhost(points) {
    const ends = [];
    this.data.elements.filter((e) => e.shape === "line").forEach((e) => {
      for (let i = 1; i < e.points.length; i++) ends.push(vector(points, e.points[i - 1]), vector(points, e.points[i]));
    });
    const flat = new Float32Array(ends.flatMap((p) => [p.x, p.y, p.z]));
    this.ghost.geometry.setAttribute("position", new T.BufferAttribute(flat, 3));
    this.ghost.geometry.computeBoundingSphere();
  }

  drawLabels(points) {
    this.labels.children.forEach((s) => { s.material.map.dispose(); s.material.dispose(); });
    this.labels.clear();
    const { centre } = this.bounds(), found = new Map(), shares = this.state.shares[this.mode];
    const most = new Map();  // a label is the more important the more energy its springs hold
    for (const e of this.data.elements.filter((one) => one.spring >= 0)) {
      const at = e.shape === "wheel" ? e.points.slice(0, 1) : e.points;
      most.set(e.name, Math.max(most.get(e.name) || 0, shares ? shares[e.spring] : 0));
      for (const p of at.map((i) => vector(points, i))) {
        if (!found.has(e.name) || p.distanceTo(centre) > found.get(e.name).distanceTo(centre) + 1e-9) found.set(e.name, p);
      }
    }
    found.forEach((at, name) => {
      at.addScaledVector(at.clone().sub(centre).normalize(), 0.05 * this.data.size);
      this.labels.add(Object.assign(labelled(name, this.palette, at), { importance: most.get(name) }));
    });
  }

  // Move labels that would cover each other aside in the picture; one that finds no room near its place is left out.
  arrange() {
    const { elements: m } = this.camera.projectionMatrix, placed = [], [top, bottom] = this.covered();
    const inside = (y, high) => y + high / 2 < 1 - 2 * top && y - high / 2 > 2 * bottom - 1; // the caption stays legible
    const order = [...this.labels.children].sort((a, b) => b.importance - a.importance);
    this.camera.updateMatrixWorld();
    for (const label of order) {
      const { x, y } = label.position.clone().project(this.camera);
      const [wide, high] = [label.scale.x * m[0], label.scale.y * m[5]];
      const beside = (one, u, v) => Math.abs(one.x - u) > (one.wide + wide) / 2 || Math.abs(one.y - v) > high;
      const free = ([u, v]) => inside(y + v * high, high) && placed.every((one) => beside(one, x + u * wide, y + v * high));
      const shift = SHIFTS.find(free);
      label.visible = shift !== undefined;
      if (!label.visible) continue;
      label.center.set(0.5 - shift[0], 0.5 - shift[1]);
      placed.push({ x: x + shift[0] * wide, y: y + shift[1] * high, wide });
    }
  }

  // Positions of all points now; the motion is linear in the amplitude.
  moved() {
    return this.displaced(this.state.points, this.state.moved[this.mode], 1);
  }

  displaced(rest, by, sign) {
    const { data } = this, factor = sign * this.amplitude * data.size * this.phase;
    return rest.map((value, i) => value + factor * by[3 * data.motionsOf[Math.floor(i / 3)] + (i % 3)]);
  }

  render() {
    const { data } = this, points = this.moved(), factor = this.amplitude * data.size;
    const turned = this.state.turned[this.mode].map((angle) => angle * factor * this.phase);
    this.shapes.forEach((shape) => shape.place(points, turned));
    const { declared } = this;
    if (declared) this.drawGhost(this.displaced(declared.points, declared.moved, declared.sign));
    this.marks.place(this.state.points, factor, this.phase);
    const centre = vector(this.state.points, 0);
    const reach = vector(this.state.moved[this.mode], data.motionsOf[0]).multiplyScalar(factor);
    const [bar, ...tips] = this.trace, ends = [1, -1].map((s) => centre.clone().addScaledVector(reach, s));
    const shown = reach.length() > 0.004 * data.size;
    this.trace.forEach((part) => { part.visible = shown; });
    if (shown) {
      stretch(bar, ends[0], ends[1], 0.0022 * data.size);
      const tip = reach.clone().normalize();
      tips.forEach((cone, i) => {
        const s = i ? -1 : 1;
        stretch(cone, ends[i], ends[i].clone().addScaledVector(tip, s * 0.022 * data.size), 0.0075 * data.size);
      });
    }
    if (this.labels.visible) this.arrange();
    this.renderer.render(this.world, this.camera);
    this.dirty = false;
  }
}

function labelled(text, palette, at) {
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d"), font = "600 30px system-ui, sans-serif";
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 20;
  canvas.height = 44;
  context.font = font;
  context.lineWidth = 7;
  context.lineJoin = "round";
  context.strokeStyle = palette.background; // a halo instead of a box
  context.textBaseline = "middle";
  context.strokeText(text, 10, 23);
  context.fillStyle = palette.text;
  context.fillText(text, 10, 23);
  const map = new T.CanvasTexture(canvas);
  map.colorSpace = T.SRGBColorSpace;
  const sprite = new T.Sprite(new T.SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }));
  sprite.position.copy(at);
  sprite.scale.set((0.023 * canvas.width) / canvas.height, 0.023, 1);
  sprite.renderOrder = 3;
  return sprite;
}
