// Controls, texts and table around the picture, updated for each state and mode.

// A component of a pose [SI] as text, with as many decimals as in page.py.
function formatPoseValue(value, unit) {
  if (unit === "m") return `${formatFixed(1000 * value, 1)} mm`;
  if (unit === "rad") return `${formatFixed((180 * value) / Math.PI, 1)} deg`;
  return `${formatFixed(value, 1)} ${unit}`;
}

// The springs with the largest share of a mode, as in page.py: by symmetry there may be several.
function largestSharesText(shares, springs) {
  const largest = Math.max(...shares), names = springs.filter((_, i) => shares[i] > largest - EQUAL_SHARE_TOLERANCE);
  const [preceding, last] = [names.slice(0, -1), names.at(-1)];
  const springNames = preceding.length ? `each of ${preceding.join(", ")} and ${last}` : last;
  return `${formatFixed(100 * largest, 0)} % of the strain energy in ${springNames}`;
}

// What moves, and where to, as in mode_words.py: what rounds to 0 is left out.
function motionText(bodies, components, direction) {
  const moving = direction.map((_, k) => k).filter((k) => formatFixed(direction[k], 2) !== formatFixed(0, 2));
  if (!moving.length) {
    const names = [...new Set(bodies)];
    return names.length > 1 ? `${names.slice(0, -1).join(", ")} and ${names.at(-1)} do not move` : `${names[0]} does not move`;
  }
  return [...new Set(moving.map((k) => bodies[k]))].map((body) => {
    const verbs = [["moves along", false], ["turns about", true]].map(([verb, isTurn]) => {
      const parts = moving.filter((k) => bodies[k] === body && components[k].startsWith("about") === isTurn);
      const shares = parts.map((k) => components[k].replace("about ", "") + (moving.length > 1 ? ` ${formatFixed(direction[k], 2)}` : ""));
      return shares.length ? `${verb} ${shares.join(", ")}` : "";
    });
    return `${body} ${verbs.filter(Boolean).join(" and ")}`;
  }).join("; ");
}

// Which vibration modes have the frequency of one, as in mode_words.py: their shapes are then only examples.
function coincidenceText(frequencies, rigid, mode) {
  const tolerance = SAME_FREQUENCY * Math.abs(frequencies[mode]);
  const partners = frequencies.map((_, k) => k).filter(
    (k) => k >= rigid && k !== mode && Math.abs(frequencies[k] - frequencies[mode]) <= tolerance,
  ).map((k) => k - rigid + 1);
  if (!partners.length) return "";
  const isOne = partners.length === 1, numbers = isOne ? partners[0] : `${partners.slice(0, -1).join(", ")} and ${partners.at(-1)}`;
  return `; mode${isOne ? "" : "s"} ${numbers} ${isOne ? "has" : "have"} the same frequency: any mixture is a mode, too`;
}

// What gravity makes of a motion that strains no spring.
function gravityText(frequency) {
  if (Math.abs(frequency) < 0.005) return "";
  return frequency > 0 ? `; with gravity it swings at ${formatFixed(frequency, 2)} Hz` : "; with gravity it falls away";
}

// Decimals of a value beside its standard deviation, which has two digits.
function decimalsOf(sigma) {
  return Math.max(0, Math.min(4, 1 - Math.floor(Math.log10(sigma))));
}

// At most so many decimals, without zeros at the end.
function formatRounded(value, digits) {
  return String(Number(value.toFixed(digits)) + 0).replace("-", "\u2212");
}

// A value of an axis: a component of the pose, or a parameter of any magnitude.
function formatAxisValue(axis, value) {
  if (!axis.name.includes(".")) return formatPoseValue(value, axis.unit);
  const text = String(Number(value.toPrecision(4))).replace("-", "\u2212");
  return axis.unit === "1" ? text : `${text} ${axis.unit}`;
}

// Two significant digits.
function formatTwoDigits(value) {
  return String(Number(value.toPrecision(2)));
}

// So many decimals, without a minus sign for a value that rounds to zero.
function formatFixed(value, digits) {
  return (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits).replace("-", "\u2212");
}

// Shares of the strain energy that differ by less count as equal, as in page.py.
const EQUAL_SHARE_TOLERANCE = 0.0005;
// The frequency of a motion that strains no spring, as in mode_words.py.
const RIGID_FREQUENCY = "0 Hz";
// Relative difference of frequencies that are one, as in mode_words.py.
const SAME_FREQUENCY = 1e-5;
// Amplitude, as a share of the robot's size, from which a note explains the exaggeration.
const LARGE_AMPLITUDE = 0.1;

// The measured mode that is paired with a mode of the model at a state; null where there is none.
function measuredMode(data, state, mode) {
  if (!data.measured || !state.exact) return null;
  return data.measured.modes.find((measured) => measured.pose === state.nearest && measured.mode === mode) || null;
}

