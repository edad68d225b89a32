// The three-dimensional part: camera, lights, the robot at a pose, and its motion in a mode.

// Positions to try for a label, in widths and heights of the label from its point: there, above, below, beside it.
const LABEL_SHIFTS = [
  [0, 0], [0, 1.05], [0, -1.05], [-0.6, 0], [0.6, 0], [-0.6, 1.05], [0.6, 1.05], [-0.6, -1.05], [0.6, -1.05],
];

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
    this.addLights();
    this.shapes = data.elements.map((e) => new SHAPES[e.shape](e, data.size, this.vertical));
    this.shapes.forEach((shape) => this.world.add(shape.group));
    this.ghost = new T.LineSegments(new T.BufferGeometry(), new T.LineBasicMaterial({ transparent: true, opacity: 0.5 }));
    // The path of the platform: a bar between its extreme positions, with a cone at each end.
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
    this.highlightedSpring = -1;
    this.phase = 1;
    this.dirty = true;
  }

  addLights() {
    const [side, front] = this.horizontalDirections();
    const key = new T.DirectionalLight("#ffffff", 1.9);
    key.position.copy(this.vertical).multiplyScalar(2).addScaledVector(front, -1.2).addScaledVector(side, 0.9);
    const fill = new T.DirectionalLight("#ffffff", 0.6);
    fill.position.copy(this.vertical).multiplyScalar(-1).addScaledVector(side, -1.2).addScaledVector(front, -0.4);
    this.world.add(new T.AmbientLight("#ffffff", 1.25), key, fill);
  }

  // Two horizontal directions: to the right and away from the viewer.
  horizontalDirections() {
    const axes = [new T.Vector3(0, 1, 0), new T.Vector3(0, 0, -1)];
    const front = axes.find((a) => Math.abs(a.dot(this.vertical)) < 0.7);
    front.addScaledVector(this.vertical, -front.dot(this.vertical)).normalize();
    return [front.clone().cross(this.vertical), front];
  }

  addWorkspace() {
    const surface = this.data.workspace;
    this.workspace = new T.Group();
    this.world.add(this.workspace);
    if (!surface) return;
    const geometry = new T.BufferGeometry();
    geometry.setAttribute("position", new T.BufferAttribute(new Float32Array(surface.vertices), 3));
    if (surface.corners === 2) {
      geometry.setIndex(surface.faces);
      this.workspace.add(new T.LineSegments(geometry, new T.LineBasicMaterial()));
      return;
    }
    const triangles = [];
    for (let i = 0; i < surface.faces.length; i += 4) {
      const [a, b, c, d] = surface.faces.slice(i, i + 4);
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

  // Bounding box of the robot at the pose shown first and of its workspace, and their lowest level.
  bounds() {
    const low = new T.Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    let lowest = Infinity;
    const include = (coordinates) => {
      for (let i = 0; i < coordinates.length / 3; i++) {
        const p = pointAt(coordinates, i);
        low.min(p); high.max(p);
        lowest = Math.min(lowest, p.dot(this.vertical));
      }
    };
    include(this.data.points[this.data.chosen]);
    if (this.data.workspace) include(this.data.workspace.vertices);
    return { centre: low.clone().add(high).divideScalar(2), extent: high.clone().sub(low), lowest };
  }

  // Look from the direction of the still pictures.
  resetView() {
    this.fitCamera(new T.Vector3(...this.data.towards).normalize());
    this.controls.update();
    this.dirty = true;
  }

  // Fractions of the height of the picture that are covered: by the title at the top, by scale and buttons at the
  // bottom.
  coveredFractions() {
    const canvas = this.renderer.domElement, box = canvas.getBoundingClientRect(), frame = canvas.parentElement;
    if (!box.height) return [0, 0];
    const boxOf = (selector) => frame.querySelector(selector)?.getBoundingClientRect();
    const fraction = (height) => Math.min(Math.max(height, 0) / box.height, 0.4);
    const [title, legend] = [boxOf(".pkview-title"), boxOf(".pkview-legend")];
    return [title ? fraction(title.bottom - box.top) : 0, legend ? fraction(box.bottom - legend.top) : 0];
  }

  // Move the camera so that it looks against `direction`, from the shortest distance at which everything is in the
  // picture.
  fitCamera(direction) {
    const right = this.vertical.clone().cross(direction).normalize(), up = direction.clone().cross(right);
    // Slopes of the edges of the picture, and those horizontally and vertically within which the robot is to fit.
    const slope = Math.tan((this.camera.fov * Math.PI) / 360), { aspect } = this.camera;
    const fittedSlopes = [(aspect < 1 ? 0.74 : 0.84) * slope * aspect, 0.76 * slope];
    const highest = [-Infinity, -Infinity], lowest = [Infinity, Infinity];
    const { centre } = this.bounds();
    const include = (coordinates, scale) => {
      for (let i = 0; i < coordinates.length / 3; i++) {
        const p = pointAt(coordinates, i).lerp(centre, 1 - scale), depth = p.dot(direction);
        [right, up].forEach((axis, k) => {
          highest[k] = Math.max(highest[k], p.dot(axis) + fittedSlopes[k] * depth);
          lowest[k] = Math.min(lowest[k], p.dot(axis) - fittedSlopes[k] * depth);
        });
      }
    };
    include(this.data.points[this.data.chosen], 1);
    if (this.data.workspace) include(this.data.workspace.vertices, 0.75); // its edge may lie outside the picture
    let distance = Math.max(this.data.size, ...fittedSlopes.map((r, k) => (highest[k] - lowest[k]) / (2 * r)));
    const targetDepth = centre.dot(direction), horizontalLimit = 0.98 * slope * aspect;
    const [top, bottom] = this.coveredFractions();
    const upperLimit = (1 - 2 * top) * slope, lowerLimit = (1 - 2 * bottom) * slope, shift = Math.max(0.06, top - bottom);
    for (let i = 0; i < 20; i++) {
      const middle = new T.Vector3();
      [right, up].forEach((axis, k) => middle.addScaledVector(axis, (highest[k] + lowest[k]) / 2));
      middle.addScaledVector(up, shift * slope * distance); // the title is above
      this.camera.position.copy(middle).addScaledVector(direction, distance);
      this.controls.target.copy(middle).addScaledVector(direction, targetDepth);
      // Labels keep their size: step back until they fit beside the robot, and below the caption.
      const isCut = this.labels.children.some((label) => {
        const offset = label.position.clone().sub(this.camera.position);
        const horizontal = Math.abs(offset.dot(right) / offset.dot(direction));
        const vertical = offset.dot(up) / -offset.dot(direction), halfWidth = label.scale.x / 2, halfHeight = label.scale.y / 2;
        const isTooHigh = vertical + halfHeight > upperLimit, isTooLow = halfHeight - vertical > lowerLimit;
        return horizontal + halfWidth > horizontalLimit || isTooHigh || isTooLow;
      });
      if (!isCut) return;
      distance *= 1.03;
    }
  }

  // Position and target of the camera, to return to them.
  cameraView() {
    return [this.camera.position.clone(), this.controls.target.clone()];
  }

  setCameraView([position, target]) {
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
    const aspectBefore = this.camera.aspect;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.dirty = true;
    return Math.abs(aspectBefore - this.camera.aspect) > 0.05;
  }

  // Update colours, rest positions, marks and labels for the current state and mode.
  show() {
    const { data, palette, state } = this, { points } = state, shares = state.shares[this.mode];
    this.shapes.forEach((shape) => {
      const { spring } = shape.element, share = spring >= 0 ? (shares ? shares[spring] : 0) : null;
      if (shape.setRestPoints) shape.setRestPoints(points);
      shape.paint(palette, share, spring >= 0 && spring === this.highlightedSpring);
    });
    this.drawGhost(points);
    this.marks.show(this.measured, data.elements);
    this.drawLabels(points);
    this.dirty = true;
  }

  // Draw the ghost, thin lines: the robot at rest, or, where its values vary, the declared robot in its mode.
  drawGhost(points) {
    const ends = [];
    this.data.elements.filter((e) => e.shape === "line").forEach((e) => {
      for (let i = 1; i < e.points.length; i++) ends.push(pointAt(points, e.points[i - 1]), pointAt(points, e.points[i]));
    });
    const coordinates = new Float32Array(ends.flatMap((p) => [p.x, p.y, p.z]));
    this.ghost.geometry.setAttribute("position", new T.BufferAttribute(coordinates, 3));
    this.ghost.geometry.computeBoundingSphere();
  }

  drawLabels(points) {
    this.labels.children.forEach((s) => { s.material.map.dispose(); s.material.dispose(); });
    this.labels.clear();
    const { centre } = this.bounds(), positions = new Map(), shares = this.state.shares[this.mode];
    const importances = new Map();  // largest share of the strain energy of the springs that a label names
    for (const e of this.data.elements.filter((element) => element.spring >= 0)) {
      const indices = e.shape === "wheel" ? e.points.slice(0, 1) : e.points;
      const spring = this.data.springs[e.spring], label = e.name.endsWith(spring) ? spring : e.name; // as in the table
      importances.set(label, Math.max(importances.get(label) || 0, shares ? shares[e.spring] : 0));
      for (const p of indices.map((i) => pointAt(points, i))) {
        const isOutermost = !positions.has(label) || p.distanceTo(centre) > positions.get(label).distanceTo(centre) + 1e-9;
        if (isOutermost) positions.set(label, p);
      }
    }
    positions.forEach((position, name) => {
      position.addScaledVector(position.clone().sub(centre).normalize(), 0.05 * this.data.size);
      this.labels.add(Object.assign(labelSprite(name, this.palette, position), { name, importance: importances.get(name) }));
    });
  }

  // Shift labels that would cover each other; hide a label that has no room near its point.
  arrangeLabels() {
    const { elements: projection } = this.camera.projectionMatrix;
    const placedLabels = [], [top, bottom] = this.coveredFractions();
    // Whether a label leaves the title and the legend legible.
    const isClear = (y, height) => y + height / 2 < 1 - 2 * top && y - height / 2 > 2 * bottom - 1;
    const order = [...this.labels.children].sort((a, b) => b.importance - a.importance);
    this.camera.updateMatrixWorld();
    for (const label of order) {
      const { x, y } = label.position.clone().project(this.camera);
      const [width, height] = [label.scale.x * projection[0], label.scale.y * projection[5]];
      const isApart = (other, u, v) => Math.abs(other.x - u) > (other.width + width) / 2 || Math.abs(other.y - v) > height;
      const isFree = ([u, v]) => isClear(y + v * height, height)
        && placedLabels.every((other) => isApart(other, x + u * width, y + v * height));
      const shift = LABEL_SHIFTS.find(isFree);
      label.visible = shift !== undefined;
      if (!label.visible) continue;
      label.center.set(0.5 - shift[0], 0.5 - shift[1]);
      placedLabels.push({ x: x + shift[0] * width, y: y + shift[1] * height, width });
    }
  }

  // Positions of all points at the current phase; the motion is linear in the amplitude.
  displacedPoints() {
    return this.displace(this.state.points, this.state.displacements[this.mode], 1);
  }

  displace(points, displacements, sign) {
    const { data } = this, factor = sign * this.amplitude * data.size * this.phase;
    return points.map((value, i) => value + factor * displacements[3 * data.motionsOf[Math.floor(i / 3)] + (i % 3)]);
  }

  render() {
    const { data } = this, points = this.displacedPoints(), factor = this.amplitude * data.size;
    const rotations = this.state.rotations[this.mode].map((angle) => angle * factor * this.phase);
    this.shapes.forEach((shape) => shape.place(points, rotations));
    const { declared } = this;
    if (declared) this.drawGhost(this.displace(declared.points, declared.displacements, declared.sign));
    this.marks.place(this.state.points, factor, this.phase);
    const centre = pointAt(this.state.points, 0);
    const amplitudeVector = pointAt(this.state.displacements[this.mode], data.motionsOf[0]).multiplyScalar(factor);
    const [bar, ...tips] = this.trace, ends = [1, -1].map((s) => centre.clone().addScaledVector(amplitudeVector, s));
    const isVisible = amplitudeVector.length() > 0.004 * data.size;
    this.trace.forEach((part) => { part.visible = isVisible; });
    if (isVisible) {
      stretch(bar, ends[0], ends[1], 0.0022 * data.size);
      const direction = amplitudeVector.clone().normalize();
      tips.forEach((cone, i) => {
        const sign = i ? -1 : 1;
        stretch(cone, ends[i], ends[i].clone().addScaledVector(direction, sign * 0.022 * data.size), 0.0075 * data.size);
      });
    }
    if (this.labels.visible) this.arrangeLabels();
    this.renderer.render(this.world, this.camera);
    this.dirty = false;
  }
}

function labelSprite(text, palette, position) {
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
  sprite.position.copy(position);
  sprite.scale.set((0.023 * canvas.width) / canvas.height, 0.023, 1);
  sprite.renderOrder = 3;
  return sprite;
}
