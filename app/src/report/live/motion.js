// The run as a motion: parts of the drawing turn and slide, bodies in a plane are drawn from
// their points. Time is that of the run.

// Seconds that the whole run takes to be shown, at least and at most.
const SHORTEST_SHOW = 4;
const LONGEST_SHOW = 12;
// How far a part slides in the drawing, to either side.
const SLIDE = 14;

class Motion {
  constructor(page, root) {
    Object.assign(this, { page, root, run: null, time: 0, frame: 0, last: 0 });
    const { moving } = page.machine.known;
    this.stored = null;
    const player = root.querySelector(".player");
    this.play = player.querySelector("button");
    this.slider = player.querySelector("input");
    this.told = player.querySelector("output");
    this.parts = moving.parts.map((part) => this.part(part)).filter(Boolean);
    this.plane = moving.bodies.length ? new Plane(root.querySelector("svg"), moving.bodies) : null;
    this.play.addEventListener("click", () => this.toggle());
    this.slider.addEventListener("input", () => this.seek());
    const calm = matchMedia("(prefers-reduced-motion: reduce)");
    const respect = () => {
      this.play.hidden = calm.matches;
      if (calm.matches) this.stop();
    };
    calm.addEventListener("change", respect, { signal: ending.signal });
    ending.signal.addEventListener("abort", () => this.stop());
    respect();
    root.hidden = false;
    this.begin();
  }

  // Draws the machine in space, if it has a place there.
  async begin() {
    const { known } = this.page.machine;
    if (!known.space) return;
    const places = await Places.of(known.space);
    if (ending.signal.aborted) return;
    this.space = new Space(this.root.querySelector(".space"), places);
    this.stored = places.stored;
    this.show(this.run ?? this.stored);
  }

  // A part of the drawing: a dial that turns against the clock, or a symbol that slides.
  part({ part, slides, by }) {
    const group = document.querySelector(`.schematic [data-part="${part}"]`);
    if (!group) return null;
    if (slides) {
      const symbol = group.querySelector(".symbol");
      return symbol && { by, symbol, slides, from: symbol.getAttribute("transform") };
    }
    const box = group.querySelector("rect");
    const [x, y, width] = ["x", "y", "width"].map((name) => Number(box.getAttribute(name)));
    const dial = element("g", { class: "dial", transform: `translate(${x + width - 14} ${y + 14})` });
    const hand = element("path", { d: "M0 0V-8" });
    dial.append(element("circle", { r: 8 }), hand);
    group.append(dial);
    return { by, hand };
  }

  // Follows another run from now on.
  show(run) {
    this.run = run;
    const end = run.times[run.taken - 1];
    for (const part of this.parts) part.way = ways(run, part.by);
    this.plane?.fit(run);
    this.space?.fit(run);
    this.time = Math.min(Math.max(this.time, run.from), end);
    this.draw();
  }

  async toggle() {
    if (this.frame) {
      this.stop();
      return;
    }
    if (!this.run) await this.page.latest();
    if (!this.run || this.frame || ending.signal.aborted) return;
    if (this.time >= this.end()) this.time = this.run.from;
    this.play.textContent = "Pause";
    this.last = performance.now();
    const step = (now) => {
      this.time += ((now - this.last) / 1000) * this.pace();
      this.last = now;
      if (this.time >= this.end()) {
        this.time = this.end();
        this.stop();
      } else {
        this.frame = requestAnimationFrame(step);
      }
      this.draw();
    };
    this.frame = requestAnimationFrame(step);
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.play.textContent = "Play";
  }

  async seek() {
    const share = Number(this.slider.value) / LAST;
    if (!this.run) await this.page.latest();
    if (!this.run) return;
    this.time = this.run.from + share * (this.end() - this.run.from);
    this.draw();
  }

  end() {
    return this.run.times[this.run.taken - 1];
  }

  // Seconds of the run in a second.
  pace() {
    const span = this.end() - this.run.from;
    return span / Math.max(SHORTEST_SHOW, Math.min(LONGEST_SHOW, span));
  }

  // The time in the figures, once there is one.
  mark() {
    if (this.run) this.page.charts.forEach((chart) => chart.mark(this.time));
  }

  draw() {
    const { run, time } = this;
    const at = place(run, time);
    for (const { way, hand, symbol, slides, from } of this.parts) {
      const value = between(way.values, at);
      if (slides) {
        const shift = way.half > 0 ? (SLIDE * (value - way.middle)) / way.half : 0;
        symbol.setAttribute("transform", `${from} translate(${shift.toFixed(1)} 0)`);
      } else {
        hand.setAttribute("transform", `rotate(${(((-value * 180) / Math.PI) % 360).toFixed(1)})`);
      }
    }
    this.plane?.draw(run, at);
    this.space?.draw(time);
    this.mark();
    const span = this.end() - run.from;
    this.slider.value = span > 0 ? (LAST * (time - run.from)) / span : 0;
    const pace = this.pace();
    const slower = pace === 1 ? "" : `, at ${shown(pace, 2)} of its speed`;
    this.told.textContent = `${shown(time, 4)} s${slower}`;
    this.slider.setAttribute("aria-valuetext", `${shown(time, 4)} s`);
  }
}

