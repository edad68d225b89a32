// The states of a page: those that were evaluated, and those between them.  A state is the robot at a pose, with its
// modes; a grid of states is interpolated linearly along each of its axes.

// Steps of a slider from one evaluated state to the next.
const FINE = 10;
// Below this squared cosine two shapes are not one mode, and only the nearest one is shown.
const ALIKE = 0.5;

class States {
  constructor(data) {
    this.data = data;
    this.sizes = data.levels ? data.levels.map((values) => values.length) : [];
    this.wheels = data.elements.filter((e) => e.turns >= 0);
    // The place of every state in the grid.
    // For every state the number that each of its modes carries.
    this.numbers = (data.order || []).map((order) => order.map((_, mode) => order.indexOf(mode)));
    this.grid = new Map();
    (data.places || []).forEach((state, flat) => { if (state >= 0) this.grid.set(state, this.unravelled(flat)); });
  }

  unravelled(flat) {
    const place = [];
    for (let i = this.sizes.length - 1; i >= 0; i--) {
      place.unshift(flat % this.sizes[i]);
      flat = Math.floor(flat / this.sizes[i]);
    }
    return place;
  }

  // The place of values of the axes, at the edge of the grid for values beyond it.
  placed(values) {
    return values.map((value, i) => {
      const levels = this.data.levels[i], last = levels.length - 1;
      if (!(value > levels[0])) return 0;
      const next = levels.findIndex((level) => level >= value);
      if (next < 0) return last;
      return next - (levels[next] - value) / (levels[next] - levels[next - 1]);
    });
  }

  // Evaluated states around a place with their weights; null where the robot cannot be at one of them.
  around(place) {
    let corners = [{ flat: 0, weight: 1 }];
    place.forEach((at, i) => {
      const low = Math.floor(at + 1e-9), part = at - low > 1e-9 ? at - low : 0;
      const ends = part ? [[low, 1 - part], [low + 1, part]] : [[low, 1]];
      corners = corners.flatMap(({ flat, weight }) => ends.map(([k, w]) => ({ flat: flat * this.sizes[i] + k, weight: weight * w })));
    });
    const found = corners.map(({ flat, weight }) => ({ state: this.data.places[flat], weight }));
    return found.every(({ state }) => state >= 0) ? found : null;
  }

  // The reachable place nearest to a wanted one; with `fixed`, among those with the same value of that axis if any.
  nearest(wanted, fixed = -1) {
    if (this.around(wanted)) return wanted;
    const best = this.search(wanted, fixed);
    return best || this.search(wanted, -1);
  }

  search(wanted, fixed) {
    let best = null, least = Infinity;
    const place = wanted.slice();
    const along = (axis, distance) => {
      if (distance >= least) return;
      if (axis === place.length) {
        if (this.around(place)) { best = place.slice(); least = distance; }
        return;
      }
      if (axis === fixed) { along(axis + 1, distance); return; }
      const steps = FINE * (this.sizes[axis] - 1);
      for (let k = 0; k <= steps; k++) {
        place[axis] = k / FINE;
        along(axis + 1, distance + (place[axis] - wanted[axis]) ** 2);
      }
      place[axis] = wanted[axis];
    };
    along(0, 0);
    return best;
  }

  // The robot at one of the evaluated states.
  evaluated(state) {
    const { data } = this;
    return {
      exact: true, nearest: state, place: this.grid.get(state) || null, numbers: this.numbers[state] || null, pose: data.poses[state],
      points: data.points[state], frequencies: data.frequencies[state], moved: data.moved[state],
      turned: data.turned[state], shares: data.shares[state], directions: data.directions[state],
      apart: data.frequencies[state].map(() => false),
    };
  }

  // The robot at a place of the grid: exact at an evaluated state, interpolated between them.
  at(place) {
    const corners = this.around(place);
    const nearest = corners.reduce((best, one) => (one.weight > best.weight + 1e-9 ? one : best)).state;
    if (corners.length === 1) return this.evaluated(nearest);
    const { data } = this, sum = (of) => mixed(corners.map(({ state, weight }) => [of(state), weight]));
    const points = sum((s) => data.points[s]);
    const modes = data.order[nearest].map((_, number) => this.interpolated(points, corners, nearest, number));
    const sorted = [...modes.slice(0, data.rigid), ...modes.slice(data.rigid).sort((a, b) => a.frequency - b.frequency)];
    const each = (key) => sorted.map((mode) => mode[key]);
    return {
      exact: false, nearest, place, pose: sum((s) => data.poses[s]), points, deviation: this.deviation(place),
      frequencies: each("frequency"), moved: each("moved"), turned: each("turned"), shares: each("shares"),
      directions: each("directions"), numbers: each("number"), apart: each("apart"),
    };
  }