class Panel {
  constructor(root, data) {
    this.root = root;
    this.data = data;
    this.find = (name) => root.querySelector(`[data-part="${name}"]`);
    this.findAll = (name) => [...root.querySelectorAll(`[data-part="${name}"]`)];
    this.cycles = 0.5;
  }

  // Set sliders, frequencies and table to a state.
  showState(state) {
    const { data } = this;
    if (state.gridPosition) this.setSliders(state.gridPosition);
    if (this.find("pose")) this.find("pose").value = state.nearest;
    this.findAll("place").forEach((part) => { part.textContent = this.poseText(state); });
    if (this.find("between")) {
      const computed = `Computed for ${data.varied ? "these values" : "this pose"}.`;
      this.find("between").textContent = state.exact ? computed : this.interpolationText(state);
    }
    this.findAll("frequency").forEach((part) => {
      part.textContent = this.frequencyText(state, Number(part.dataset.mode), "sigma" in part.dataset);
    });
    this.findAll("share").forEach((cell) => {
      const shares = state.shares[Number(cell.dataset.mode)];  // null where no spring is strained
      const share = shares === null ? 0 : shares[Number(cell.dataset.spring)];
      cell.textContent = shares === null ? "\u2013" : formatFixed(100 * share, 1);
      cell.style.setProperty("--share", share.toFixed(3));
    });
    this.findAll("direction").forEach((cell) => {
      cell.textContent = formatFixed(state.directions[Number(cell.dataset.mode)][Number(cell.dataset.component)], 2);
    });
  }

  setSliders(gridPosition) {
    const { data } = this;
    this.findAll("level").forEach((slider, i) => {
      const value = axisValues(data, gridPosition)[i];
      slider.value = Math.round(SLIDER_STEPS * gridPosition[i]);
      const text = formatAxisValue(data.axes[i], value);
      slider.setAttribute("aria-valuetext", text);
      this.findAll("level-value")[i].textContent = text;
    });
  }

  // The pose in words: its label and its components, then the values of parameters that vary.
  poseText(state) {
    const { data } = this, label = state.exact ? data.labels[state.nearest] : undefined;
    const parts = data.pose.map((c, i) => `${c.name} = ${formatPoseValue(state.pose[i], c.unit)}`);
    if (data.varied) {
      const values = axisValues(data, state.gridPosition);
      parts.push(...data.axes.map((c, i) => `${c.name} = ${formatAxisValue(c, values[i])}`));
    }
    const text = parts.join(", ");
    return `${label ? `${label}: ` : ""}${text}${state.exact ? "" : ", interpolated"}`;
  }

  interpolationText(state) {
    const error = state.deviation, kind = this.data.varied ? "values" : "poses";
    if (error === null) return `Interpolated between computed ${kind}; not checked here.`;
    const size = error < 1e-4 ? "less than 0.01" : `up to ${formatTwoDigits(100 * error)}`, note = this.data.checked;
    return `Interpolated between computed ${kind}: ${note ? `${note}, ` : ""}frequencies are off by ${size} %.`;
  }

  // A frequency, rounded by its standard deviation, and an interpolated one by its error; 0 for a rigid-body motion,
  // as in mode_words.py.
  frequencyText(state, mode, withSigma = false) {
    const value = state.frequencies[mode], sigma = state.sigmas ? state.sigmas[mode] : null;
    if (!state.shares[mode]) return RIGID_FREQUENCY;
    if (value < 0) return "unstable";
    const error = state.exact ? 0 : state.deviation === null ? 1 : state.deviation;
    const decimals = Math.min(sigma ? decimalsOf(sigma) : 2, error > 0.01 ? 0 : error > 0.0005 ? 1 : 4);
    const sigmaText = sigma && withSigma ? ` \u00b1 ${formatFixed(sigma, decimals)}` : "";
    return `${state.exact ? "" : "\u2248 "}${formatFixed(value, decimals)}${sigmaText} Hz`;
  }

  // Show the title, the strain energy and the direction of the chosen mode; `announce` also sets the status line.
  showMode(state, mode, amplitude, announce) {
    const { data } = this, frequency = state.frequencies[mode];
    const number = mode - data.rigid + 1, shares = state.shares[mode];
    const name = number > 0 ? `Mode ${number}` : `Rigid-body motion ${mode + 1}`;
    const motion = motionText(data.bodies, data.components, state.directions[mode]);
    const sameText = state.exact && number > 0 ? coincidenceText(state.frequencies, data.rigid, mode) : "";
    const sharesText = shares ? largestSharesText(shares, data.springs) + sameText : "no spring is strained";
    const frequencyText = this.frequencyText(state, mode, true);
    this.find("title").textContent = `${name}: ${frequencyText}`;
    this.find("held").textContent = sharesText;
    this.find("motion").textContent = motion[0].toUpperCase() + motion.slice(1);
    this.root.querySelectorAll("[data-column]").forEach((cell) => {
      cell.classList.toggle("pkview-chosen", Number(cell.dataset.column) === mode);
    });
    const gravityNote = shares ? "" : gravityText(frequency);
    const shapeNote = state.shapesDiffer[mode] ? " Shape of the nearest computed pose: there is none like it at all poses around." : "";
    if (announce) this.find("status").textContent = `${name}, ${frequencyText}: ${sharesText}${gravityNote}.${shapeNote}`;
    this.showMotion(shares ? frequency : 0, amplitude);
  }