// The sample before a time, and the share of the way to the next one.
function place({ times, taken }, time) {
  let [index, after] = [0, Math.max(1, taken - 1)];
  while (after - index > 1) {
    const middle = (index + after) >> 1;
    if (times[middle] <= time) index = middle;
    else after = middle;
  }
  const step = times[after] - times[index];
  return [index, step > 0 ? Math.max(0, Math.min(1, (time - times[index]) / step)) : 0];
}

function between(values, [index, share]) {
  return values[index] + share * ((values[index + 1] ?? values[index]) - values[index]);
}

// Where something is at every sample, and the middle and half of its range: its position, or
// what its velocity adds up to.
function ways({ times, taken, tracks }, { position, velocity }) {
  const values = new Float64Array(taken);
  if (position !== null) {
    values.set(tracks.get(position).subarray(0, taken));
  } else {
    const rate = tracks.get(velocity);
    for (let index = 1; index < taken; index++) {
      values[index] = values[index - 1] + 0.5 * (rate[index] + rate[index - 1]) * (times[index] - times[index - 1]);
    }
  }
  const [low, high] = extent([values]);
  return { values, middle: 0.5 * (low + high), half: 0.5 * (high - low) };
}

// Entries of the state that the motion needs of a run.
function tracked({ parts, bodies }) {
  const ofParts = parts.map(({ by }) => by.position ?? by.velocity);
  const ofBodies = bodies.flatMap(({ points, angle }) => [...points.flat(), angle]);
  return [...new Set([...ofParts, ...ofBodies])].filter((entry) => entry !== null);
}

// Bodies in a plane, x to the right and y upwards, in one scale: points of a body joined by
// lines, the angle of one with a single point as a short bar.
class Plane {
  constructor(svg, bodies) {
    this.svg = svg;
    this.bodies = bodies.map(({ name, points, angle }, index) => {
      const group = element("g", { class: "body", stroke: COLOURS[index % COLOURS.length] });
      const line = element("path", {});
      const bar = angle === null || points.length > 1 ? null : element("path", { class: "bar" });
      const dots = points.map(() => element("circle", { r: 3.5 }));
      group.append(element("title", {}, name), line, ...(bar ? [bar] : []), ...dots);
      svg.append(group);
      return { points, angle, line, bar, dots };
    });
    svg.closest("figure").hidden = false;
  }

  // Chooses the scale so that the whole run has room.
  fit(run) {
    const [WIDTH, HEIGHT, SPACE] = [880, 320, 30];
    const values = (axis) => this.bodies.flatMap(({ points }) => points.map((point) => {
      const entry = point[axis];
      return entry === null ? [0] : run.tracks.get(entry).subarray(0, run.taken);
    }));
    const [x, y] = [extent(values(0)), extent(values(1))];
    const spans = [(WIDTH - 2 * SPACE) / (x[1] - x[0]), (HEIGHT - 2 * SPACE) / (y[1] - y[0])];
    const scale = Math.min(...spans.filter(Number.isFinite), 1e12);
    this.to = ([a, b]) => [
      WIDTH / 2 + scale * (a - 0.5 * (x[0] + x[1])),
      HEIGHT / 2 - scale * (b - 0.5 * (y[0] + y[1])),
    ];
  }

  draw(run, at) {
    const value = (entry) => (entry === null ? 0 : between(run.tracks.get(entry), at));
    for (const { points, angle, line, bar, dots } of this.bodies) {
      const places = points.map((point) => this.to(point.map(value)));
      if (!places.flat().every(Number.isFinite)) continue;
      places.forEach(([x, y], index) => {
        dots[index].setAttribute("cx", x.toFixed(1));
        dots[index].setAttribute("cy", y.toFixed(1));
      });
      line.setAttribute("d", `M${places.map((place) => place.map((v) => v.toFixed(1)).join(" ")).join("L")}`);
      if (!bar) continue;
      const phi = value(angle);
      const [dx, dy] = [22 * Math.cos(phi), -22 * Math.sin(phi)];
      const [x, y] = places[0];
      bar.setAttribute("d", `M${(x - dx).toFixed(1)} ${(y - dy).toFixed(1)}L${(x + dx).toFixed(1)} ${(y + dy).toFixed(1)}`);
    }
  }
}

// The colours of curves, in the order of the figures.
const COLOURS = ["#2584c6", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#8c8c8c", "#a08a00"];
