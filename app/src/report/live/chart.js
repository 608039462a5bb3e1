// Draws a run into the figures of the page: the curves of the stored run stay as thin dashed
// lines, and axes are wide enough for both.

const SVG = "http://www.w3.org/2000/svg";
// More points than this are drawn by the least and greatest of each bin.
const MOST_POINTS = 1600;
const MARGIN = 0.06;

function element(name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// The least and the greatest of finite values.
function extent(lists) {
  let [low, high] = [Infinity, -Infinity];
  for (const values of lists) {
    for (const value of values) {
      if (!Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low <= high ? [low, high] : [0, 1];
}

function widened([low, high]) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  const span = high - low;
  const margin = span > 1e-9 * size ? MARGIN * span : Math.max(0.1 * size, 1e-3);
  return [low - margin, high + margin];
}

// Round numbers within a range, about so many, and how to write them all alike.
function ticks([low, high], count) {
  const raw = (high - low) / count;
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((digit) => digit * unit).find((round) => round >= raw) ?? 10 * unit;
  const found = [];
  for (let k = Math.ceil(low / step); k * step <= high && found.length < 50; k++) found.push(k * step);
  const largest = Math.max(...found.map(Math.abs));
  const isExponential = largest >= 1e6 || (largest > 0 && largest < 1e-4);
  const power = isExponential ? Math.floor(Math.log10(largest)) : 0;
  const decimals = Math.max(0, Math.min(9, power - Math.floor(Math.log10(step) + 1e-9)));
  const write = (value) => {
    if (Math.abs(value) < 1e-9 * step) return "0";
    const text = isExponential ? value.toExponential(decimals).replace("e+", "e") : value.toFixed(decimals);
    return text.replace(/-/g, "\u2212");
  };
  return found.map((value) => [value, write(value)]);
}

// Indices of so many points that a curve looks the same, spikes too; nothing where all of them
// are few enough.
function reduced(values, count) {
  if (count <= MOST_POINTS) return null;
  const bin = Math.max(2, Math.ceil(count / (MOST_POINTS / 2)));
  const keep = [];
  for (let start = 0; start < count; start += bin) {
    let [low, high] = [start, start];
    for (let index = start; index < Math.min(start + bin, count); index++) {
      if (values[index] < values[low]) low = index;
      if (values[index] > values[high]) high = index;
    }
    keep.push(Math.min(low, high));
    if (low !== high) keep.push(Math.max(low, high));
  }
  if (keep[keep.length - 1] !== count - 1) keep.push(count - 1);
  return keep;
}

class Chart {
  constructor(svg) {
    this.panel = svg.querySelector(".panel");
    const n = this.panel.dataset.axes.split(" ").map(Number);
    [this.left, this.right] = [n[0], n[1]];
    [this.bottom, this.top] = [n[5], n[6]];
    this.drawn = { x: [n[2], n[3]], y: [n[7], n[8]] };
    this.asStored = this.panel.innerHTML;
    this.axesAsStored = this.panel.dataset.axes;
    this.stored = [...this.panel.querySelectorAll(".curve")].map((path) => this.read(path));
    this.isStored = true;
  }

  // The curve of a path, in its own numbers.
  read(path) {
    const [times, values] = [[], []];
    const { x, y } = this.drawn;
    let pen = [0, 0];
    for (const [, command, dx, dy] of path.getAttribute("d").matchAll(/([Ml])(-?\d+) (-?\d+)/g)) {
      const from = command === "M" ? [0, 0] : pen;
      pen = [from[0] + Number(dx), from[1] + Number(dy)];
      times.push(x[0] + ((pen[0] / 10 - this.left) / (this.right - this.left)) * (x[1] - x[0]));
      values.push(y[0] + ((pen[1] / 10 - this.bottom) / (this.top - this.bottom)) * (y[1] - y[0]));
    }
    return { name: path.dataset.name, stroke: path.getAttribute("stroke"), times, values };
  }

  // Shows a run; nothing brings back what is stored.
  show(run) {
    if (!run) {
      if (!this.isStored) {
        this.panel.innerHTML = this.asStored;
        this.panel.dataset.axes = this.axesAsStored;
      }
      this.isStored = true;
      return;
    }
    this.isStored = false;
    const { taken, times, until, from } = run;
    const live = this.stored.map(({ name }) => run.column(name)?.subarray(0, taken)).filter(Boolean);
    this.x = [from, until];
    this.y = widened(extent([...live, ...this.stored.map(({ values }) => values)]));
    this.panel.dataset.axes = [this.left, this.right, ...this.x, 0, this.bottom, this.top, ...this.y, 0].join(" ");
    const titles = this.panel.querySelectorAll(".title");
    const curves = this.stored.flatMap((curve) => {
      const old = this.old(curve);
      const column = run.column(curve.name);
      return column ? [old, this.curve(curve.name, curve.stroke, times, column, taken)] : [old];
    });
    this.panel.replaceChildren(...this.axes(), ...titles, ...curves);
  }

  // A stored curve, drawn anew only where axes have changed.
  old(curve) {
    const { axes } = this.panel.dataset;
    if (curve.axes !== axes) {
      curve.axes = axes;
      curve.path = this.curve(`${curve.name}, stored`, curve.stroke, curve.times, curve.values, curve.times.length);
      curve.path.classList.add("stored");
    }
    return curve.path;
  }

  // A line at a time of the run that is shown.
  mark(time) {
    const [, , low, high] = this.panel.dataset.axes.split(" ").map(Number);
    const x = this.left + ((time - low) / (high - low)) * (this.right - this.left);
    let line = this.panel.querySelector(".now");
    if (!line) line = this.panel.appendChild(element("line", { class: "now", y1: this.bottom, y2: this.top }));
    line.setAttribute("x1", x.toFixed(1));
    line.setAttribute("x2", x.toFixed(1));
  }

  across(time) {
    return this.left + ((time - this.x[0]) / (this.x[1] - this.x[0])) * (this.right - this.left);
  }

  up(value) {
    return this.bottom + ((value - this.y[0]) / (this.y[1] - this.y[0])) * (this.top - this.bottom);
  }

  axes() {
    const { left, right, bottom } = this;
    const drawn = [];
    for (const [value, text] of ticks(this.y, 6)) {
      const y = this.up(value).toFixed(1);
      drawn.push(element("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }));
      drawn.push(element("text", { class: "end", x: left - 8, y: Number(y) + 4 }, text));
    }
    for (const [value, text] of ticks(this.x, 11)) {
      const x = this.across(value).toFixed(1);
      drawn.push(element("line", { class: "tick", x1: x, x2: x, y1: bottom, y2: bottom + 5 }));
      drawn.push(element("text", { class: "middle", x, y: bottom + 19 }, text));
    }
    drawn.push(element("line", { class: "tick", x1: left, x2: right, y1: bottom, y2: bottom }));
    return drawn;
  }

  // A path in tenths, each point but the first of a piece by its distance from the one before.
  curve(name, stroke, times, values, count) {
    const keep = reduced(values, count);
    const points = keep?.length ?? count;
    let path = "";
    let [isDown, penX, penY] = [false, 0, 0];
    for (let k = 0; k < points; k++) {
      const index = keep ? keep[k] : k;
      const [time, value] = [times[index], values[index]];
      if (!Number.isFinite(value) || time > this.x[1]) {
        isDown = false;
        continue;
      }
      const x = Math.round(10 * this.across(time));
      const y = Math.round(10 * Math.max(-1e5, Math.min(1e5, this.up(value))));
      if (isDown && x === penX && y === penY) continue;
      path += isDown ? `l${x - penX} ${y - penY}` : `M${x} ${y}`;
      [isDown, penX, penY] = [true, x, y];
    }
    return element("path", { class: "curve", d: path, stroke, "data-name": name });
  }
}
