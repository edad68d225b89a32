// The states of a page.  A state is the robot at a pose (or with other values) and its modes.  Some states were
// evaluated in Python; between those of a grid, states are interpolated linearly along each axis.  A position in the
// grid counts in levels along each axis, 1.5 being half-way between two evaluated levels.

// Steps of a slider from one evaluated level to the next.
const SLIDER_STEPS = 10;
// Where two shapes have a smaller MAC they are not interpolated: the shape of the nearest evaluated state is shown.
const MIN_MAC = 0.5;

class States {
  constructor(data) {
    this.data = data;
    this.sizes = data.levels ? data.levels.map((values) => values.length) : [];
    this.wheels = data.elements.filter((e) => e.turns >= 0);
    // A mode is followed over the grid as a track: data.order[state][track] is its index among the modes of a state,
    // and tracks[state][mode] the track of a mode.
    this.tracks = (data.order || []).map((order) => order.map((_, mode) => order.indexOf(mode)));
    // The position of every evaluated state.
    this.positions = new Map();
    (data.places || []).forEach((state, flat) => { if (state >= 0) this.positions.set(state, this.gridIndices(flat)); });
  }

  gridIndices(flat) {
    const indices = [];
    for (let i = this.sizes.length - 1; i >= 0; i--) {
      indices.unshift(flat % this.sizes[i]);
      flat = Math.floor(flat / this.sizes[i]);
    }
    return indices;
  }

  // The position of values of the axes, at the edge of the grid for values beyond it.
  gridPositionOf(values) {
    return values.map((value, i) => {
      const levels = this.data.levels[i], last = levels.length - 1;
      if (!(value > levels[0])) return 0;
      const next = levels.findIndex((level) => level >= value);
      if (next < 0) return last;
      return next - (levels[next] - value) / (levels[next] - levels[next - 1]);
    });
  }

  // Evaluated states at the corners of the cell around a position, with their weights; null where one of them is
  // missing because the robot cannot be there.
  cornerStates(position) {
    let corners = [{ flat: 0, weight: 1 }];
    position.forEach((level, i) => {
      const low = Math.floor(level + 1e-9), fraction = level - low > 1e-9 ? level - low : 0;
      const ends = fraction ? [[low, 1 - fraction], [low + 1, fraction]] : [[low, 1]];
      corners = corners.flatMap(
        ({ flat, weight }) => ends.map(([k, w]) => ({ flat: flat * this.sizes[i] + k, weight: weight * w })),
      );
    });
    const states = corners.map(({ flat, weight }) => ({ state: this.data.places[flat], weight }));
    return states.every(({ state }) => state >= 0) ? states : null;
  }

  // The reachable position nearest to a requested one: if possible, with the requested level of `fixedAxis`.
  nearestReachable(requested, fixedAxis = -1) {
    if (this.cornerStates(requested)) return requested;
    return this.searchNearest(requested, fixedAxis) || this.searchNearest(requested, -1);
  }

  searchNearest(requested, fixedAxis) {
    let nearest = null, shortest = Infinity; // squared distance
    const position = requested.slice();
    const searchFrom = (axis, distance) => {
      if (distance >= shortest) return;
      if (axis === position.length) {
        if (this.cornerStates(position)) { nearest = position.slice(); shortest = distance; }
        return;
      }
      if (axis === fixedAxis) { searchFrom(axis + 1, distance); return; }
      const steps = SLIDER_STEPS * (this.sizes[axis] - 1);
      for (let k = 0; k <= steps; k++) {
        position[axis] = k / SLIDER_STEPS;
        searchFrom(axis + 1, distance + (position[axis] - requested[axis]) ** 2);
      }
      position[axis] = requested[axis];
    };
    searchFrom(0, 0);
    return nearest;
  }

  // One of the evaluated states.
  evaluatedState(state) {
    const { data } = this;
    return {
      exact: true, nearest: state, gridPosition: this.positions.get(state) || null, tracks: this.tracks[state] || null,
      pose: data.poses[state], points: data.points[state], frequencies: data.frequencies[state],
      sigmas: data.sigmas ? data.sigmas[state] : null,
      displacements: data.moved[state], rotations: data.turned[state], shares: data.shares[state],
      directions: data.directions[state], shapesDiffer: data.frequencies[state].map(() => false),
    };
  }

  // The state at a position in the grid: evaluated, or interpolated between those around it.
  stateAt(position) {
    const corners = this.cornerStates(position);
    const nearest = corners.reduce((best, corner) => (corner.weight > best.weight + 1e-9 ? corner : best)).state;
    if (corners.length === 1) return this.evaluatedState(nearest);
    const { data } = this, mean = (values) => weightedSum(corners.map(({ state, weight }) => [values[state], weight]));
    const points = mean(data.points);
    const modes = data.order[nearest].map((_, track) => this.interpolateMode(points, corners, nearest, track));
    const sorted = [...modes.slice(0, data.rigid), ...modes.slice(data.rigid).sort((a, b) => a.frequency - b.frequency)];
    const ofModes = (key) => sorted.map((mode) => mode[key]);
    return {
      exact: false, nearest, gridPosition: position, pose: mean(data.poses), points, deviation: this.deviation(position),
      frequencies: ofModes("frequency"), sigmas: data.sigmas ? ofModes("sigma") : null, displacements: ofModes("displacements"), rotations: ofModes("rotations"),
      shares: ofModes("shares"), directions: ofModes("directions"), tracks: ofModes("track"),
      shapesDiffer: ofModes("shapesDiffer"),
    };
  }

