// Meshes of the elements of a drawing.  Each has `place(points, turned)`, which moves it to the points given, and
// `paint(palette, share)`, which colours it; `share` is null for an element that is no spring.

const Y = new T.Vector3(0, 1, 0);

function vector(points, i) {
  return new T.Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
}

function material(options) {
  return new T.MeshStandardMaterial({ roughness: 0.55, metalness: 0.15, ...options });
}

function mesh(geometry, own) {
  return new T.Mesh(geometry, own);
}

const UNIT_BAR = new T.CylinderGeometry(1, 1, 1, 14);
const UNIT_BALL = new T.SphereGeometry(1, 20, 14);
const UNIT_BOX = new T.BoxGeometry(1, 1, 1);

function stretch(bar, a, b, radius) {
  const along = b.clone().sub(a), length = along.length();
  bar.visible = length > 1e-9;
  if (!bar.visible) return;
  bar.position.copy(a).addScaledVector(along, 0.5);
  bar.quaternion.setFromUnitVectors(Y, along.divideScalar(length));
  bar.scale.set(radius, length, radius);
}

class Line {
  constructor(element, size) {
    this.element = element;
    this.radius = size * (THICKNESS[element.kind] || 0.006);
    this.material = material();
    this.group = new T.Group();
    this.bars = element.points.slice(1).map(() => mesh(UNIT_BAR, this.material));
    this.balls = element.points.map(() => mesh(UNIT_BALL, this.material));
    this.group.add(...this.bars, ...this.balls);
    this.wide = 1;
  }

  place(points) {
    const radius = this.radius * this.wide, at = this.element.points.map((i) => vector(points, i));
    this.bars.forEach((bar, i) => stretch(bar, at[i], at[i + 1], radius));
    const round = this.element.kind === "link" ? 1.9 * radius : radius;
    this.balls.forEach((ball, i) => { ball.position.copy(at[i]); ball.scale.setScalar(round); });
  }

  paint(palette, share, lit) {
    paintShare(this, palette, share, lit);
    this.wide = (share === null ? 1 : 1 + 1.4 * share) * (lit ? 1.7 : 1);
  }
}

function paintShare(shape, palette, share, lit) {
  const { kind, marked } = shape.element;
  const own = marked ? palette.marked : palette[OF_KIND[kind] || "body"];
  shape.material.color.set(share === null || marked ? own : onScale(palette.scale, share));
  shape.material.emissive.set(share === null && !lit ? "#000000" : shape.material.color);
  shape.material.emissiveIntensity = lit ? 0.7 : 0.25;
}

class Wheel {
  constructor(element, size) {
    this.element = element;
    this.size = size;
    this.material = material();
    this.marks = material();
    this.group = new T.Group();
    this.rim = mesh(new T.CylinderGeometry(1, 1, 1, 40), this.material);
    this.spokes = [0, 1].map(() => mesh(UNIT_BOX, this.marks));
    this.spokes[1].rotation.y = Math.PI / 2;
    this.group.add(this.rim);
    if (element.turns >= 0) this.group.add(...this.spokes);
  }

  place(points, turned) {
    const [a, b] = this.element.points.slice(0, 2).map((i) => vector(points, i));
    const axis = b.sub(a), radius = axis.length();
    const thick = Math.max(0.3 * radius, 0.006 * this.size);
    this.group.position.copy(a);
    this.group.quaternion.setFromUnitVectors(Y, axis.normalize());
    if (this.element.turns >= 0) this.group.rotateY(turned[this.element.turns]);
    this.rim.scale.set(radius, thick, radius);
    this.spokes.forEach((spoke) => spoke.scale.set(1.7 * radius, 1.12 * thick, 0.16 * radius));
  }

  paint(palette, share, lit) {
    paintShare(this, palette, share, lit);
    this.marks.color.set(palette.mark);
  }
}

class Block {
  constructor(element, size, vertical) {
    this.element = element;
    this.vertical = vertical;
    this.material = material();
    this.group = mesh(UNIT_BOX, this.material);
  }

  place(points) {
    const [a, b] = this.element.points.slice(0, 2).map((i) => vector(points, i));
    const along = b.sub(a), half = along.length(), x = along.normalize();
    let z = this.vertical.clone().addScaledVector(x, -this.vertical.dot(x));
    if (z.length() < 0.1) z = new T.Vector3(x.y, x.z, x.x).cross(x);
    z.normalize();
    this.group.quaternion.setFromRotationMatrix(new T.Matrix4().makeBasis(x, z.clone().cross(x), z));
    this.group.position.copy(a);
    this.group.scale.set(2 * half, 1.3 * half, 1.3 * half);
  }

  paint(palette, share, lit) {
    paintShare(this, palette, share, lit);
  }
}

class Ball {
  constructor(element, size) {
    this.element = element;
    this.material = material();
    this.group = mesh(UNIT_BALL, this.material);
    this.group.scale.setScalar(size * (THICKNESS[element.kind] || 0.01));
  }

  place(points) {
    this.group.position.copy(vector(points, this.element.points[0]));
  }

  paint(palette, share, lit) {
    paintShare(this, palette, share, lit);
  }
}

