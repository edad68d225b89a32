// The table of the poses at which a frequency lies in the band; without a band, all poses of a list.

// Maximum number of rows for a grid and for a list of poses.
const MAX_GRID_ROWS = 20, MAX_LIST_ROWS = 200;

class MapTable {
  constructor(explorer) {
    this.explorer = explorer;
    Object.assign(this, { map: explorer.map, data: explorer.data, find: explorer.find });
  }

  // Show how much of the map lies in the band, and the poses nearest to its middle.
  show() {
    const { explorer, map, data } = this, { band, robotIndex } = explorer, matches = [];
    let validCount = 0;
    for (let poseIndex = 0; poseIndex < map.poseCount; poseIndex++) {
      if (!map.isValid(robotIndex, poseIndex)) continue;
      validCount++;
      if (!band) continue;
      let nearest = null;
      for (const mode of band.modes) {
        if (!explorer.inBand(mode, poseIndex)) continue;
        const distance = Math.abs(map.scaledFrequency(mode, robotIndex, poseIndex) - band.target);
        if (!nearest || distance < nearest[0]) nearest = [distance, poseIndex, mode];
      }
      if (nearest) matches.push(nearest);
    }
    const sentence = this.find("share"), isList = !!data.list, box = this.find("hits");
    const formatCount = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");
    if (!band) {
      sentence.textContent = isList ? "All poses of the list:" : "";
      box.hidden = !isList;
      if (!isList) return;
    } else {
      const subject = band.modes.length > 1 ? "A mode" : `Mode ${data.modes[explorer.mode]}`;
      const limits = [band.low, band.high].map((frequency) => formatFixed(frequency / map.unitsPerHertz, 3).replace(/\.?0+$/, ""));
      const ofRobot = map.firstPoseAxis ? " of this robot" : "";
      const count = `${formatCount(matches.length)} of ${formatCount(validCount)} poses${ofRobot}`;
      const percent = matches.length ? Number(((100 * matches.length) / validCount).toPrecision(3)) : 0;
      sentence.textContent = `${subject} lies within ${limits[0]} to ${limits[1]} Hz at ${count}: ${percent} %.`;
      box.hidden = !matches.length;
    }
    matches.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const columns = [...(isList ? ["pose"] : []), ...data.components.map((c) => `${c.name} [${c.unit}]`)];
    const poseCells = (poseIndex) => [
      ...(isList ? [data.axes[map.firstPoseAxis].labels[poseIndex]] : []),
      ...data.components.map((c, k) => formatFixed(map.componentAt(k, poseIndex) * c.factor, c.decimals)),
    ];
    let rows, total;
    if (band) {
      columns.push("mode", "f [Hz]", `f \u2212 ${formatFixed(band.target / map.unitsPerHertz, 3).replace(/\.?0+$/, "")} Hz`);
      total = matches.length;
      rows = matches.slice(0, isList ? MAX_LIST_ROWS : MAX_GRID_ROWS).map(([, poseIndex, mode]) => {
        const difference = (map.scaledFrequency(mode, robotIndex, poseIndex) - band.target) / map.unitsPerHertz;
        const differenceText = `${difference > 0 ? "+" : ""}${formatFixed(difference, data.decimals)}`;
        const frequencyText = explorer.frequencyText(mode, poseIndex);
        return [poseIndex, [...poseCells(poseIndex), String(data.modes[mode]), frequencyText, differenceText]];
      });
    } else {
      columns.push(...data.modes.map((number) => `mode ${number} [Hz]`));
      const allPoses = Array.from({ length: map.poseCount }, (_, poseIndex) => poseIndex);
      const validPoses = allPoses.filter((poseIndex) => map.isValid(robotIndex, poseIndex));
      total = validPoses.length;
      rows = validPoses.slice(0, MAX_LIST_ROWS).map((poseIndex) => {
        const frequencies = data.modes.map((_, mode) => explorer.frequencyText(mode, poseIndex));
        return [poseIndex, [...poseCells(poseIndex), ...frequencies]];
      });
    }
    const order = band ? "Nearest to the middle of the band first" : "In the order of the list";
    const part = rows.length < total ? `: ${rows.length} of ${formatCount(total)}` : "";
    this.find("caption").textContent = `${order}${part}. Choose a pose to go there.`;
    this.fill(columns, rows);
    this.mark();
  }

  fill(columns, rows) {
    const createElement = (tag, text, properties = {}) => Object.assign(document.createElement(tag), { textContent: text }, properties);
    const labelColumn = this.data.list ? 0 : -1;
    const head = columns.map((text, i) => createElement("th", text, { scope: "col", className: i === labelColumn ? "" : "number" }));
    this.find("heads").replaceChildren(...head);
    this.find("rows").replaceChildren(...rows.map(([poseIndex, cells]) => {
      const row = document.createElement("tr");
      row.dataset.poseIndex = poseIndex;
      cells.forEach((text, i) => {
        const cell = createElement(i ? "td" : "th", i ? text : "", { className: i === labelColumn ? "short" : "number" });
        if (!i) {
          cell.scope = "row";
          const button = createElement("button", "", { type: "button" });
          button.dataset.poseIndex = poseIndex;
          const description = cells.slice(0, columns.length).map((cellText, k) => `${columns[k]} ${cellText}`);
          button.setAttribute("aria-label", `go to ${description.join(", ")}`);
          button.append(createElement("bdi", text));
          cell.append(button);
        }
        row.append(cell);
      });
      return row;
    }));
  }

  // Mark the rows of the pose at the cursor.
  mark() {
    this.find("rows").querySelectorAll("tr").forEach((row) => {
      row.toggleAttribute("aria-current", Number(row.dataset.poseIndex) === this.explorer.poseIndex);
      if (row.hasAttribute("aria-current")) row.setAttribute("aria-current", "true");
    });
  }
}