  // The largest known error of interpolated frequencies around a position; null where it was not checked.
  deviation(position) {
    let flat = 0;
    position.forEach((level, i) => {
      const low = Math.floor(level + 1e-9);
      flat = flat * (2 * this.sizes[i] - 1) + 2 * low + (level - low > 1e-9 ? 1 : 0);
    });
    return this.data.deviations[flat];
  }

  // The mode of a track, interpolated between its modes at all corners, with the sign of that at the nearest one.
  interpolateMode(points, corners, nearest, track) {
    const { data } = this, nearestMode = data.order[nearest][track];
    const shape = (s, m) => [...data.moved[s][m], ...data.turned[s][m].map((angle) => angle * this.rimRadius(data.points[s]))];
    const reference = shape(nearest, nearestMode), cornerModes = corners.map(({ state: s, weight }) => {
      const m = data.order[s][track], cornerShape = shape(s, m), product = dot(reference, cornerShape);
      const mac = product ** 2 / (dot(reference, reference) * dot(cornerShape, cornerShape) || 1);
      return { s, m, weight, sign: Math.sign(product) || 1, mac };
    });
    const isVibration = track >= data.rigid, shapesDiffer = isVibration && cornerModes.some(({ mac }) => mac < MIN_MAC);
    const mode = {
      frequency: meanFrequency(cornerModes.map(({ s, m, weight }) => [data.frequencies[s][m], weight])), shapesDiffer, track,
      sigma: data.sigmas ? cornerModes.reduce((sum, { s, m, weight }) => sum + weight * data.sigmas[s][m], 0) : null,
      displacements: data.moved[nearest][nearestMode], rotations: data.turned[nearest][nearestMode],
      shares: data.shares[nearest][nearestMode], directions: data.directions[nearest][nearestMode],
    };
    if (!isVibration || shapesDiffer) return mode; // the shape is that of the nearest state
    const mean = (values) => weightedSum(cornerModes.map(({ s, m, weight, sign }) => [values[s][m], weight, sign]));
    const displacements = mean(data.moved), rotations = mean(data.turned);
    const scale = 1 / (this.largestDisplacement(points, displacements, rotations) || 1);
    const direction = mean(data.directions), length = Math.hypot(...direction) || 1;
    const hasShares = cornerModes.every(({ s, m }) => data.shares[s][m]);
    return {
      ...mode, displacements: displacements.map((v) => v * scale), rotations: rotations.map((v) => v * scale),
      directions: direction.map((v) => v / length),
      shares: hasShares ? weightedSum(cornerModes.map(({ s, m, weight }) => [data.shares[s][m], weight])) : mode.shares,
    };
  }

  // The mode of the declared robot on the track of a mode, and the sign that its shape needs to agree with that
  // mode's; null where no values vary.
  declaredMode(state, mode) {
    const { data } = this, index = data.declared;
    if (index === null) return null;
    const partner = data.order[index][state.tracks[mode]], displacements = data.moved[index][partner];
    return {
      frequency: data.frequencies[index][partner], displacements, points: data.points[index],
      sign: Math.sign(dot(state.displacements[mode], displacements)) || 1,
    };
  }

  rimRadius(points) {
    return this.wheels.length ? wheelRadius(points, this.wheels[0]) : 0;
  }

  // The largest displacement of a point or of the rim of a wheel.
  largestDisplacement(points, displacements, rotations) {
    let largest = 0;
    for (let i = 0; i < displacements.length; i += 3) largest = Math.max(largest, Math.hypot(...displacements.slice(i, i + 3)));
    this.wheels.forEach((wheel) => {
      largest = Math.max(largest, wheelRadius(points, wheel) * Math.abs(rotations[wheel.turns]));
    });
    return largest;
  }
}

// Mean of [frequency, weight].  Compliances are interpolated, not frequencies: see interpolation.py, which also
// computes the errors of this.
function meanFrequency(parts) {
  if (parts.some(([f]) => f <= 0)) return parts.reduce((sum, [f, weight]) => sum + weight * f, 0);
  return parts.reduce((sum, [f, weight]) => sum + weight / (f * f), 0) ** -0.5;
}

function wheelRadius(points, wheel) {
  const [a, b] = wheel.points;
  return Math.hypot(...[0, 1, 2].map((k) => points[3 * b + k] - points[3 * a + k]));
}

function dot(a, b) {
  return a.reduce((sum, value, i) => sum + value * b[i], 0);
}

// Values of the axes at a position in the grid.
function axisValues(data, position) {
  return position.map((level, i) => {
    const values = data.levels[i], low = Math.min(Math.floor(level), values.length - 1), fraction = level - low;
    return fraction > 1e-9 ? values[low] + fraction * (values[low + 1] - values[low]) : values[low];
  });
}

// The weighted sum of lists, each given as [list, weight, sign].
function weightedSum(parts) {
  return parts[0][0].map((_, i) => parts.reduce((sum, [list, weight, sign = 1]) => sum + weight * sign * list[i], 0));
}
