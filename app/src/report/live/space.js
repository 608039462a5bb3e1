// The machine in space: primitives on a canvas, far ones first, turned by pointers and keys.

const V = {
  add: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
  sub: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
  mul: (s, a) => [s * a[0], s * a[1], s * a[2]],
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  size: (a) => Math.hypot(...a),
  unit: (a) => V.mul(1 / (V.size(a) || 1), a),
  // A unit vector across another.
  across: (a) => {
    const sizes = a.map(Math.abs);
    const least = sizes.indexOf(Math.min(...sizes));
    return V.unit(V.cross(a, [0, 1, 2].map((k) => (k === least ? 1 : 0))));
  },
};

// Sizes of symbols, in parts of the size of the machine.
const SYMBOL = { hinge: [0.016, 0.055], ball: 0.02, mass: 0.017, link: 0.011, rod: 0.008, slide: 0.005, coil: 0.016 };
const SIDES = 18;
// Faces of a solid are divided along it so that far and near ones can be told apart.
const LONGEST_FACE = 0.12;

// Faces and lines of elements. Faces are polygons of points with a normal.
class Solids {
  constructor(size) {
    Object.assign(this, { size, faces: [], lines: [] });
  }

  cylinder(from, to, radius, colour, { sides = SIDES, mark = null } = {}) {
    const way = V.sub(to, from);
    const length = V.size(way);
    const axis = length > 1e-9 * this.size ? V.mul(1 / length, way) : mark ? V.unit(V.cross(mark, V.across(mark))) : [0, 0, 1];
    const x = mark ?? V.across(axis);
    const y = V.cross(axis, x);
    const ring = range(sides).map((k) => {
      const angle = (2 * Math.PI * k) / sides;
      return V.add(V.mul(Math.cos(angle), x), V.mul(Math.sin(angle), y));
    });
    const pieces = Math.max(1, Math.min(24, Math.ceil(length / (LONGEST_FACE * this.size))));
    const at = (share, direction) => V.add(V.add(from, V.mul(share, way)), V.mul(radius, direction));
    for (let piece = 0; piece < pieces && length > 0; piece++) {
      const [low, high] = [piece / pieces, (piece + 1) / pieces];
      ring.forEach((one, k) => {
        const other = ring[(k + 1) % sides];
        this.face([at(low, one), at(low, other), at(high, other), at(high, one)], V.unit(V.add(one, other)), colour);
      });
    }
    this.face(ring.map((one) => at(0, one)).reverse(), V.mul(-1, axis), colour);
    this.face(ring.map((one) => at(1, one)), axis, colour);
    if (!mark || radius < 0.02 * this.size) return;
    for (const [share, sign] of [[0, -1], [1, 1]]) {
      const middle = V.add(V.add(from, V.mul(share, way)), V.mul(sign * 1e-3 * this.size, axis));
      this.line([middle, V.add(middle, V.mul(0.92 * radius, x))], "mark", V.mul(sign, axis), middle);
    }
  }

  box([centre, ...given], colour) {
    const [a, b, c] = thick(given, 0.005 * this.size);
    const corner = (i, j, k) => V.add(V.add(centre, V.mul(i, a)), V.add(V.mul(j, b), V.mul(k, c)));
    for (const [u, v, w, turn] of [[a, b, c, (s, i, j) => corner(i, j, s)], [b, c, a, (s, i, j) => corner(s, i, j)], [c, a, b, (s, i, j) => corner(j, s, i)]]) {
      for (const s of [-1, 1]) {
        const normal = V.unit(V.size(w) > 1e-12 * this.size ? V.mul(s, w) : V.mul(s, V.cross(u, v)));
        const pieces = [u, v].map((edge) => Math.max(1, Math.min(8, Math.ceil((2 * V.size(edge)) / (2 * LONGEST_FACE * this.size)))));
        for (let p = 0; p < pieces[0]; p++) {
          for (let q = 0; q < pieces[1]; q++) {
            const i = [p, p + 1].map((k) => -1 + (2 * k) / pieces[0]);
            const j = [q, q + 1].map((k) => -1 + (2 * k) / pieces[1]);
            const points = [turn(s, i[0], j[0]), turn(s, i[1], j[0]), turn(s, i[1], j[1]), turn(s, i[0], j[1])];
            this.face(s > 0 ? points : points.reverse(), normal, colour);
          }
        }
      }
    }
  }

