// Steps of an explicit Runge-Kutta pair and of a Rosenbrock method, whose coefficients are the
// engine's. `attempt` returns the error of a step over the tolerances, not finite if it leads nowhere.

class Steps {
  constructor(system, method, stages, exponent) {
    const { size } = system.machine;
    Object.assign(this, { system, method, size, name: method.name, exponent, time: 0, step: 0 });
    [this.start, this.end, this.argument, this.scratch] = range(4).map(() => new Float64Array(size));
    this.stages = range(stages).map(() => new Float64Array(size));
  }

  begin(time, state) {
    Object.assign(this, { time, isReady: false });
    this.start.set(state);
    this.end.set(state);
  }

  accept() {
    this.begin(this.time + this.step, this.end);
  }

  // A first step, over which the state would change by a hundredth (Hairer, Norsett, Wanner II.4).
  firstStep() {
    const { system, start } = this;
    const [of, by] = [start, system.rates(this.time, start)].map((values) => system.norm(values, start, start));
    const guess = of < 1e-5 || !(by >= 1e-5) ? 1e-6 : (0.01 * of) / by;
    return Math.min(guess, system.ends[1] - this.time);
  }

  // `into` = `from` + sum of weight times stage, times a factor; from 0 if there is none.
  combine(row, from, into, factor) {
    if (from) into.set(from);
    else into.fill(0);
    for (let k = 0; k < row.length; k++) {
      const values = this.stages[row[k][0]];
      const by = factor * row[k][1];
      for (let index = 0; index < into.length; index++) into[index] += by * values[index];
    }
    return into;
  }

  errorBetween() {
    return 0;
  }
}

// Y_i = y + h sum a_ij k_j, k_i = f(t + c_i h, Y_i), the last stage at the end of the step.
class ExplicitSteps extends Steps {
  constructor(system, pair) {
    super(system, pair, pair.nodes.length, 1 / (pair.estimate_order + 1));
    this.last = pair.rows.length - 1;
    this.powers = pair.dense[0].map(() => new Float64Array(this.size));
  }

  rate(stage, state) {
    this.system.rate(this.time + this.method.nodes[stage] * this.step, state, this.stages[stage]);
  }

  attempt(step) {
    const { system, method, start, end, last } = this;
    Object.assign(this, { step, isDense: false });
    if (!this.isReady) system.rate(this.time, start, this.stages[0]);
    this.isReady = true;
    for (let stage = 1; stage <= last; stage++) {
      this.rate(stage, this.combine(method.rows[stage], start, stage === last ? end : this.argument, step));
    }
    const [error, lower] = method.estimates.map((row) =>
      system.norm(this.combine(row, null, this.scratch, step), start, end));
    if (!this.stages[last].every(Number.isFinite)) return NaN;
    return lower === undefined || !(error > 0) ? error : error ** 2 / Math.sqrt(error ** 2 + 0.01 * lower ** 2);
  }

  accept() {
    super.accept();
    this.stages[0].set(this.stages[this.last]);
    this.isReady = true;
  }

  interpolate(time, into) {
    const { method, step, last, start } = this;
    if (!this.isDense) {
      method.extra.forEach((row, k) => this.rate(last + 1 + k, this.combine(row, start, this.scratch, step)));
      this.powers.forEach((into, power) => this.combine(method.dense.map((row, stage) => [stage, row[power]]), null, into, step));
      this.isDense = true;
    }
    const theta = (time - this.time) / step;
    for (let k = 0; k < into.length; k++) {
      let sum = 0;
      for (let power = this.powers.length - 1; power >= 0; power--) sum = sum * theta + this.powers[power][k];
      into[k] = start[k] + sum;
    }
  }

  // |h lambda| of the fastest motion that the last two stages show (Hairer, Wanner, IV.2).
  stiffness() {
    const { stages, end, last } = this;
    const apart = (a, b) => this.system.norm(a.map((value, k) => value - b[k]), end, end);
    return (this.step * apart(stages[last], stages[last - 1])) / apart(end, this.argument);
  }
}

// (I / (gamma h) - J) U_i = f(t + c_i h, Y_i) + sum C_ij U_j / h + d_i h f_t.
class RosenbrockSteps extends Steps {
  constructor(system, method) {
    super(system, method, method.stages.length, 0.2);
    this.jacobian = new Float64Array(this.size ** 2);
    this.factors = new Factors(this.size);
  }

  attempt(step) {
    const { system, method, start, end, argument, scratch, size, stages } = this;
    Object.assign(this, { step, isDense: false });
    if (!this.isReady) {
      this.byTime = system.byTime(this.time, start);
      system.jacobian(this.time, start, this.jacobian);
      this.isReady = true;
    }
    // A negative determinant tells of a motion that grows within the step, which would decay.
    if (!this.factor()) return NaN;
    stages.forEach((of, stage) => {
      this.advance(stage, argument);
      system.rate(this.time + method.nodes[stage] * step, argument, scratch);
      this.combine(method.stages[stage], scratch, of, 1 / step);
      for (let index = 0; index < size; index++) of[index] += method.time_weights[stage] * step * this.byTime[index];
      this.factors.solve(of);
    });
    this.advance(stages.length, end);
    return system.norm(stages[stages.length - 1], start, end);
  }

  // Y of a stage; a row that begins with the stage before goes on from its Y.
  advance(stage, into) {
    const row = this.method.states[stage];
    const isNext = stage > 1 && row[0][0] === stage - 1;
    this.combine(row, isNext ? this.argument : this.start, into, 1);
  }

  factor() {
    const { factors, size } = this;
    this.jacobian.forEach((value, index) => { factors.values[index] = -value; });
    for (let k = 0; k < size; k++) factors.values[k * (size + 1)] += 1 / (this.method.gamma * this.step);
    return factors.factor() && !factors.isNegative;
  }

  interpolate(time, into) {
    const theta = (time - this.time) / this.step;
    const { start, end } = this;
    if (!this.isDense) {
      this.dense = this.method.dense.map((row) => this.combine([...row.entries()], null, new Float64Array(this.size), 1));
      this.isDense = true;
    }
    const [first, second, third] = this.dense;
    return into.forEach((_, k) => {
      const inner = first[k] + theta * (second[k] + theta * third[k]);
      into[k] = (1 - theta) * start[k] + theta * (end[k] + (1 - theta) * inner);
    });
  }

  // The error half way, over ten tolerances: any end of a step of a stiff machine is right, and
  // says nothing of states between.
  errorBetween() {
    const { system, argument, scratch, start, end, step } = this;
    this.interpolate(this.time + step / 2, argument);
    system.rate(this.time + step / 2, argument, scratch);
    const [, second, third] = this.dense;
    for (let k = 0; k < this.size; k++) scratch[k] -= (end[k] - start[k] + (second[k] + third[k]) / 4) / step;
    return system.norm(this.factors.solve(scratch), start, end) / 10;
  }
}
