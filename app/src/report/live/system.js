// The equations of a run: rates with branches as steps hold them, along switching surfaces if the
// motion slides there, and states put back onto surfaces and constraints. Along surfaces
//   y' = f- + alpha (f+ - f-),   g' = 0 where it jumps (first order), else g'' = 0 (second).

class System {
  constructor(machine, from, until) {
    Object.assign(this, { machine, slides: [], atol: [], rtol: machine.known.run.rtol });
    this.ends = [from, until];
    this.constraints = machine.known.constraints.length ? new Constraints(machine) : null;
  }

  // Time moved between the ends: at a jump in time the values before it hold until there.
  within(time) {
    const [from, until] = this.ends;
    const last = until === 0 ? -Number.MIN_VALUE : until - 4 * EPSILON * Math.abs(until);
    return Math.max(Math.min(time, last), from + 4 * EPSILON * Math.abs(from));
  }

  rate(time, state, into) {
    if (!this.slides.length) this.machine.rate(this.within(time), state, into);
    else into.set(this.blended("rate", this.within(time), state, into.length));
    return into;
  }

  rates(time, state) {
    return this.rate(time, state, new Float64Array(state.length));
  }

  // Results of a function that is linear in forces, along the surfaces.
  blended(name, time, state, count) {
    const below = this.machine.values(name, time, state, count);
    if (!this.slides.length) return below;
    const { alphas } = this.combination(time, state);
    const above = this.above(() => this.machine.values(name, time, state, count));
    return below.map((value, index) =>
      above.reduce((sum, side, k) => sum + alphas[k] * (side[index] - value), value));
  }

  // Results of `call` above each surface, below all others.
  above(call) {
    const { slots } = this.machine;
    return this.slides.map(({ relation, below }) => {
      slots[relation] = aboveSlot(below);
      const found = call();
      slots[relation] = below;
      return found;
    });
  }

  // The shares of the rates above that keep the motion on its surfaces, with the factors of their
  // equations and the differences of the rates.
  combination(time, state) {
    const { machine, slides } = this;
    const side = () => {
      const rate = new Float64Array(state.length);
      machine.rate(time, state, rate);
      const rates = machine.kinks("kink_rates", time, state);
      const slope = ({ relation, isSecond }) =>
        (isSecond ? this.bend(relation, time, state, rate) : rates[relation]);
      return { rate, slopes: slides.map(slope) };
    };
    const below = side();
    const above = this.above(side);
    const factors = new Factors(slides.length);
    factors.values.set(below.slopes.flatMap((slope, row) => above.map(({ slopes }) => slopes[row] - slope)));
    const isUnique = factors.factor();
    const alphas = below.slopes.map((slope) => (isUnique ? -slope : NaN));
    if (isUnique) factors.solve(alphas);
    return { alphas, factors, across: above.map(({ rate }) => rate.map((value, k) => value - below.rate[k])) };
  }

  // g'' along a rate, by a central difference of g': of a kink, or of another guard.
  bend(index, time, state, rate, name = "kink_rates", count = this.machine.known.kinks) {
    const { machine } = this;
    const speeds = rate.map((value, k) => value / Math.max(Math.abs(state[k]), machine.scales[k]));
    const by = Math.cbrt(EPSILON) / (largest(speeds) || 1);
    const [ahead, behind] = [by, -by].map((by) =>
      machine.values(name, time + by, state.map((value, k) => value + by * rate[k]), count)[index]);
    return (ahead - behind) / (2 * by);
  }

  jacobian(time, state, into) {
    this.machine.work.jacobians++;
    if (!this.slides.length) return this.machine.matrix("rate_jacobian", this.within(time), state, into);
    range(state.length).forEach((column) => this.difference(time, state, column).forEach((value, row) => {
      into[row * state.length + column] = value;
    }));
    return into;
  }

  byTime(time, state) {
    if (this.slides.length) return this.difference(time, state, -1);
    return this.machine.values("time_derivative", this.within(time), state, state.length);
  }

  // A derivative of the rate by a state, or by time, by a central difference.
  difference(time, state, entry) {
    const size = entry < 0 ? Math.max(Math.abs(time), 1) : Math.max(Math.abs(state[entry]), this.machine.scales[entry]);
    const by = Math.cbrt(EPSILON) * size;
    const at = (by) => this.rates(entry < 0 ? time + by : time, state.map((value, k) => (k === entry ? value + by : value)));
    const behind = at(-by);
    return at(by).map((value, k) => (value - behind[k]) / (2 * by));
  }

  // Root mean square of errors over the tolerances between two states.
  norm(errors, before, after) {
    let sum = 0;
    for (let index = 0; index < errors.length; index++) {
      const size = Math.max(Math.abs(before[index]), Math.abs(after[index]));
      sum += (errors[index] / (this.atol[index] + this.rtol * size)) ** 2;
    }
    return Math.sqrt(sum / errors.length);
  }

  // Puts a state back onto constraints and surfaces: onto those of first order in the direction of
  // their forces, onto those of second order by the shortest way.
  project(time, state) {
    this.constraints?.project(time, state);
    const off = () => {
      const values = this.machine.kinks("kink_guards", time, state);
      return this.slides.map(({ relation, below }) => values[relation] - levelOf(below));
    };
    for (let round = 0; round < 3 && this.slides.length; round++) {
      const values = off();
      const shares = this.slides.map(({ isSecond }, place) => (isSecond ? 0 : -values[place]));
      if (shares.every((share) => share === 0)) break;
      const { factors, across } = this.combination(time, state);
      factors.solve(shares);
      across.forEach((side, k) => side.forEach((value, index) => { state[index] += shares[k] * value; }));
    }
    const second = (values) => values.filter((_, place) => this.slides[place].isSecond);
    if (!this.slides.some(({ isSecond }) => isSecond)) return;
    const entries = range(state.length).filter((entry) => !this.machine.isMode[entry]);
    nearest(state, entries, entries.map((entry) => this.machine.scales[entry]), () => {
      const rates = this.machine.kinks("kink_rates", time, state);
      return [...second(off()), ...second(this.slides.map(({ relation }) => rates[relation]))];
    });
  }

  // Refuses a state, or rates, that are no finite numbers or have no finite squares.
  require(time, values, what) {
    const index = values.findIndex((value) => !(Math.abs(value) <= 1e150));
    if (index < 0) return;
    const is = Number.isFinite(values[index]) ? "grows beyond all bounds" : "is no finite number";
    throw new Stopped(time, `${what} ${this.machine.name(index)} ${is}`);
  }
}
