// Meshes of the elements of a drawing.  Each has `place(points, rotations)`, which moves it to its points and turns
// it, and `paint(palette, share, isHighlighted)`, which colours it by its share of the strain energy; `share` is null
// for an element that is no spring.

const Y = new T.Vector3(0, 1, 0);
// Opacity of a plate that would hide springs from the usual direction.
const CLEAR_OPACITY = 0.45;

// Point i of a flat list of coordinates.
function pointAt(points, i) {
  return new T.Vector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
}

function createMaterial(options) {
  return new T.MeshStandardMaterial({ roughness: 0.55, metalness: 0.15, ...options });
}

function mesh(geometry, material) {
  return new T.Mesh(geometry, material);
}

const UNIT_BAR = new T.CylinderGeometry(1, 1, 1, 14);
const UNIT_BALL = new T.SphereGeometry(1, 20, 14);
const UNIT_BOX = new T.BoxGeometry(1, 1, 1);

// Place a bar between two points.
function stretch(bar, a, b, radius) {
  const axis = b.clone().sub(a), length = axis.length();
  bar.visible = length > 1e-9;
  if (!bar.visible) return;
  bar.position.copy(a).addScaledVector(axis, 0.5);
  bar.quaternion.setFromUnitVectors(Y, axis.divideScalar(length));
  bar.scale.set(radius, length, radius);
}

class Line {
  constructor(element, size) {
    this.element = element;
    this.radius = size * (RELATIVE_RADIUS[element.kind] || 0.006);
    this.material = createMaterial();
    this.group = new T.Group();
    this.bars = element.points.slice(1).map(() => mesh(UNIT_BAR, this.material));
    this.balls = element.points.map(() => mesh(UNIT_BALL, this.material));
    this.group.add(...this.bars, ...this.balls);
    this.widthFactor = 1;
  }

  place(points) {
    const radius = this.radius * this.widthFactor, positions = this.element.points.map((i) => pointAt(points, i));
    this.bars.forEach((bar, i) => stretch(bar, positions[i], positions[i + 1], radius));
    const ballRadius = this.element.kind === "link" ? 1.9 * radius : radius;
    this.balls.forEach((ball, i) => { ball.position.copy(positions[i]); ball.scale.setScalar(ballRadius); });
  }

  paint(palette, share, isHighlighted) {
    paintShare(this, palette, share, isHighlighted);
    this.widthFactor = (share === null ? 1 : 1 + 1.4 * share) * (isHighlighted ? 1.7 : 1);
  }
}

function paintShare(shape, palette, share, isHighlighted) {
  const { kind, marked } = shape.element;
  const plainColour = marked ? palette.marked : palette[COLOUR_OF_KIND[kind] || "body"];
  shape.material.color.set(share === null || marked ? plainColour : scaleColour(palette.scale, share));
  shape.material.emissive.set(share === null && !isHighlighted ? "#000000" : shape.material.color);
  shape.material.emissiveIntensity = isHighlighted ? 0.7 : 0.25;
}

class Wheel {
  constructor(element, size) {
    this.element = element;
    this.size = size;
    this.material = createMaterial();
    this.marks = createMaterial();
    this.group = new T.Group();
    this.rim = mesh(new T.CylinderGeometry(1, 1, 1, 40), this.material);
    this.spokes = [0, 1].map(() => mesh(UNIT_BOX, this.marks));
    this.spokes[1].rotation.y = Math.PI / 2;
    this.group.add(this.rim);
    if (element.turns >= 0) this.group.add(...this.spokes);
  }

  place(points, rotations) {
    const [a, b] = this.element.points.slice(0, 2).map((i) => pointAt(points, i));
    const axis = b.sub(a), radius = axis.length();
    const thickness = Math.max(0.3 * radius, 0.006 * this.size);
    this.group.position.copy(a);
    this.group.quaternion.setFromUnitVectors(Y, axis.normalize());
    if (this.element.turns >= 0) this.group.rotateY(rotations[this.element.turns]);
    this.rim.scale.set(radius, thickness, radius);
    this.spokes.forEach((spoke) => spoke.scale.set(1.7 * radius, 1.12 * thickness, 0.16 * radius));
  }

  paint(palette, share, isHighlighted) {
    paintShare(this, palette, share, isHighlighted);
    this.marks.color.set(palette.mark);
  }
}

class Block {
  constructor(element, size, vertical) {
    this.element = element;
    this.vertical = vertical;
    this.material = createMaterial();
    this.group = mesh(UNIT_BOX, this.material);
  }

  place(points) {
    const [a, b] = this.element.points.slice(0, 2).map((i) => pointAt(points, i));
    const axis = b.sub(a), half = axis.length(), x = axis.normalize();
    let z = this.vertical.clone().addScaledVector(x, -this.vertical.dot(x));
    if (z.length() < 0.1) z = new T.Vector3(x.y, x.z, x.x).cross(x);
    z.normalize();
    this.group.quaternion.setFromRotationMatrix(new T.Matrix4().makeBasis(x, z.clone().cross(x), z));
    this.group.position.copy(a);
    this.group.scale.set(2 * half, 1.3 * half, 1.3 * half);
  }

  paint(palette, share, isHighlighted) {
    paintShare(this, palette, share, isHighlighted);
  }
}

class Ball {
  constructor(element, size) {
    this.element = element;
    this.material = createMaterial();
    this.group = mesh(UNIT_BALL, this.material);
    this.group.scale.setScalar(size * (RELATIVE_RADIUS[element.kind] || 0.01));
  }

