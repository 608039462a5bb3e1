// Constraints, g(q, t) = 0: states put back onto them by the shortest way as the mass matrix
// measures it, first in position, then in velocity, and the start of a run on them.

class Constraints {
  constructor(machine) {
    const { coordinates, constraints } = machine.known;
    const [n, m] = [coordinates, constraints.length];
    Object.assign(this, { machine, n, m, factors: new Factors(n + m) });
    this.mass = new Float64Array(n * n);
    this.slopes = new Float64Array(m * n);
    this.levels = [["constraint_values", 0], ["constraint_rates", n]];
    this.holdsInModes = constraints.some(({ in_modes }) => in_modes);
  }

  project(time, state, levels = this.levels) {
    const ROUNDING = 1e-12;
    for (const level of levels) {
      let { residuals, off } = this.off(level, time, state);
      for (let round = 0; round < 10 && !(largest(off) <= 4 * EPSILON); round++) {
        const shift = this.shift(time, state, residuals);
        const before = state.slice();
        for (let index = 0; index < this.n; index++) state[level[1] + index] -= shift[index];
        const next = this.off(level, time, state);
        if (!(largest(next.off) < largest(off))) {
          state.set(before);
          break;
        }
        ({ residuals, off } = next);
      }
      const lost = off.findIndex((value) => !(value <= ROUNDING));
      if (lost >= 0) throw new Stopped(time, `the state cannot be put back onto constraint ${this.name(lost)}`);
    }
  }

  // Puts velocities back; a failure is told once all events have happened.
  rest(time, state) {
    if (!this.holdsInModes) return;
    const before = state.slice();
    try {
      this.project(time, state, [this.levels[1]]);
    } catch (error) {
      if (!(error instanceof Stopped)) throw error;
      state.set(before);
    }
  }

  // The entry of the mode of the dry friction that sticks by a constraint.
  friction(row) {
    return this.machine.known.constraints[row].friction;
  }

  name(row) {
    return this.machine.known.constraints[row].name;
  }

  // Residuals of one level, also over what its coordinates make of them as they move by their sizes.
  off([name, first], time, state) {
    const { machine, n, m, slopes } = this;
    machine.matrix("constraint_matrix", time, state, slopes);
    const residuals = machine.values(name, time, state, m);
    const off = residuals.map((value, row) => {
      let size = 0;
      for (let k = 0; k < n; k++) {
        size += Math.abs(slopes[row * n + k]) * Math.max(machine.scales[first + k], Math.abs(state[first + k]));
      }
      return value === 0 ? 0 : Math.abs(value) / size;
    });
    return { residuals, off };
  }

  // dq of M dq + G^T mu = 0, G dq = residuals. A row that does not hold in these modes, or that
  // follows from others, has no effect; rows that always hold come first.
  shift(time, state, residuals) {
    const { machine, n, m, factors, slopes } = this;
    const size = n + m;
    machine.matrix("mass_matrix", time, state, this.mass);
    factors.values.fill(0);
    for (let row = 0; row < n; row++) factors.values.set(this.mass.subarray(row * n, row * n + n), row * size);
    const right = new Float64Array(size);
    const kept = this.holdsInModes ? this.independent() : null;
    for (let row = 0, at = n; row < m; row++, at++) {
      if (kept && !kept[row]) {
        factors.values[at * (size + 1)] = 1;
        continue;
      }
      right[at] = residuals[row];
      for (let k = 0; k < n; k++) factors.values[at * size + k] = factors.values[k * size + at] = slopes[row * n + k];
    }
    return factors.factor() ? factors.solve(right) : right.fill(NaN);
  }

  // Rows that hold in these modes and do not follow from others, of which those come first that
  // always hold.
  independent() {
    const { machine, n, m, slopes } = this;
    const isLate = (row) => machine.known.constraints[row].in_modes;
    const order = range(m).sort((a, b) => isLate(a) - isLate(b) || a - b);
    const units = perpendicular(order.map((row) =>
      Array.from(slopes.subarray(row * n, row * n + n), (slope, k) => slope * machine.scales[k])), 1e-6);
    return range(m).map((row) => units[order.indexOf(row)] !== null);
  }

  // Moves a guess onto the constraints: entries that the spec gives stay but for the tolerance.
  start(time, state) {
    const { machine, n, m } = this;
    for (const [name, first] of this.levels) {
      const given = state.slice();
      const entries = range(n).map((k) => first + k);
      const left = nearest(state, entries, entries.map((entry) => weightOf(machine, entry)), () =>
        machine.live(name, time, state, m));
      const isMoved = (entry) => machine.known.states[entry].is_given
        && Math.abs(state[entry] - given[entry]) > machine.known.run.rtol * Math.max(machine.scales[entry], Math.abs(given[entry]));
      const worst = left.indexOf(largest(left));
      if (entries.some(isMoved) || !(left[worst] <= 1e-11)) {
        throw new Stopped(time, `no start fulfils constraint ${this.name(Math.max(worst, 0))} with what is given`);
      }
    }
  }
}

// Weight of the moves of an entry of a start: one that the spec gives moves only where nothing else
// can.
function weightOf(machine, entry) {
  return machine.scales[entry] * (machine.known.states[entry].is_given ? 1e-6 : 1);
}

// Moves a state into the equilibrium near it: q'' = 0 and z' = 0 on the constraints.
function balance(system, time, state) {
  const { machine, constraints } = system;
  const { still, unknown } = machine.known.equilibrium;
  const left = nearest(state, unknown, unknown.map((entry) => weightOf(machine, entry)), () => {
    const rates = system.rates(time, state);
    const levels = constraints?.levels ?? [];
    return [...still.map((entry) => rates[entry]),
      ...levels.flatMap(([name]) => [...machine.values(name, time, state, constraints.m)])];
  });
  if (!(largest(left) <= 1e-9)) throw new Stopped(time, "no equilibrium is found near that of the stored run");
}