  // Show the measured frequencies at the pose, and the components of the chosen mode as measured and in the model.
  showMeasured(state, mode, announce) {
    const { data } = this;
    if (!data.measured) return;
    this.findAll("beside").forEach((part) => {
      const chosen = measuredMode(data, state, Number(part.dataset.mode));
      part.textContent = chosen ? `measured ${this.measuredFrequencyText(chosen).replaceAll(" ", "\u00a0")}` : "not measured";
      part.classList.toggle("pkview-without", !chosen);
    });
    const chosen = measuredMode(data, state, mode), sentence = this.measuredText(chosen);
    this.find("observed").textContent = sentence;
    if (announce) this.find("status").textContent += ` ${sentence}`;
    const unmatched = data.measured.modes.filter((measured) => measured.pose === state.nearest && measured.mode === null);
    const frequencies = unmatched.map((measured) => this.measuredFrequencyText(measured)).join(", ");
    this.find("unmatched").textContent = frequencies ? `Measured, without a partner in the model: ${frequencies} Hz.` : "";
    const number = mode - data.rigid + 1, compared = !!chosen && chosen.shape;
    this.find("compared").textContent = `${number > 0 ? `mode ${number}` : "a rigid-body motion"} at ${this.poseText(state)}`;
    this.findAll("component").forEach((row, k) => {
      ["measured", "model"].forEach((part) => {
        const value = compared ? chosen[part][k] : null;
        row.querySelector(`[data-part="of-${part}"]`).textContent = value === null ? "\u2013" : formatFixed(value, 3);
      });
    });
  }

  // Show the frequencies of the declared robot beside those with the values of the sliders.
  showDeclared(state, mode, states) {
    if (!this.data.varied) return;
    this.findAll("beside").forEach((part) => {
      const partMode = Number(part.dataset.mode), declared = states.declaredMode(state, partMode).frequency;
      part.textContent = partMode < this.data.rigid ? "" : `declared ${formatFixed(declared, 2)}`;
      part.classList.add("pkview-without");
    });
    const { frequency } = states.declaredMode(state, mode), change = state.frequencies[mode] / frequency - 1;
    const isKnown = Number.isFinite(change) && mode >= this.data.rigid;
    const changeText = isKnown ? ` (${change > 0 ? "+" : ""}${formatFixed(100 * change, 1)} %)` : "";
    const frequencyText = mode < this.data.rigid ? RIGID_FREQUENCY : `${formatFixed(frequency, 2)} Hz`;
    this.find("declared").textContent = `, ${frequencyText}${changeText}`;
  }

  // Frequency and standard deviation, with two digits of the latter.
  measuredFrequencyText(measured) {
    const digits = decimalsOf(measured.sigma);
    return `${formatFixed(measured.frequency, digits)} \u00b1 ${formatFixed(measured.sigma, digits)}`;
  }

  measuredText(measured) {
    if (!measured) return "Not measured at this pose.";
    const text = `Measured: ${this.measuredFrequencyText(measured)} Hz`;
    if (!measured.shape) return `${text}, without a shape.`;
    return `${text}${measured.mac === null ? "" : `, MAC ${formatFixed(measured.mac, 3)}`}.`;
  }

  // Show what the sliders of the motion are set to, and how much the picture enlarges and slows it.
  showMotion(frequency, amplitude) {
    const { data } = this, displacementText = `${formatRounded(1000 * amplitude * data.size, 1)} mm`;
    this.find("amplitude-value").textContent = `${formatRounded(100 * amplitude, 1)} %`;
    this.find("amplitude").setAttribute("aria-valuetext", `${formatRounded(100 * amplitude, 1)} percent of the robot's size`);
    this.find("speed-value").textContent = `${formatRounded(this.cycles, 2)} /s`;
    this.find("speed").setAttribute("aria-valuetext", `${formatRounded(this.cycles, 2)} periods per second`);
    const slowdown = Math.abs(frequency) / this.cycles;
    const slowdownText = slowdown > 1.05 ? `, slowed down ${formatRounded(slowdown, slowdown < 10 ? 1 : 0)} times` : "";
    const linearityNote = amplitude >= LARGE_AMPLITUDE ? " So large, a linear displacement visibly changes the length of rigid links; the machine does not." : "";
    this.find("enlarged").textContent = `The largest displacement is shown as ${displacementText}${slowdownText}.${linearityNote}`;
  }

  showPlaying(isPlaying) {
    const button = this.find("play");
    button.setAttribute("aria-pressed", String(isPlaying));
    button.querySelector("span").textContent = isPlaying ? "Pause" : "Play";
  }
}