  sphere([centre, x, y, radius], colour) {
    const z = V.cross(x, y);
    const point = (polar, around) => V.add(V.mul(Math.cos(polar), z), V.mul(Math.sin(polar), V.add(V.mul(Math.cos(around), x), V.mul(Math.sin(around), y))));
    const [rows, columns] = radius > 0.04 * this.size ? [10, 16] : [5, 8];
    for (let i = 0; i < rows; i++) {
      for (let j = 0; j < columns; j++) {
        const [low, high] = [(Math.PI * i) / rows, (Math.PI * (i + 1)) / rows];
        const [left, right] = [(2 * Math.PI * j) / columns, (2 * Math.PI * (j + 1)) / columns];
        const corners = [point(low, left), point(high, left), point(high, right), point(low, right)];
        const middle = V.unit(corners.reduce(V.add));
        // Quarters differ, so that rotation shows.
        const isDark = radius > 0.04 * this.size && i < rows / 2 === j < columns / 2;
        this.face(corners.map((it) => V.add(centre, V.mul(radius, it))), middle, colour, isDark ? 0.78 : 1);
      }
    }
  }

  coil(from, to, colour) {
    const way = V.sub(to, from);
    const length = V.size(way);
    if (length < 1e-9 * this.size) return;
    const [x, radius, turns] = [V.across(V.mul(1 / length, way)), SYMBOL.coil * this.size, 9];
    const y = V.cross(V.mul(1 / length, way), x);
    const points = range(turns * 12 + 1).map((k) => {
      const share = 0.1 + (0.8 * k) / (turns * 12);
      const angle = (2 * Math.PI * k) / 12;
      const out = V.add(V.mul(radius * Math.cos(angle), x), V.mul(radius * Math.sin(angle), y));
      return V.add(V.add(from, V.mul(share, way)), out);
    });
    const all = [from, V.add(from, V.mul(0.1, way)), ...points, V.add(from, V.mul(0.9, way)), to];
    for (let k = 0; k + 1 < all.length; k += 4) this.line(all.slice(k, k + 5), colour);
  }

  face(points, normal, colour, tint = 1) {
    this.faces.push({ points, normal, colour, tint });
  }

  // A line; one with a normal is seen from that side only, and lies on the face about `middle`.
  line(points, colour, normal = null, middle = null) {
    this.lines.push({ points, colour, normal, middle });
  }

  add({ kind, of }, colour) {
    const { size } = this;
    const joint = "joint";
    if (kind === "hinge") {
      const [radius, length] = SYMBOL.hinge.map((part) => part * size);
      const half = V.mul(length / 2, of[1]);
      this.cylinder(V.sub(of[0], half), V.add(of[0], half), radius, joint);
      this.line([V.sub(of[0], V.mul(2, half)), V.add(of[0], V.mul(2, half))], "axis");
    } else if (kind === "slide") {
      const half = V.mul(0.5 * SYMBOL.hinge[1] * size, of[2]);
      const way = V.sub(of[0], of[1]);
      const rail = V.mul(Math.min(1, (0.5 * size) / (V.size(way) || 1)), way);
      this.cylinder(V.add(of[1], rail), of[1], SYMBOL.slide * size, joint, { sides: 8 });
      this.cylinder(V.sub(of[1], half), V.add(of[1], half), 1.2 * SYMBOL.hinge[0] * size, joint, { sides: 4 });
    } else if (kind === "ball") this.sphere([of[0], [1, 0, 0], [0, 1, 0], SYMBOL.ball * size], joint);
    else if (kind === "mass") this.sphere([of[0], [1, 0, 0], [0, 1, 0], SYMBOL.mass * size], colour);
    else if (kind === "link" || kind === "rod") this.cylinder(of[0], of[1], SYMBOL[kind] * size, colour, { sides: 8 });
    else if (kind === "spring") this.coil(of[0], of[1], colour);
    else if (kind === "cylinder") this.cylinder(of[0], of[1], Math.max(of[3], 0.004 * size), colour, { mark: of[2] });
    else if (kind === "sphere") this.sphere(of, colour);
    else if (kind === "box") this.box(of, colour);
  }
}