  place(points) {
    this.group.position.copy(pointAt(points, this.element.points[0]));
  }

  paint(palette, share, isHighlighted) {
    paintShare(this, palette, share, isHighlighted);
  }
}

// The convex hull of points in a plane, as a slab; a disc where the points coincide or lie on a line.
class Plate {
  constructor(element, size, vertical) {
    this.element = element;
    this.size = size;
    this.vertical = vertical;
    const clear = { transparent: true, opacity: CLEAR_OPACITY, depthWrite: false }; // a spring behind shines through
    this.material = createMaterial({ side: T.DoubleSide, ...(element.clear ? clear : {}) });
    this.group = new T.Group();
    this.slab = mesh(new T.BufferGeometry(), this.material);
    this.disc = mesh(new T.CylinderGeometry(1, 1, 1, 40), this.material);
    this.group.add(this.slab, this.disc);
    this.hull = null;
  }

  setRestPoints(points) {
    const positions = this.element.points.map((i) => pointAt(points, i));
    this.normal = planeNormal(positions, this.size) || this.vertical;
    this.hull = planeNormal(positions, this.size) ? convexHull(positions, this.normal) : [];
  }

  place(points) {
    const positions = this.element.points.map((i) => pointAt(points, i));
    const centre = positions.reduce((sum, p) => sum.add(p), new T.Vector3()).divideScalar(positions.length);
    const thickness = 0.011 * this.size;
    this.slab.visible = this.hull.length > 2;
    if (this.slab.visible) this.fill(this.hull.map((i) => positions[i]), this.normal.clone().multiplyScalar(thickness / 2));
    this.disc.visible = this.element.kind === "platform";
    this.disc.position.copy(centre);
    this.disc.quaternion.setFromUnitVectors(Y, this.normal);
    this.disc.scale.set(0.03 * this.size, 1.7 * thickness, 0.03 * this.size);
  }

  fill(outline, offset) {
    const [top, bottom] = [1, -1].map((s) => outline.map((p) => p.clone().addScaledVector(offset, s)));
    const corners = [], n = outline.length;
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

  paint(palette, share, isHighlighted) {
    paintShare(this, palette, share, isHighlighted);
  }
}

// Normal of the plane of points: that of the largest triangle with the first one; null where they nearly lie on a
// line.
function planeNormal(positions, size) {
  let largest = new T.Vector3();
  for (let i = 1; i < positions.length; i++) {
    for (let k = i + 1; k < positions.length; k++) {
      const cross = positions[i].clone().sub(positions[0]).cross(positions[k].clone().sub(positions[0]));
      if (cross.length() > largest.length() * (1 + 1e-9)) largest = cross;
    }
  }
  return largest.length() > 1e-5 * size * size ? largest.normalize() : null;
}

// Indices of the convex hull of points, in order around a normal (Andrew's monotone chain).
function convexHull(positions, normal) {
  const u = new T.Vector3(normal.y, normal.z, normal.x).cross(normal).normalize(), v = normal.clone().cross(u);
  const projected = positions.map((p, i) => [p.dot(u), p.dot(v), i]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const halfChain = (list) => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1) {
        const [a, b] = chain.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...halfChain(projected), ...halfChain(projected.slice().reverse())].map((p) => p[2]);
}

// Marks of the measured components at the sensors, drawn over everything else, which move as measured.
class MeasuredMarks {
  constructor(size) {
    this.size = size;
    this.material = new T.MeshBasicMaterial({ transparent: true, opacity: 0.85, depthTest: false });
    this.group = new T.Group();
    this.group.renderOrder = 4;
  }

  // Make the marks of a measured mode; none for null.
  show(mode, elements) {
    this.group.clear();
    this.arrows = ((mode && mode.arrows) || []).map(([point, ...displacement]) => {
      const parts = [mesh(UNIT_BALL, this.material), mesh(UNIT_BAR, this.material)];
      parts[0].scale.setScalar(0.013 * this.size);
      return { point, displacement: new T.Vector3(...displacement), parts };
    });
    this.turns = ((mode && mode.turns) || []).map(([element, angle]) => {
      return { wheel: elements[element], angle, parts: [mesh(UNIT_BOX, this.material)] };
    });
    [...this.arrows, ...this.turns].forEach(({ parts }) => this.group.add(...parts));
    this.group.children.forEach((part) => { part.renderOrder = 4; });
  }

  // Move the marks to a phase of the motion, from -1 to 1; `factor` turns displacements of the data into those shown.
  place(rest, factor, phase) {
    this.arrows.forEach(({ point, displacement: displacement, parts: [ball, bar] }) => {
      const position = pointAt(rest, point), reach = displacement.clone().multiplyScalar(factor);
      stretch(bar, position.clone().sub(reach), position.clone().add(reach), 0.0032 * this.size);
      ball.position.copy(position).addScaledVector(reach, phase);
    });
    this.turns.forEach(({ wheel, angle, parts: [bar] }) => {
      const [a, b] = wheel.points.map((i) => pointAt(rest, i)), axis = b.sub(a), radius = axis.length();
      bar.position.copy(a);
      bar.quaternion.setFromUnitVectors(Y, axis.normalize());
      bar.rotateY(angle * factor * phase);
      bar.scale.set(2.5 * radius, 0.1 * radius, 0.14 * radius);
    });
  }
}

const SHAPES = { line: Line, wheel: Wheel, block: Block, plate: Plate, ball: Ball };
