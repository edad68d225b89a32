// The frequencies of a map, unpacked from the page, and the robots and poses that they belong to: see
// report/map_values.py, which packs them.

const MISSING = -0x80000000;

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Frequencies as integers in units of 10 ** -decimals Hz, by mode and then along the axes of the map; MISSING where
// there is none.  The page holds the bits of the missing values, then the four bytes of each zigzag-coded difference
// along the last axis, the lowest bytes of all values first.
function unpack(bytes, valueCount, rowLength) {
  const headerLength = Math.ceil(valueCount / 8), numbers = new Int32Array(valueCount);
  const plane = (i) => bytes.subarray(headerLength + i * valueCount, headerLength + (i + 1) * valueCount);
  const [byte0, byte1, byte2, byte3] = [plane(0), plane(1), plane(2), plane(3)];
  let current = 0;
  for (let i = 0; i < valueCount; i++) {
    const zigzag = (byte0[i] | (byte1[i] << 8) | (byte2[i] << 16) | (byte3[i] << 24)) >>> 0;
    current = ((i % rowLength ? current : 0) + ((zigzag >>> 1) ^ -(zigzag & 1))) | 0;
    numbers[i] = bytes[i >> 3] & (0x80 >> (i & 7)) ? MISSING : current;
  }
  return numbers;
}

// A map: the first axes are robots (of a sweep, or drawn at random), the last ones poses.  `indices` holds an index
// for every axis, `robotIndex` and `poseIndex` count through all robots and all poses.
class MapValues {
  constructor(data, bytes) {
    this.data = data;
    this.axes = data.axes;
    this.sizes = data.axes.map((axis) => axis.labels.length);
    this.valuesPerMode = this.sizes.reduce((product, size) => product * size, 1);
    this.firstPoseAxis = data.axes.findIndex((axis) => axis.kind !== "robot");
    this.poseCount = this.sizes.slice(this.firstPoseAxis).reduce((product, size) => product * size, 1);
    this.scaledFrequencies = unpack(bytes, this.valuesPerMode * data.modes.length, this.sizes.at(-1));
    this.unitsPerHertz = 10 ** data.decimals;
    // The axis of the map for each component of a pose; a list of poses has none.
    this.axisOf = data.components.map((c) => data.axes.findIndex((axis) => axis.kind === "pose" && axis.name === c.name));
  }

  // First and last index along each axis at which any pose of any robot can be evaluated.
  evaluatedRanges() {
    const ranges = this.sizes.map((size) => [size, -1]);
    for (let flatIndex = 0; flatIndex < this.valuesPerMode; flatIndex++) {
      if (!this.isValid(0, flatIndex)) continue;
      let remainder = flatIndex;
      for (let k = this.sizes.length - 1; k >= 0; k--) {
        const index = remainder % this.sizes[k];
        remainder = (remainder - index) / this.sizes[k];
        if (index < ranges[k][0]) ranges[k][0] = index;
        if (index > ranges[k][1]) ranges[k][1] = index;
      }
    }
    return ranges;
  }

  robotIndex(indices) {
    return this.flattenIndices(indices, 0, this.firstPoseAxis);
  }

  poseIndex(indices) {
    return this.flattenIndices(indices, this.firstPoseAxis, this.sizes.length);
  }

  flattenIndices(indices, firstAxis, endAxis) {
    let flatIndex = 0;
    for (let k = firstAxis; k < endAxis; k++) flatIndex = flatIndex * this.sizes[k] + indices[k];
    return flatIndex;
  }

  // A copy of `indices` with those of the pose axes set to a pose.
  withPose(indices, poseIndex) {
    const newIndices = indices.slice();
    for (let k = this.sizes.length - 1; k >= this.firstPoseAxis; k--) {
      newIndices[k] = poseIndex % this.sizes[k];
      poseIndex = (poseIndex - newIndices[k]) / this.sizes[k];
    }
    return newIndices;
  }

  // In units of 10 ** -decimals Hz.
  scaledFrequency(mode, robotIndex, poseIndex) {
    return this.scaledFrequencies[mode * this.valuesPerMode + robotIndex * this.poseCount + poseIndex];
  }

  // In Hz; NaN where there is none.
  frequency(mode, robotIndex, poseIndex) {
    const number = this.scaledFrequency(mode, robotIndex, poseIndex);
    return number === MISSING ? NaN : number / this.unitsPerHertz;
  }

  isValid(robotIndex, poseIndex) {
    return this.data.modes.some((_, mode) => this.scaledFrequency(mode, robotIndex, poseIndex) !== MISSING);
  }

  // Component k of a pose [SI].
  componentAt(k, poseIndex) {
    if (this.data.list) return this.data.list[k][poseIndex];
    return this.axes[this.axisOf[k]].values[this.withPose(this.sizes.map(() => 0), poseIndex)[this.axisOf[k]]];
  }

  pose(poseIndex) {
    return this.data.components.map((_, k) => this.componentAt(k, poseIndex));
  }

  // Index of the pose with the shortest distance among those that can be evaluated; -1 without one.
  nearestPose(robotIndex, distance) {
    let nearest = -1, shortest = Infinity;
    for (let poseIndex = 0; poseIndex < this.poseCount; poseIndex++) {
      const length = distance(poseIndex);
      if (length < shortest && this.isValid(robotIndex, poseIndex)) [nearest, shortest] = [poseIndex, length];
    }
    return nearest;
  }
}

function formatFixed(value, digits) {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "\u2212");
}
