// Controls and table around the picture: what they say follows the pose and the mode.

function shown(value, unit) {
  if (unit === "m") return `${tidy(1000 * value, 1)} mm`;
  if (unit === "rad") return `${tidy((180 * value) / Math.PI, 1)} deg`;
  return `${tidy(value, 3)} ${unit}`;
}

function tidy(value, digits) {
  return String(Number(value.toFixed(digits)) + 0).replace("-", "\u2212");
}

function fixed(value, digits) {
  return (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits).replace("-", "\u2212");
}

class Panel {
  constructor(root, data) {
    this.root = root;
    this.data = data;
    this.find = (name) => root.querySelector(`[data-part="${name}"]`);
    this.all = (name) => [...root.querySelectorAll(`[data-part="${name}"]`)];
    this.cycles = 0.5;
  }

  // Set sliders, frequencies and table to a pose.
  pose(index) {
    const { data } = this, values = data.poses[index];
    const place = data.pose.map((c, i) => `${c.name} = ${shown(values[i], c.unit)}`).join(", ");
    this.all("level").forEach((slider, i) => {
      slider.value = data.levels[i].indexOf(values[i]);
      slider.setAttribute("aria-valuetext", shown(values[i], data.pose[i].unit));
      this.all("level-value")[i].textContent = shown(values[i], data.pose[i].unit);
    });
    if (this.find("pose")) this.find("pose").value = index;
    this.all("place").forEach((part) => { part.textContent = place; });
    this.all("frequency").forEach((part) => {
      part.textContent = `${fixed(data.frequencies[index][Number(part.dataset.mode)], 2)} Hz`;
    });
    this.all("share").forEach((cell) => {
      const held = data.shares[index][Number(cell.dataset.mode)];  // null where no spring is strained
      const share = held === null ? 0 : held[Number(cell.dataset.spring)];
      cell.textContent = held === null ? "\u2013" : fixed(100 * share, 1);
      cell.style.setProperty("--share", share.toFixed(3));
    });
    this.all("direction").forEach((cell) => {
      cell.textContent = fixed(data.directions[index][Number(cell.dataset.mode)][Number(cell.dataset.component)], 2);
    });
  }

  // Say what the chosen mode is.
  mode(index, mode, amplitude, announce) {
    const { data } = this, frequency = data.frequencies[index][mode];
    const number = mode - data.rigid + 1, shares = data.shares[index][mode];
    const name = number > 0 ? `Mode ${number}` : `Rigid-body motion ${mode + 1}`;
    const along = data.directions[index][mode].map((c, i) => `${data.components[i]} ${fixed(c, 2)}`).join(", ");
    let held = "no spring is strained";
    if (shares) {
      const most = shares.indexOf(Math.max(...shares));
      held = `${fixed(100 * shares[most], 0)} % of the strain energy in ${data.springs[most]}`;
    }
    this.find("title").textContent = `${name}: ${fixed(frequency, 2)} Hz`;
    this.find("held").textContent = held;
    this.find("along").textContent = along;
    this.root.querySelectorAll("[data-column]").forEach((cell) => {
      cell.classList.toggle("pkview-chosen", Number(cell.dataset.column) === mode);
    });
    const still = number > 0 ? "" : ". Gravity alone gives it a frequency; a negative one means that it falls away";
    if (announce) this.find("status").textContent = `${name}, ${fixed(frequency, 2)} Hz: ${held}${still}.`;
    this.motion(frequency, amplitude);
  }

  motion(frequency, amplitude) {
    const { data } = this, enlarged = shown(amplitude * data.size, "m");
    this.find("amplitude-value").textContent = `${tidy(100 * amplitude, 1)} %`;
    this.find("amplitude").setAttribute("aria-valuetext", `${tidy(100 * amplitude, 1)} percent of the robot's size`);
    this.find("speed-value").textContent = `${tidy(this.cycles, 2)} /s`;
    this.find("speed").setAttribute("aria-valuetext", `${tidy(this.cycles, 2)} periods per second`);
    const slower = Math.abs(frequency) / this.cycles;
    const pace = slower > 1.05 ? `, slowed down ${tidy(slower, slower < 10 ? 1 : 0)} times` : "";
    this.find("enlarged").textContent = `The largest displacement is shown as ${enlarged}${pace}.`;
  }

  playing(on) {
    const button = this.find("play");
    button.setAttribute("aria-pressed", String(on));
    button.querySelector("span").textContent = on ? "Pause" : "Play";
  }
}