// The convex hull of points in a plane, as a slab; a disc where the points coincide or lie on a line.
class Plate {
  constructor(element, size, vertical) {
    this.element = element;
    this.size = size;
    this.vertical = vertical;
    this.material = material({ side: T.DoubleSide });
    this.group = new T.Group();
    this.slab = mesh(new T.BufferGeometry(), this.material);
    this.disc = mesh(new T.CylinderGeometry(1, 1, 1, 40), this.material);
    this.group.add(this.slab, this.disc);
    this.hull = null;
  }

  rest(points) {
    const at = this.element.points.map((i) => vector(points, i));
    this.normal = widest(at, this.size) || this.vertical;
    this.hull = widest(at, this.size) ? hullOf(at, this.normal) : [];
  }

  place(points) {
    const at = this.element.points.map((i) => vector(points, i));
    const centre = at.reduce((sum, p) => sum.add(p), new T.Vector3()).divideScalar(at.length);
    const thick = 0.011 * this.size;
    this.slab.visible = this.hull.length > 2;
    if (this.slab.visible) this.fill(this.hull.map((i) => at[i]), this.normal.clone().multiplyScalar(thick / 2));
    this.disc.visible = this.element.kind === "platform";
    this.disc.position.copy(centre);
    this.disc.quaternion.setFromUnitVectors(Y, this.normal);
    this.disc.scale.set(0.03 * this.size, 1.7 * thick, 0.03 * this.size);
  }

  fill(ring, half) {
    const [top, bottom] = [1, -1].map((s) => ring.map((p) => p.clone().addScaledVector(half, s)));
    const corners = [], n = ring.length;
    for (let i = 1; i + 1 < n; i++) {
      corners.push(top[0], top[i], top[i + 1], bottom[0], bottom[i + 1], bottom[i]);
    }
    for (let i = 0, k = 1; i < n; i++, k = (i + 1) % n) {
      corners.push(bottom[i], bottom[k], top[k], bottom[i], top[k], top[i]);
    }
    const flat = new Float32Array(corners.flatMap((p) => [p.x, p.y, p.z]));
    this.slab.geometry.setAttribute("position", new T.BufferAttribute(flat, 3));
    this.slab.geometry.computeVertexNormals();
    this.slab.geometry.computeBoundingSphere();
  }

  paint(palette, share, lit) {
    paintShare(this, palette, share, lit);
  }
}

// Normal of the largest triangle with the first point, null where there is none to speak of.
function widest(at, size) {
  let best = new T.Vector3();
  for (let i = 1; i < at.length; i++) {
    for (let k = i + 1; k < at.length; k++) {
      const cross = at[i].clone().sub(at[0]).cross(at[k].clone().sub(at[0]));
      if (cross.length() > best.length() * (1 + 1e-9)) best = cross;
    }
  }
  return best.length() > 1e-5 * size * size ? best.normalize() : null;
}

// Indices of the convex hull of points, in order around a normal (Andrew's monotone chain).
function hullOf(at, normal) {
  const u = new T.Vector3(normal.y, normal.z, normal.x).cross(normal).normalize(), w = normal.clone().cross(u);
  const flat = at.map((p, i) => [p.dot(u), p.dot(w), i]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const found = [];
    for (const p of list) {
      while (found.length > 1) {
        const [a, b] = found.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        found.pop();
      }
      found.push(p);
    }
    return found.slice(0, -1);
  };
  return [...half(flat), ...half(flat.slice().reverse())].map((p) => p[2]);
}

// Measured components beside the model: marks where the sensors are, over everything else, that move as measured.
class MeasuredMarks {
  constructor(size) {
    this.size = size;
    this.material = new T.MeshBasicMaterial({ transparent: true, opacity: 0.85, depthTest: false });
    this.group = new T.Group();
    this.group.renderOrder = 4;
  }

  // Marks for a measured mode, none for null.
  show(mode, elements) {
    this.group.clear();
    this.arrows = ((mode && mode.arrows) || []).map(([point, ...by]) => {
      const parts = [mesh(UNIT_BALL, this.material), mesh(UNIT_BAR, this.material)];
      parts[0].scale.setScalar(0.013 * this.size);
      return { point, by: new T.Vector3(...by), parts };
    });
    this.turns = ((mode && mode.turns) || []).map(([element, angle]) => {
      return { wheel: elements[element], angle, parts: [mesh(UNIT_BOX, this.material)] };
    });
    [...this.arrows, ...this.turns].forEach(({ parts }) => this.group.add(...parts));
    this.group.children.forEach((part) => { part.renderOrder = 4; });
  }

  // Place them at a phase of the motion, from -1 to 1, with the factor of the amplitude.
  place(rest, factor, phase) {
    this.arrows.forEach(({ point, by, parts: [ball, bar] }) => {
      const at = vector(rest, point), far = by.clone().multiplyScalar(factor);
      stretch(bar, at.clone().sub(far), at.clone().add(far), 0.0032 * this.size);
      ball.position.copy(at).addScaledVector(far, phase);
    });
    this.turns.forEach(({ wheel, angle, parts: [bar] }) => {
      const [a, b] = wheel.points.map((i) => vector(rest, i)), axis = b.sub(a), radius = axis.length();
      bar.position.copy(a);
      bar.quaternion.setFromUnitVectors(Y, axis.normalize());
      bar.rotateY(angle * factor * phase);
      bar.scale.set(2.5 * radius, 0.1 * radius, 0.14 * radius);
    });
  }
}

const SHAPES = { line: Line, wheel: Wheel, block: Block, plate: Plate, ball: Ball };
