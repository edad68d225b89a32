// The frequencies of a map as the page holds them, and the places at which they are: see report/map_values.py.

const MISSING = -0x80000000;

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Whole numbers of 10 ** -decimals Hz, by mode and then along the axes of the map; MISSING where there is none.
function unpacked(bytes, count, row) {
  const first = Math.ceil(count / 8), whole = new Int32Array(count);
  const plane = (k) => bytes.subarray(first + k * count, first + (k + 1) * count);
  const [a, b, c, d] = [plane(0), plane(1), plane(2), plane(3)];
  let held = 0;
  for (let i = 0; i < count; i++) {
    const code = (a[i] | (b[i] << 8) | (c[i] << 16) | (d[i] << 24)) >>> 0;
    held = ((i % row ? held : 0) + ((code >>> 1) ^ -(code & 1))) | 0;
    whole[i] = bytes[i >> 3] & (0x80 >> (i & 7)) ? MISSING : held;
  }
  return whole;
}

// A map: robots (of a sweep, or drawn) times places (poses), which are the last axes.
class MapValues {
  constructor(data, bytes) {
    this.data = data;
    this.axes = data.axes;
    this.sizes = data.axes.map((axis) => axis.labels.length);
    this.count = this.sizes.reduce((product, size) => product * size, 1);
    this.first = data.axes.findIndex((axis) => axis.kind !== "robot");
    this.places = this.sizes.slice(this.first).reduce((product, size) => product * size, 1);
    this.whole = unpacked(bytes, this.count * data.modes.length, this.sizes.at(-1));
    this.unit = 10 ** data.decimals;
    // The axis of the map for each component of a pose; a list of poses has none.
    this.axisOf = data.components.map((c) => data.axes.findIndex((axis) => axis.kind === "pose" && axis.name === c.name));
  }

  // First and last number along each axis at which any pose can be evaluated.
  reached() {
    const ends = this.sizes.map((size) => [size, -1]);
    for (let flat = 0; flat < this.count; flat++) {
      if (!this.valid(0, flat)) continue;
      let rest = flat;
      for (let k = this.sizes.length - 1; k >= 0; k--) {
        const at = rest % this.sizes[k];
        rest = (rest - at) / this.sizes[k];
        if (at < ends[k][0]) ends[k][0] = at;
        if (at > ends[k][1]) ends[k][1] = at;
      }
    }
    return ends;
  }

  robot(at) {
    return this.flat(at, 0, this.first);
  }

  place(at) {
    return this.flat(at, this.first, this.sizes.length);
  }

  flat(at, from, to) {
    let flat = 0;
    for (let k = from; k < to; k++) flat = flat * this.sizes[k] + at[k];
    return flat;
  }

  // Set the last numbers of `at` to a place.
  put(at, place) {
    const next = at.slice();
    for (let k = this.sizes.length - 1; k >= this.first; k--) {
      next[k] = place % this.sizes[k];
      place = (place - next[k]) / this.sizes[k];
    }
    return next;
  }

  number(mode, robot, place) {
    return this.whole[mode * this.count + robot * this.places + place];
  }

  frequency(mode, robot, place) {
    const number = this.number(mode, robot, place);
    return number === MISSING ? NaN : number / this.unit;
  }

  valid(robot, place) {
    return this.data.modes.some((_, mode) => this.number(mode, robot, place) !== MISSING);
  }

  // A component of the pose at a place [SI].
  component(k, place) {
    if (this.data.list) return this.data.list[k][place];
    return this.axes[this.axisOf[k]].values[this.put(this.sizes.map(() => 0), place)[this.axisOf[k]]];
  }

  pose(place) {
    return this.data.components.map((_, k) => this.component(k, place));
  }

  // The valid place with the least of a measure; -1 without one.
  least(robot, measure) {
    let best = -1, smallest = Infinity;
    for (let place = 0; place < this.places; place++) {
      const size = measure(place);
      if (size < smallest && this.valid(robot, place)) [best, smallest] = [place, size];
    }
    return best;
  }
}

function fixed(value, digits) {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}