// Half edges of a box, none thinner than what can be seen.
function thick(edges, least) {
  const order = [0, 1, 2].sort((i, j) => V.size(edges[j]) - V.size(edges[i]));
  const [long, middle, thin] = order.map((k) => edges[k]);
  const a = V.size(long) > least ? long : [least, 0, 0];
  const b = V.size(middle) > least ? middle : V.mul(least, V.across(a));
  const c = V.size(thin) > least ? thin : V.mul(least, V.unit(V.cross(a, b)));
  const whole = [];
  order.forEach((k, rank) => { whole[k] = [a, b, c][rank]; });
  // Right-handed, so that faces look outwards.
  if (V.dot(V.cross(whole[0], whole[1]), whole[2]) < 0) whole[order[2]] = V.mul(-1, c);
  return whole;
}

// A solid that stands for an inertia, no larger than so much.
function shrunk({ kind, name, of }, most) {
  const centre = kind === "cylinder" ? V.mul(0.5, V.add(of[0], of[1])) : of[0];
  const reach = Math.max(...corners({ kind, of }).map((point) => V.size(V.sub(point, centre))));
  const share = Math.min(1, most / reach);
  const near = (point) => V.add(centre, V.mul(share, V.sub(point, centre)));
  if (kind === "cylinder") return { kind, name, of: [near(of[0]), near(of[1]), of[2], share * of[3]] };
  if (kind === "sphere") return { kind, name, of: [of[0], of[1], of[2], share * of[3]] };
  return { kind, name, of: [of[0], ...of.slice(1).map((edge) => V.mul(share, edge))] };
}

// Points within which an element lies.
function corners({ kind, of }) {
  const around = (centre, radius) => [-1, 1].flatMap((s) => [0, 1, 2].map((k) => V.add(centre, [0, 1, 2].map((i) => (i === k ? s * radius : 0)))));
  if (kind === "up") return [];
  if (kind === "cylinder") return [...around(of[0], of[3]), ...around(of[1], of[3])];
  if (kind === "sphere") return around(of[0], of[3]);
  if (kind === "box") return around(of[0], V.size(of[1]) + V.size(of[2]) + V.size(of[3]));
  if (kind === "slide") return [of[1]];
  return kind === "link" || kind === "rod" || kind === "spring" ? [of[0], of[1]] : [of[0]];
}

// The view: where the eye is, and how points of the world come onto the canvas.
class View {
  constructor() {
    Object.assign(this, { turn: 0, rise: 0.32, zoom: 1, isParallel: false, start: 0 });
  }

  reset() {
    Object.assign(this, { turn: this.start, rise: 0.32, zoom: 1 });
  }

  // Looks at what a run covers, or at a machine that travels far: `instants` are points at some
  // times, `up` is that of the world.
  fit(instants, up) {
    this.up = V.size(up) > 0 ? V.unit(up) : [0, 0, 1];
    const first = (this.up.map(Math.abs).indexOf(Math.max(...this.up.map(Math.abs))) + 1) % 3;
    const rough = [0, 1, 2].map((k) => (k === first ? 1 : 0));
    this.right = V.unit(V.sub(rough, V.mul(V.dot(rough, this.up), this.up)));
    this.ahead = V.cross(this.up, this.right);
    const spansOf = (points) => [this.right, this.ahead, this.up].map((axis) => extent([points.map((point) => V.dot(point, axis))]));
    const largest = (spans) => Math.max(...spans.map(([low, high]) => high - low), 1e-9);
    const each = instants.map(spansOf);
    const whole = spansOf(instants.flat());
    this.size = Math.max(...each.map(largest));
    this.travels = largest(whole) > 3 * this.size;
    this.level = whole[2][0];
    this.spans = this.travels ? [0, 1, 2].map((k) => [0, Math.max(...each.map((spans) => spans[k][1] - spans[k][0]))]) : whole;
    this.centre(whole);
    this.radius = 0.5 * V.size(this.spans.map(([low, high]) => high - low));
    const { spans } = this;
    // A flat machine is seen from its side.
    const [wide, deep] = spans.map(([low, high]) => high - low);
    const start = wide < 0.4 * deep ? -0.35 : deep < 0.4 * wide ? -Math.PI / 2 + 0.35 : -Math.PI / 3;
    if (this.start !== start) {
      this.start = start;
      this.turn = start;
    }
  }

  centre(spans) {
    const [a, b, c] = spans.map(([low, high]) => 0.5 * (low + high));
    this.target = V.add(V.add(V.mul(a, this.right), V.mul(b, this.ahead)), V.mul(c, this.up));
  }

  // Keeps a machine that travels in the middle.
  follow(points) {
    if (this.travels) this.centre([this.right, this.ahead, this.up].map((axis) => extent([points.map((point) => V.dot(point, axis))])));
  }

