// Zeros of watched functions within a step, on its dense output. Branches are held, so functions
// are smooth: polynomials through their samples, in Bernstein form, are halved until a sign is sure.
// A function that was zero but for rounding is divided by the time since then.

const NODES = 9;
const SHARES = range(NODES).map((k) => 0.5 * (1 - Math.cos((Math.PI * k) / (NODES - 1))));
// Rounding errors of the terms of a function, or of time, that count as zero.
const ROUNDINGS = 64;

// From samples to Chebyshev coefficients, and from these to Bernstein's form on [0, 1].
const TO_CHEBYSHEV = range(NODES).map((k) => SHARES.map((share, j) => {
  const half = (index) => (index % (NODES - 1) === 0 ? 0.5 : 1);
  return (half(k) * half(j) * 2 * Math.cos(k * Math.acos(2 * share - 1))) / (NODES - 1);
}));
const TO_BERNSTEIN = (() => {
  const powers = [[1], [-1, 2]];
  for (let k = 2; k < NODES; k++) {
    const [one, two] = [powers[k - 1], powers[k - 2]];
    powers.push(range(k + 1).map((p) => 4 * (one[p - 1] ?? 0) - 2 * (one[p] ?? 0) - (two[p] ?? 0)));
  }
  const choose = (n, k) => range(k).reduce((product, i) => (product * (n - i)) / (i + 1), 1);
  return range(NODES).map((row) => powers.map((polynomial) => polynomial.slice(0, row + 1)
    .reduce((sum, c, p) => sum + (c * choose(row, p)) / choose(NODES - 1, p), 0)));
})();

// Coefficients that enclose a function of these samples, each off by some noise, and the error: as
// the last Chebyshev coefficients decay, so do the others.
function enclosed(samples, noise) {
  const modes = TO_CHEBYSHEV.map((row) => dot(row, samples));
  const pair = (k) => Math.abs(modes[k]) + Math.abs(modes[k + 1]);
  const [tail, rest] = [pair(NODES - 2), modes.slice(1)];
  const decay = Math.sqrt(tail / pair(NODES - 4));
  const rounding = 16 * EPSILON * largest(samples);
  let error = rounding;
  if (tail <= Math.max(rounding, 2 * noise)) error += 2 * noise;
  else if (decay < 1 && tail <= 1e-3 * largest(rest)) error += (8 * tail) / (1 - decay);
  else error += rest.reduce((sum, mode) => sum + Math.abs(mode), 0);
  const told = error;
  const kept = modes.map((mode) => {
    if (Math.abs(mode) > told) return mode;
    error += Math.abs(mode);
    return 0;
  });
  return { coefficients: TO_BERNSTEIN.map((row) => dot(row, kept)), error };
}

function middleOf(low, high) {
  const middle = low + 0.5 * (high - low);
  const isResolved = high - low > 4 * EPSILON * Math.max(Math.abs(low), Math.abs(high));
  return isResolved && low < middle && middle < high ? middle : null;
}

// Watched functions over a step of a method; `look` gives their values at a time and state.
class Looks {
  constructor(look, count) {
    Object.assign(this, { look, sizes: new Array(count).fill(0), noise: new Array(count).fill(0) });
  }

  begin(method, [from, start], [until, end]) {
    Object.assign(this, { method, from, until, state: start.slice() });
    this.samples = new Map();
    this.ends = [[from, start], [until, end]].map(([time, state]) => this.keep(time, this.look(time, state)));
  }

  keep(time, values) {
    for (let index = 0; index < values.length; index++) {
      this.sizes[index] = Math.max(this.sizes[index], Math.abs(values[index]) || 0);
    }
    this.samples.set(time, values);
    return values;
  }

  at(time, isKept = true) {
    const found = this.samples.get(time);
    if (found) return found;
    this.method.interpolate(time, this.state);
    const values = this.look(time, this.state);
    return isKept ? this.keep(time, values) : values;
  }

  // Rounding error of a function, as that of the values that it compares.
  rounding(index) {
    return ROUNDINGS * EPSILON * Math.max(this.sizes[index], this.noise[index]);
  }

  // Positive while a function is on a side of zero.
  deflated({ index, side, zero }, time, isKept) {
    if (!zero) return side * this.at(time, isKept)[index];
    if (time <= zero.time) return side * zero.rate;
    return (side * (this.at(time, isKept)[index] - zero.residual)) / (time - zero.time);
  }

  // The first time between two others at which a function leaves its side, or null; `pieces` is
  // how many parts may still be looked at.
  first(of, low, high, pieces = { left: 1000 }) {
    const times = SHARES.map((share, k) => (k === NODES - 1 ? high : low + (high - low) * share));
    const values = times.map((time) => this.deflated(of, time));
    // It changes by less than half of what it is away from zero.
    if (!of.zero && Math.min(...values) > 2 * (Math.max(...values) - Math.min(...values))) return null;
    const since = (k) => (of.zero ? Math.max(times[k] - of.zero.time, 0) : 1);
    const rounding = this.rounding(of.index);
    const { coefficients, error } = enclosed(values, (0.25 * rounding) / (since(0) || since(1)));
    if (coefficients.every((value) => value > error)) return null;
    if (values.every((value, k) => Math.abs(value * since(k)) <= rounding)) return null;
    const isBeyond = (k) => -values[k] * since(k) > rounding;
    if (values[0] < -error && isBeyond(0)) return low;
    const [start, end] = [coefficients[0], coefficients[NODES - 1]];
    const steps = coefficients.slice(1).map((value, k) => value - coefficients[k]);
    const isMonotone = (steps.every((by) => by <= 0) || steps.every((by) => by >= 0)) && error <= 1e-2 * Math.abs(end - start);
    if (isMonotone && values[NODES - 1] < values[0] && isBeyond(NODES - 1)) return this.root(of, low, high);
    pieces.left--;
    const middle = middleOf(low, high);
    if (middle === null || pieces.left <= 0) return values[NODES - 1] < 0 ? high : null;
    return this.first(of, low, middle, pieces) ?? this.first(of, middle, high, pieces);
  }

  // The same between a time at which it is on the side and one at which it is not, by false
  // position with halving (Illinois); never early.
  root(of, low, high) {
    let [atLow, atHigh] = [low, high].map((time) => this.deflated(of, time));
    if (atLow <= 0) return low;
    for (let [kept, round, middle] = [0, 1, 0]; (middle = middleOf(low, high)) !== null; round++) {
      const chord = high - (high - low) * (atHigh / (atHigh - atLow));
      const time = low < chord && chord < high && round % 4 !== 0 ? chord : middle;
      const value = this.deflated(of, time, false);
      if (value > 0) {
        [low, atLow, atHigh, kept] = [time, value, kept === 1 ? atHigh / 2 : atHigh, 1];
      } else {
        [high, atHigh, atLow, kept] = [time, value, kept === -1 ? atLow / 2 : atLow, -1];
      }
      if (value === 0) break;
    }
    return high;
  }
}
