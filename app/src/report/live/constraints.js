// Constraints: back onto them by the shortest way as the mass matrix measures it, first in
// position, then in velocity. The rate fulfils them; steps drift off by their errors. As the
// engine does it, see its `constraints.rs`.

class Constraints {
  constructor(machine) {
    const { known } = machine;
    this.machine = machine;
    this.count = machine.constraints;
    this.coordinates = known.coordinates;
    this.matrix = new Float64Array(this.count * this.coordinates);
    this.mass = new Float64Array(this.coordinates ** 2);
    this.residuals = new Float64Array(this.count);
    this.factors = new Factors(this.coordinates + this.count);
  }

  // Puts a state of a run back onto them.
  project(time, state) {
    this.putBack("constraint_values", 0, time, state);
    this.putBack("constraint_rates", this.coordinates, time, state);
  }

  // Puts its velocities back; what cannot be is told of by the next `project`.
  rest(time, state) {
    const before = state.slice();
    try {
      this.putBack("constraint_rates", this.coordinates, time, state);
    } catch (error) {
      if (!(error instanceof Stopped)) throw error;
      state.set(before);
    }
  }

  // Newton's iteration along the shortest way, while it gets nearer.
  putBack(level, first, time, state) {
    const ROUNDS = 10;
    const ROUNDING = 1e-12;
    let off = this.off(level, first, time, state);
    for (let round = 0; round < ROUNDS && off > 4 * Number.EPSILON; round++) {
      const shift = this.shift(time, state);
      if (!shift) break;
      const before = state.slice(first, first + this.coordinates);
      for (let index = 0; index < this.coordinates; index++) state[first + index] -= shift[index];
      const now = this.off(level, first, time, state);
      if (!(now < off)) {
        state.set(before, first);
        break;
      }
      off = now;
    }
    // What is left is rounding, or the state is lost.
    if (!(off <= ROUNDING)) {
      throw new Stopped(time, `the state cannot be put back onto constraint ${this.worst}`);
    }
  }

  // G and the residuals at a state; the largest of these, each over what its coordinates make
  // of it when they move by their size.
  off(level, first, time, state) {
    const { machine, count, coordinates, matrix, residuals } = this;
    machine.matrix("constraint_matrix", machine.known.constraint_matrix, time, state, matrix);
    machine.call(level, time, state, residuals, count);
    let most = 0;
    for (let row = 0; row < count; row++) {
      if (residuals[row] === 0) continue;
      let size = 0;
      for (let column = 0; column < coordinates; column++) {
        const { scale } = machine.known.states[first + column];
        const slope = Math.abs(matrix[row * coordinates + column]);
        size += slope * Math.max(scale, Math.abs(state[first + column]));
      }
      const off = Math.abs(residuals[row]) / size;
      if (!(off <= most)) [most, this.worst] = [off, machine.known.constraints[row]];
    }
    return most;
  }

  // Which constraints shift nothing: one that does not hold in these modes, and one that repeats
  // those before it.
  idle() {
    // What is left of a row of length 1 by rounding, and more.
    const NOTHING = 1e-9;
    const { machine, count, coordinates, matrix } = this;
    const basis = [];
    const dot = (a, b) => a.reduce((sum, value, index) => sum + value * b[index], 0);
    return Array.from({ length: count }, (_, row) => {
      const slopes = matrix.subarray(row * coordinates, (row + 1) * coordinates);
      let left = Array.from(slopes, (slope, column) => slope * machine.known.states[column].scale);
      const whole = Math.sqrt(dot(left, left));
      for (const direction of [...basis, ...basis]) {
        const along = dot(left, direction);
        left = left.map((value, index) => value - along * direction[index]);
      }
      const rest = Math.sqrt(dot(left, left));
      if (rest <= NOTHING * whole) return true;
      basis.push(left.map((value) => value / rest));
      return false;
    });
  }

  // dq of M dq + G^T mu = 0, G dq = residuals.
  shift(time, state) {
    const { machine, count, coordinates, matrix, factors } = this;
    const size = coordinates + count;
    machine.matrix("mass_matrix", machine.known.mass_matrix, time, state, this.mass);
    factors.values.fill(0);
    for (let row = 0; row < coordinates; row++) {
      for (let column = 0; column < coordinates; column++) {
        factors.values[row * size + column] = this.mass[row * coordinates + column];
      }
    }
    const idle = this.idle();
    for (let row = 0; row < count; row++) {
      if (idle[row]) {
        factors.values[(coordinates + row) * (size + 1)] = 1;
        continue;
      }
      for (let column = 0; column < coordinates; column++) {
        const slope = matrix[row * coordinates + column];
        factors.values[(coordinates + row) * size + column] = slope;
        factors.values[column * size + coordinates + row] = slope;
      }
    }
    if (!factors.factor()) return null;
    const solution = new Float64Array(size);
    solution.set(this.residuals, coordinates);
    factors.solve(solution);
    return solution.every(Number.isFinite) ? solution : null;
  }

  // A state on them, from guesses: what is given stays, the rest is solved for by the shortest
  // moves that the sizes of states measure.
  start(time, state) {
    this.solve("constraint_values", 0, time, state);
    this.solve("constraint_rates", this.coordinates, time, state);
  }

  solve(level, first, time, state) {
    const ROUNDS = 200;
    const HALVINGS = 30;
    const ROUNDING = 1e-13;
    const { states } = this.machine.known;
    const free = [...Array(this.coordinates).keys()].filter((index) => !states[first + index].is_given);
    let off = this.off(level, first, time, state);
    for (let round = 0; round < ROUNDS && off > ROUNDING; round++) {
      const weighed = new Float64Array(this.count * free.length);
      for (let row = 0; row < this.count; row++) {
        free.forEach((column, k) => {
          weighed[row * free.length + k] = this.matrix[row * this.coordinates + column] * states[first + column].scale;
        });
      }
      const step = shortest(weighed, this.count, free.length, this.residuals);
      const start = free.map((index) => state[first + index]);
      const before = Math.hypot(...this.residuals);
      let isBetter = false;
      for (let halving = 0, share = 1; halving < HALVINGS && !isBetter; halving++, share *= 0.5) {
        free.forEach((index, k) => { state[first + index] = start[k] - share * states[first + index].scale * step[k]; });
        off = this.off(level, first, time, state);
        isBetter = Math.hypot(...this.residuals) < before;
      }
      if (!isBetter) {
        free.forEach((index, k) => { state[first + index] = start[k]; });
        off = this.off(level, first, time, state);
        break;
      }
    }
    if (!(off <= 10 * ROUNDING)) {
      throw new Stopped(time, `no start fulfils constraint ${this.worst} with what is given`);
    }
  }
}
