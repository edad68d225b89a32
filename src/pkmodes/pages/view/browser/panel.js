// Controls and table around the picture: what they say follows the pose and the mode.

// A component of the pose, with as many decimals as in page.py.
function shown(value, unit) {
  if (unit === "m") return `${fixed(1000 * value, 1)} mm`;
  if (unit === "rad") return `${fixed((180 * value) / Math.PI, 1)} deg`;
  return `${fixed(value, 1)} ${unit}`;
}

// The springs with the largest share of a mode, as in page.py: by symmetry there may be several.
function heldBy(shares, springs) {
  const most = Math.max(...shares), names = springs.filter((_, i) => shares[i] > most - TIED);
  const [rest, last] = [names.slice(0, -1), names.at(-1)];
  const where = rest.length ? `each of ${rest.join(", ")} and ${last}` : last;
  return `${fixed(100 * most, 0)} % of the strain energy in ${where}`;
}

function tidy(value, digits) {
  return String(Number(value.toFixed(digits)) + 0).replace("-", "\u2212");
}

// A component of the pose, or a parameter of any size.
function component(axis, value) {
  if (!axis.name.includes(".")) return shown(value, axis.unit);
  const text = String(Number(value.toPrecision(4))).replace("-", "\u2212");
  return axis.unit === "1" ? text : `${text} ${axis.unit}`;
}

function precise(value) {
  return String(Number(value.toPrecision(2)));
}

function fixed(value, digits) {
  return (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits).replace("-", "\u2212");
}

// Shares of the strain energy that differ by less are equal.
const TIED = 0.0005;
// Amplitude, as a share of the robot's size, from which the exaggeration is mentioned.
const LARGE = 0.1;

// The measured mode beside one of the model at a state, null where there is none.
function measuredAt(data, state, mode) {
  if (!data.measured || !state.exact) return null;
  return data.measured.modes.find((one) => one.pose === state.nearest && one.mode === mode) || null;
}

class Panel {
  constructor(root, data) {
    this.root = root;
    this.data = data;
    this.find = (name) => root.querySelector(`[data-part="${name}"]`);
    this.all = (name) => [...root.querySelectorAll(`[data-part="${name}"]`)];
    this.cycles = 0.5;
  }

  // Set sliders, frequencies and table to a state.
  pose(state) {
    const { data } = this;
    if (state.place) this.sliders(state.place);
    if (this.find("pose")) this.find("pose").value = state.nearest;
    this.all("place").forEach((part) => { part.textContent = this.place(state); });
    if (this.find("between")) {
      this.find("between").textContent = state.exact ? `Computed for ${data.varied ? "these values" : "this pose"}.` : this.interpolated(state);
    }
    this.all("frequency").forEach((part) => {
      part.textContent = this.hertz(state, Number(part.dataset.mode));
    });
    this.all("share").forEach((cell) => {
      const held = state.shares[Number(cell.dataset.mode)];  // null where no spring is strained
      const share = held === null ? 0 : held[Number(cell.dataset.spring)];
      cell.textContent = held === null ? "\u2013" : fixed(100 * share, 1);
      cell.style.setProperty("--share", share.toFixed(3));
    });
    this.all("direction").forEach((cell) => {
      cell.textContent = fixed(state.directions[Number(cell.dataset.mode)][Number(cell.dataset.component)], 2);
    });
  }

  sliders(place) {
    const { data } = this;
    this.all("level").forEach((slider, i) => {
      const value = valuesAt(data, place)[i];
      slider.value = Math.round(FINE * place[i]);
      const text = component(data.axes[i], value);
      slider.setAttribute("aria-valuetext", text);
      this.all("level-value")[i].textContent = text;
    });
  }

  // Where the robot is, in words: the label of the pose and its components.
  place(state) {
    const { data } = this, label = state.exact ? data.labels[state.nearest] : undefined;
    const parts = data.pose.map((c, i) => `${c.name} = ${shown(state.pose[i], c.unit)}`);
    if (data.varied) {
      const values = valuesAt(data, state.place);
      parts.push(...data.axes.map((c, i) => `${c.name} = ${component(c, values[i])}`));
    }
    const at = parts.join(", ");
    return `${label ? `${label}: ` : ""}${at}${state.exact ? "" : ", interpolated"}`;
  }

  interpolated(state) {
    const off = state.deviation, what = this.data.varied ? "values" : "poses";
    if (off === null) return `Interpolated between computed ${what}; not checked here.`;
    const size = off < 1e-4 ? "less than 0.01" : `up to ${precise(100 * off)}`, where = this.data.checked;
    return `Interpolated between computed ${what}: ${where ? `${where}, ` : ""}frequencies are off by ${size} %.`;
  }

  // A frequency, between states with no more decimals than it deserves.
  hertz(state, mode) {
    const value = state.frequencies[mode];
    if (state.exact) return `${fixed(value, 2)} Hz`;
    const off = state.deviation === null ? 1 : state.deviation;
    return `\u2248 ${fixed(value, off > 0.01 ? 0 : off > 0.0005 ? 1 : 2)} Hz`;
  }