  // How far frequencies between states are off about here, where it was checked; null where it was not.
  deviation(place) {
    let flat = 0;
    place.forEach((at, i) => {
      const low = Math.floor(at + 1e-9);
      flat = flat * (2 * this.sizes[i] - 1) + 2 * low + (at - low > 1e-9 ? 1 : 0);
    });
    return this.data.deviations[flat];
  }

  // The mode of one number, between the modes of this number at all corners, with the sign of the nearest.
  interpolated(points, corners, nearest, number) {
    const { data } = this, own = data.order[nearest][number];
    const shape = (s, m) => [...data.moved[s][m], ...data.turned[s][m].map((angle) => angle * this.rim(data.points[s]))];
    const here = shape(nearest, own), pairs = corners.map(({ state: s, weight }) => {
      const m = data.order[s][number], other = shape(s, m), product = dot(here, other);
      return { s, m, weight, sign: Math.sign(product) || 1, alike: product ** 2 / (dot(here, here) * dot(other, other) || 1) };
    });
    const vibration = number >= data.rigid, apart = vibration && pairs.some((pair) => pair.alike < ALIKE);
    const mode = {
      frequency: frequency(pairs.map(({ s, m, weight }) => [data.frequencies[s][m], weight])), apart,
      number, moved: data.moved[nearest][own], turned: data.turned[nearest][own], shares: data.shares[nearest][own],
      directions: data.directions[nearest][own],
    };
    if (!vibration || apart) return mode; // the shape is that of the nearest state
    const sum = (of) => mixed(pairs.map(({ s, m, weight, sign }) => [of(s, m), weight, sign]));
    const moved = sum((s, m) => data.moved[s][m]), turned = sum((s, m) => data.turned[s][m]);
    const scale = 1 / (this.largest(points, moved, turned) || 1);
    const along = sum((s, m) => data.directions[s][m]), size = Math.hypot(...along) || 1;
    return {
      ...mode, moved: moved.map((v) => v * scale), turned: turned.map((v) => v * scale), directions: along.map((v) => v / size),
      shares: pairs.some(({ s, m }) => !data.shares[s][m]) ? data.shares[nearest][own] : mixed(pairs.map(({ s, m, weight }) => [data.shares[s][m], weight])),
    };
  }

  // The mode of the declared robot that continues one of a state, and the sign of its shape; null without one.
  declared(state, mode) {
    const { data } = this, index = data.declared;
    if (index === null) return null;
    const own = data.order[index][state.numbers[mode]], moved = data.moved[index][own];
    return {
      frequency: data.frequencies[index][own], moved, points: data.points[index],
      sign: Math.sign(dot(state.moved[mode], moved)) || 1,
    };
  }

  rim(points) {
    return this.wheels.length ? reach(points, this.wheels[0]) : 0;
  }

  // The largest displacement of a point or of the rim of a wheel.
  largest(points, moved, turned) {
    let most = 0;
    for (let i = 0; i < moved.length; i += 3) most = Math.max(most, Math.hypot(moved[i], moved[i + 1], moved[i + 2]));
    this.wheels.forEach((wheel) => { most = Math.max(most, reach(points, wheel) * Math.abs(turned[wheel.turns])); });
    return most;
  }
}

// Between states compliances are interpolated, not frequencies: see interpolation.py, which checks what comes out.
function frequency(parts) {
  if (parts.some(([f]) => f <= 0)) return parts.reduce((sum, [f, weight]) => sum + weight * f, 0);
  return parts.reduce((sum, [f, weight]) => sum + weight / (f * f), 0) ** -0.5;
}

function reach(points, wheel) {
  const [a, b] = wheel.points;
  return Math.hypot(...[0, 1, 2].map((k) => points[3 * b + k] - points[3 * a + k]));
}

function dot(a, b) {
  return a.reduce((sum, value, i) => sum + value * b[i], 0);
}

// Values of the axes at a place, which counts in levels and may be between them.
function valuesAt(data, place) {
  return place.map((at, i) => {
    const values = data.levels[i], low = Math.min(Math.floor(at), values.length - 1), part = at - low;
    return part > 1e-9 ? values[low] + part * (values[low + 1] - values[low]) : values[low];
  });
}

// The weighted sum of lists: of [list, weight, sign].
function mixed(parts) {
  return parts[0][0].map((_, i) => parts.reduce((sum, [list, weight, sign = 1]) => sum + weight * sign * list[i], 0));
}