  aim(width, height) {
    const flat = V.add(V.mul(Math.cos(this.turn), this.right), V.mul(Math.sin(this.turn), this.ahead));
    this.back = V.add(V.mul(Math.cos(this.rise), flat), V.mul(Math.sin(this.rise), this.up));
    this.side = V.unit(V.cross(this.up, flat));
    this.over = V.cross(this.back, this.side);
    this.far = 3.6 * this.radius;
    this.scale = this.zoom * this.fitting(width, height);
    this.middle = [width / 2, height / 2];
  }

  // Scale by which everything fits, seen from the first side.
  fitting(width, height) {
    const [cos, sin, rise] = [Math.cos(this.start), Math.sin(this.start), 0.32];
    const [a, b, c] = this.spans.map(([low, high]) => 0.5 * (high - low));
    const wide = Math.abs(sin) * a + Math.abs(cos) * b;
    const high = Math.sin(rise) * (Math.abs(cos) * a + Math.abs(sin) * b) + Math.cos(rise) * c;
    return 0.46 * Math.min(width / Math.max(wide, 0.2 * this.size), height / Math.max(high, 0.2 * this.size));
  }

  // The point on the canvas, and how near it is.
  see(point) {
    const from = V.sub(point, this.target);
    const near = V.dot(from, this.back);
    const share = this.isParallel ? 1 : this.far / Math.max(this.far - near, 0.02 * this.far);
    const scale = this.scale * share;
    return [this.middle[0] + scale * V.dot(from, this.side), this.middle[1] - scale * V.dot(from, this.over), near, share];
  }

  // Whether a face is turned to the eye.
  faces(point, normal) {
    const eye = this.isParallel ? this.back : V.sub(V.add(this.target, V.mul(this.far, this.back)), point);
    return V.dot(normal, eye) > 0;
  }
}

class Space {
  constructor(figure, places) {
    Object.assign(this, { figure, places, view: new View(), run: null, time: 0, showsNames: false });
    this.canvas = figure.querySelector("canvas");
    const ofName = new Map();
    // Colours by the unit of an element, or by the element where there is one unit.
    const units = places.elements.filter(({ kind }) => kind !== "up").map(({ name }) => name.slice(0, name.lastIndexOf(".")));
    const isOne = new Set(units).size < 2;
    this.colours = places.elements.map(({ kind, name }) => {
      const key = isOne ? name : name.slice(0, name.lastIndexOf("."));
      if (kind === "link" || kind === "rod") return "link";
      if (["up", "hinge", "slide", "ball"].includes(kind)) return "joint";
      if (!ofName.has(key)) ofName.set(key, COLOURS[ofName.size % COLOURS.length]);
      return ofName.get(key);
    });
    figure.hidden = false;
    this.listen();
  }

  // Follows another run from now on.
  fit(run) {
    this.run = run;
    this.places.begin(run);
    const [from, until] = [run.times[0], run.times[run.taken - 1]];
    const times = range(60).map((k) => from + ((until - from) * k) / 59);
    const all = times.map((time) => this.places.at(run, time)).filter(Boolean);
    if (!all.length) return;
    const up = all[0].find(({ kind }) => kind === "up");
    this.hasGround = V.size(up.of[0]) > 0;
    // Solids that stand for inertias are no larger than the rest of the machine.
    const reach = (placed) => {
      const points = placed.filter((_, k) => !this.places.elements[k].is_of_inertia).flatMap(corners);
      return Math.max(...[0, 1, 2].map((k) => extent([points.map((point) => point[k])])).map(([low, high]) => high - low));
    };
    const rest = all.map(reach);
    const isAlone = !this.places.elements.some(({ kind, is_of_inertia }) => !is_of_inertia && !["up", "hinge", "ball", "slide"].includes(kind));
    this.most = isAlone ? Infinity : Math.max(0.3 * Math.max(...rest), 1e-9);
    const instants = all.map((placed) => this.kept(placed).flatMap(corners)).filter((points) => points.length);
    if (!instants.length) return;
    const points = instants.flat();
    const boxed = [0, 1, 2].map((k) => extent([points.map((point) => point[k])]));
    const size = Math.max(...boxed.map(([low, high]) => high - low));
    const distance = V.size(boxed.map(([low, high]) => Math.max(low, -high, 0)));
    this.hasOrigin = distance < 0.5 * size;
    this.view.fit(instants, up.of[0]);
  }