  // Say what the chosen mode is.
  mode(state, mode, amplitude, announce) {
    const { data } = this, frequency = state.frequencies[mode];
    const number = mode - data.rigid + 1, shares = state.shares[mode];
    const name = number > 0 ? `Mode ${number}` : `Rigid-body motion ${mode + 1}`;
    const along = state.directions[mode].map((c, i) => `${data.components[i]} ${fixed(c, 2)}`).join(", ");
    let held = "no spring is strained";
    if (shares) {
      held = heldBy(shares, data.springs);
    }
    this.find("title").textContent = `${name}: ${this.hertz(state, mode)}`;
    this.find("held").textContent = held;
    this.find("along").textContent = along;
    this.root.querySelectorAll("[data-column]").forEach((cell) => {
      cell.classList.toggle("pkview-chosen", Number(cell.dataset.column) === mode);
    });
    const still = number > 0 ? "" : ". Gravity alone gives it a frequency; a negative one means that it falls away";
    const apart = state.apart[mode] ? " Shape of the nearest computed pose: there is none like it at all poses around." : "";
    if (announce) this.find("status").textContent = `${name}, ${this.hertz(state, mode)}: ${held}${still}.${apart}`;
    this.motion(frequency, amplitude);
  }

  // Say what was measured at the pose, and of the chosen mode; fill the table of its components.
  measured(state, mode, announce) {
    const { data } = this;
    if (!data.measured) return;
    this.all("beside").forEach((part) => {
      const one = measuredAt(data, state, Number(part.dataset.mode));
      part.textContent = one ? `measured ${this.uncertain(one).replaceAll(" ", "\u00a0")}` : "not measured";
      part.classList.toggle("pkview-without", !one);
    });
    const one = measuredAt(data, state, mode), said = this.about(one);
    this.find("observed").textContent = said;
    if (announce) this.find("status").textContent += ` ${said}`;
    const alone = data.measured.modes.filter((other) => other.pose === state.nearest && other.mode === null);
    const without = alone.map((other) => this.uncertain(other)).join(", ");
    this.find("unmatched").textContent = without ? `Measured, without a partner in the model: ${without} Hz.` : "";
    const number = mode - data.rigid + 1, compared = !!one && one.shape;
    this.find("compared").textContent = `${number > 0 ? `mode ${number}` : "a rigid-body motion"} at ${this.place(state)}`;
    this.all("component").forEach((row, k) => {
      [["measured", "measured"], ["model", "model"]].forEach(([part, key]) => {
        const value = compared ? one[key][k] : null;
        row.querySelector(`[data-part="of-${part}"]`).textContent = value === null ? "\u2013" : fixed(value, 3);
      });
    });
  }

  // Frequencies of the declared robot beside those of the robot with the values of the sliders.
  declared(state, mode, states) {
    if (!this.data.varied) return;
    this.all("beside").forEach((part) => {
      part.textContent = `declared ${fixed(states.declared(state, Number(part.dataset.mode)).frequency, 2)}`;
      part.classList.add("pkview-without");
    });
    const { frequency } = states.declared(state, mode), change = state.frequencies[mode] / frequency - 1;
    const by = Number.isFinite(change) && mode >= this.data.rigid ? ` (${change > 0 ? "+" : ""}${fixed(100 * change, 1)} %)` : "";
    this.find("declared").textContent = `, ${fixed(frequency, 2)} Hz${by}`;
  }

  uncertain(one) {
    const digits = Math.max(0, Math.min(4, 1 - Math.floor(Math.log10(one.sigma))));
    return `${fixed(one.frequency, digits)} \u00b1 ${fixed(one.sigma, digits)}`;
  }

  about(one) {
    if (!one) return "Not measured at this pose.";
    const at = `Measured: ${this.uncertain(one)} Hz`;
    if (!one.shape) return `${at}, without a shape.`;
    return `${at}${one.mac === null ? "" : `, MAC ${fixed(one.mac, 3)}`}.`;
  }

  motion(frequency, amplitude) {
    const { data } = this, enlarged = `${tidy(1000 * amplitude * data.size, 1)} mm`;
    this.find("amplitude-value").textContent = `${tidy(100 * amplitude, 1)} %`;
    this.find("amplitude").setAttribute("aria-valuetext", `${tidy(100 * amplitude, 1)} percent of the robot's size`);
    this.find("speed-value").textContent = `${tidy(this.cycles, 2)} /s`;
    this.find("speed").setAttribute("aria-valuetext", `${tidy(this.cycles, 2)} periods per second`);
    const slower = Math.abs(frequency) / this.cycles;
    const pace = slower > 1.05 ? `, slowed down ${tidy(slower, slower < 10 ? 1 : 0)} times` : "";
    const large = amplitude >= LARGE ? " So large, a linear displacement visibly changes the length of rigid links; the machine does not." : "";
    this.find("enlarged").textContent = `The largest displacement is shown as ${enlarged}${pace}.${large}`;
  }

  playing(on) {
    const button = this.find("play");
    button.setAttribute("aria-pressed", String(on));
    button.querySelector("span").textContent = on ? "Pause" : "Play";
  }
}
