// The poses of a map at which a frequency lies in a band; of a list of poses, all of them.

// Rows at most, of a grid and of a list.
const NEAREST = 20, LISTED = 200;

class MapTable {
  constructor(explorer) {
    this.explorer = explorer;
    Object.assign(this, { map: explorer.map, data: explorer.data, find: explorer.find });
  }

  // How much of the map lies in the band, and the poses nearest to its middle; of a list, all poses.
  show() {
    const { explorer, map, data } = this, { band, robot } = explorer, found = [];
    let valid = 0;
    for (let place = 0; place < map.places; place++) {
      if (!map.valid(robot, place)) continue;
      valid++;
      if (!band) continue;
      let best = null;
      for (const mode of band.modes) {
        if (!explorer.holds(mode, place)) continue;
        const away = Math.abs(map.number(mode, robot, place) - band.target);
        if (!best || away < best[0]) best = [away, place, mode];
      }
      if (best) found.push(best);
    }
    const share = this.find("share"), list = !!data.list, box = this.find("hits");
    const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");
    if (!band) {
      share.textContent = list ? "All poses of the list:" : "";
      box.hidden = !list;
      if (!list) return;
    } else {
      const who = band.modes.length > 1 ? "A mode" : `Mode ${data.modes[explorer.mode]}`;
      const ends = [band.low, band.high].map((one) => fixed(one / map.unit, 3).replace(/\.?0+$/, ""));
      const of = map.first ? " of this robot" : "";
      share.textContent = `${who} lies within ${ends[0]} to ${ends[1]} Hz at ${grouped(found.length)} of ${grouped(valid)} poses${of}: ${found.length ? Number(((100 * found.length) / valid).toPrecision(3)) : 0} %.`;
      box.hidden = !found.length;
    }
    found.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const columns = [...(list ? ["pose"] : []), ...data.components.map((c) => `${c.name} [${c.unit}]`)];
    const pose = (place) => [...(list ? [data.axes[map.first].labels[place]] : []), ...data.components.map((c, k) => fixed(map.component(k, place) * c.factor, c.decimals))];
    let rows, total;
    if (band) {
      columns.push("mode", "f [Hz]", `f \u2212 ${fixed(band.target / map.unit, 3).replace(/\.?0+$/, "")} Hz`);
      total = found.length;
      rows = found.slice(0, list ? LISTED : NEAREST).map(([, place, mode]) => {
        const away = (map.number(mode, robot, place) - band.target) / map.unit;
        return [place, [...pose(place), String(data.modes[mode]), explorer.hertz(mode, place), `${away > 0 ? "+" : ""}${fixed(away, data.decimals)}`]];
      });
    } else {
      columns.push(...data.modes.map((number) => `mode ${number} [Hz]`));
      const valids = Array.from({ length: map.places }, (_, place) => place).filter((place) => map.valid(robot, place));
      total = valids.length;
      rows = valids.slice(0, LISTED).map((place) => [place, [...pose(place), ...data.modes.map((_, mode) => explorer.hertz(mode, place))]]);
    }
    this.find("caption").textContent = `${band ? "Nearest to the middle of the band first" : "In the order of the list"}${rows.length < total ? `: ${rows.length} of ${grouped(total)}` : ""}. Choose a pose to go there.`;
    this.fill(columns, rows);
    this.mark();
  }

  fill(columns, rows) {
    const made = (tag, text, settings = {}) => Object.assign(document.createElement(tag), { textContent: text }, settings);
    const label = this.data.list ? 0 : -1;
    const head = columns.map((text, i) => made("th", text, { scope: "col", className: i === label ? "" : "number" }));
    this.find("heads").replaceChildren(...head);
    this.find("rows").replaceChildren(...rows.map(([place, cells]) => {
      const row = document.createElement("tr");
      row.dataset.place = place;
      cells.forEach((text, i) => {
        const cell = made(i ? "td" : "th", i ? text : "", { className: i === label ? "short" : "number" });
        if (!i) {
          cell.scope = "row";
          const button = made("button", "", { type: "button" });
          button.dataset.place = place;
          button.setAttribute("aria-label", `go to ${cells.slice(0, columns.length).map((one, k) => `${columns[k]} ${one}`).join(", ")}`);
          button.append(made("bdi", text));
          cell.append(button);
        }
        row.append(cell);
      });
      return row;
    }));
  }

  // The rows of the pose of the cursor.
  mark() {
    this.find("rows").querySelectorAll("tr").forEach((row) => {
      row.toggleAttribute("aria-current", Number(row.dataset.place) === this.explorer.place);
      if (row.hasAttribute("aria-current")) row.setAttribute("aria-current", "true");
    });
  }
}