  kept(placed) {
    return placed.map((element, k) => (this.places.elements[k].is_of_inertia ? shrunk(element, this.most) : element));
  }

  draw(time) {
    this.time = time;
    const { run, canvas, view } = this;
    if (!run || !view.size) return;
    const all = this.places.at(run, time);
    const placed = all && this.kept(all);
    const ratio = globalThis.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!placed || !width) return;
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    view.follow(placed.flatMap(corners));
    view.aim(width, height);
    const style = getComputedStyle(canvas);
    const ink = (name) => style.getPropertyValue(name).trim();
    this.inks = { ink: ink("--ink"), muted: ink("--muted"), rule: ink("--rule"), paper: ink("--paper") };
    const solids = new Solids(view.size);
    placed.forEach((element, k) => solids.add(element, this.colours[k]));
    if (this.hasGround) this.ground(context, solids);
    this.paint(context, solids);
    if (this.hasOrigin) this.axes(context);
    if (this.showsNames) this.names(context, placed);
  }

  // A grid below the machine, with the machine's shadow.
  ground(context, solids) {
    const { view } = this;
    const { right, ahead, up, target, spans } = view;
    const level = view.level - 0.01 * view.size;
    const onto = (point) => V.add(point, V.mul(level - V.dot(point, up), up));
    const power = 10 ** Math.floor(Math.log10(view.size));
    const step = power * (view.size > 4 * power ? 1 : view.size > 1.6 * power ? 0.5 : 0.2);
    const bounds = [right, ahead].map((axis, k) => {
      const half = 0.5 * (spans[k][1] - spans[k][0]) + 0.15 * view.size;
      const middle = V.dot(target, axis);
      return [Math.floor((middle - half) / step) * step, Math.ceil((middle + half) / step) * step];
    });
    const at = (a, b) => view.see(V.add(V.add(V.mul(a, right), V.mul(b, ahead)), V.mul(level, up)));
    context.strokeStyle = this.inks.rule;
    context.lineWidth = 1;
    context.beginPath();
    const line = (from, to) => {
      context.moveTo(from[0], from[1]);
      context.lineTo(to[0], to[1]);
    };
    for (let a = bounds[0][0]; a <= bounds[0][1] + 1e-9 * step; a += step) line(at(a, bounds[1][0]), at(a, bounds[1][1]));
    for (let b = bounds[1][0]; b <= bounds[1][1] + 1e-9 * step; b += step) line(at(bounds[0][0], b), at(bounds[0][1], b));
    context.stroke();
    context.fillStyle = this.inks.ink;
    context.globalAlpha = 0.1;
    context.beginPath();
    for (const { points, normal } of solids.faces) {
      if (V.dot(normal, up) <= 0) continue;
      points.map((point) => view.see(onto(point))).forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.closePath();
    }
    if (V.dot(view.back, up) > 0) context.fill();
    context.globalAlpha = 1;
  }

  paint(context, solids) {
    const { view } = this;
    const light = V.unit(V.add(V.add(V.mul(0.5, view.back), V.mul(0.75, view.up)), V.mul(-0.35, view.side)));
    const colour = (name) => (name.startsWith("#") ? name : { joint: "#5b6470", link: "#9aa1ab", axis: "#d55e00", mark: "#1d2126" }[name]);
    const drawn = [];
    for (const face of solids.faces) {
      if (!view.faces(face.points[0], face.normal)) continue;
      const seen = face.points.map((point) => view.see(point));
      const depth = seen.reduce((sum, point) => sum + point[2], 0) / seen.length;
      const shade = face.tint * (0.62 + 0.38 * Math.max(0, V.dot(face.normal, light)));
      drawn.push({ seen, depth, fill: shaded(colour(face.colour), shade) });
    }
    for (const { points, colour: name, normal, middle } of solids.lines) {
      if (normal && !view.faces(points[0], normal)) continue;
      const seen = points.map((point) => view.see(point));
      const near = middle ? view.see(middle)[2] : seen.reduce((sum, point) => sum + point[2], 0) / seen.length;
      const depth = near + 0.004 * view.size;
      drawn.push({ seen, depth, stroke: colour(name), width: name === "axis" ? 1 : 1.8 });
    }
    drawn.sort((a, b) => a.depth - b.depth);
    context.lineJoin = "round";
    context.lineCap = "round";
    for (const { seen, fill, stroke, width } of drawn) {
      context.beginPath();
      seen.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
      if (fill) {
        context.closePath();
        context.fillStyle = fill;
        context.strokeStyle = fill;
        context.lineWidth = 0.6;
        context.fill();
        context.stroke();
      } else {
        context.strokeStyle = stroke;
        context.lineWidth = width;
        context.stroke();
      }
    }
  }

  // The world's axes.
  axes(context) {
    const length = 0.14 * this.view.size;
    const from = this.view.see([0, 0, 0]);
    context.lineWidth = 1.6;
    context.font = "600 12px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    [["x", "#c8372d"], ["y", "#2f8f46"], ["z", "#2f6fd0"]].forEach(([name, colour], k) => {
      const end = [0, 1, 2].map((i) => (i === k ? length : 0));
      const [to, text] = [this.view.see(end), this.view.see(V.mul(1.18, end))];
      context.strokeStyle = colour;
      context.fillStyle = colour;
      context.beginPath();
      context.moveTo(from[0], from[1]);
      context.lineTo(to[0], to[1]);
      context.stroke();
      context.fillText(name, text[0], text[1]);
    });
  }

  names(context, placed) {
    context.font = "11.5px system-ui, sans-serif";
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.lineWidth = 3;
    context.strokeStyle = this.inks.paper;
    context.fillStyle = this.inks.ink;
    const told = new Set();
    for (const { kind, name, of } of placed) {
      if (kind === "up" || kind === "link" || told.has(name)) continue;
      told.add(name);
      const ends = ["cylinder", "rod", "spring", "slide"].includes(kind) ? V.mul(0.5, V.add(of[0], of[1])) : of[0];
      const [x, y] = this.view.see(ends);
      context.strokeText(name, x + 9, y - 9);
      context.fillText(name, x + 9, y - 9);
    }
  }

  redraw() {
    this.draw(this.time);
  }

  listen() {
    const { canvas, view, figure } = this;
    const signal = { signal: ending.signal };
    const turn = (across, down) => {
      view.turn -= across;
      view.rise = Math.max(-1.5, Math.min(1.5, view.rise + down));
      this.redraw();
    };
    const zoom = (factor) => {
      view.zoom = Math.max(0.2, Math.min(20, view.zoom * factor));
      this.redraw();
    };
    const pointers = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const now = [event.clientX, event.clientY];
      if (pointers.size === 1) turn((now[0] - before[0]) / 140, (now[1] - before[1]) / 140);
      else {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const apart = (point) => Math.hypot(point[0] - other[0], point[1] - other[1]);
        zoom(apart(now) / Math.max(1, apart(before)));
      }
      pointers.set(event.pointerId, now);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
    // The page scrolls over a drawing that nobody has touched.
    canvas.addEventListener("wheel", (event) => {
      if (document.activeElement !== canvas && !event.ctrlKey) return;
      event.preventDefault();
      zoom(Math.exp(-event.deltaY / (event.deltaMode ? 25 : 600)));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (event.altKey || event.ctrlKey || event.metaKey) return;
      if (by) turn(...by);
      else if (event.key === "+" || event.key === "=") zoom(1.15);
      else if (event.key === "-") zoom(1 / 1.15);
      else if (event.key === "0") {
        view.reset();
        this.redraw();
      } else return;
      event.preventDefault();
    });
    const [names, parallel, reset] = figure.querySelectorAll("button");
    const toggle = (button, change) => button.addEventListener("click", () => {
      const isOn = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(isOn));
      change(isOn);
      this.redraw();
    });
    toggle(names, (isOn) => { this.showsNames = isOn; });
    toggle(parallel, (isOn) => { view.isParallel = isOn; });
    reset.addEventListener("click", () => {
      view.reset();
      this.redraw();
    });
    const sized = new ResizeObserver(() => this.redraw());
    sized.observe(canvas);
    ending.signal.addEventListener("abort", () => sized.disconnect());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw(), signal);
  }
}

const shades = new Map();

// A colour, brighter or darker.
function shaded(colour, share) {
  const step = Math.round(share * 40);
  const key = colour + step;
  if (!shades.has(key)) {
    const parts = [1, 3, 5].map((at) => Math.min(255, Math.round((parseInt(colour.slice(at, at + 2), 16) * step) / 36)));
    shades.set(key, `rgb(${parts.join(" ")})`);
  }
  return shades.get(key);
}
