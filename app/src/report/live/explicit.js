// Steps of an explicit Runge-Kutta pair, whose coefficients are the engine's:
// Y_i = y + h sum a_ij k_j, k_i = f(t + c_i h, Y_i), the last stage at the end of the step.

class ExplicitSteps {
  constructor(pair, stretch) {
    const { size } = stretch.machine;
    Object.assign(this, { pair, stretch, name: pair.name, time: 0, step: 0, trouble: "" });
    const zeros = () => new Float64Array(size);
    [this.start, this.end, this.argument, this.error] = [zeros(), zeros(), zeros(), zeros()];
    this.stages = pair.nodes.map(zeros);
    this.rows = [...pair.rows, ...pair.extra];
    this.last = pair.rows.length - 1;
    this.weights = new Float64Array(pair.nodes.length);
    this.hasExtraStages = false;
    const exponent = 1 / (pair.estimate_order + 1);
    // The eighth order changes its step less often, and needs no memory.
    const memory = pair.order > 5 ? 0 : 0.04;
    this.pace = { exponent: exponent - 0.75 * memory, memory, safety: 0.9, smallest: 0.2, largest: 8 };
  }

  begin(time, state) {
    this.time = time;
    this.step = 0;
    this.start.set(state);
    this.end.set(state);
    this.stretch.rate(time, this.end, this.stages[0]);
  }

  firstStep() {
    return firstStep(this.stretch, this.pair.order, this.time, this.start, this.stages[0]);
  }

  // The error over what the tolerances allow; not finite if the step leads nowhere.
  attempt(step) {
    this.step = step;
    this.hasExtraStages = false;
    for (let stage = 1; stage < this.last; stage++) {
      this.combine(this.rows[stage], this.start, this.argument);
      this.rate(stage, this.argument);
    }
    this.combine(this.rows[this.last], this.start, this.end);
    const [estimate] = this.pair.estimates;
    const isInEstimate = estimate[estimate.length - 1][0] === this.last;
    if (isInEstimate) this.rate(this.last, this.end);
    const error = this.errorOf();
    if (error <= 1 && !isInEstimate) this.rate(this.last, this.end);
    if (error <= 1 ? this.isFinite() : Number.isFinite(error)) return error;
    this.trouble = this.whatIsNotFinite();
    return Infinity;
  }

  errorOf() {
    const [error, lower] = this.pair.estimates.map((row) => {
      this.combine(row, null, this.error);
      return this.stretch.norm(this.error, this.start, this.end);
    });
    if (lower === undefined || !(error > 0)) return error;
    return error * (error / Math.sqrt(error * error + 0.01 * lower * lower));
  }

  isFinite() {
    return this.end.every(Number.isFinite) && this.stages[this.last].every(Number.isFinite);
  }

  whatIsNotFinite() {
    for (const stage of this.stages.slice(0, this.last + 1)) {
      const index = stage.findIndex((value) => !Number.isFinite(value));
      if (index >= 0) return `the rate of ${this.stretch.machine.nameOf(index)} is no finite number`;
    }
    return "the state is no finite number";
  }

  rate(stage, state) {
    this.stretch.rate(this.time + this.pair.nodes[stage] * this.step, state, this.stages[stage]);
  }

  // `into` = start + h sum of weight times stage; start 0 if there is none.
  combine(row, start, into) {
    if (start) into.set(start);
    else into.fill(0);
    for (const [stage, weight] of row) {
      const factor = this.step * weight;
      const rate = this.stages[stage];
      for (let index = 0; index < into.length; index++) into[index] += factor * rate[index];
    }
  }

  interpolate(time, into) {
    if (!this.hasExtraStages) {
      for (let stage = this.last + 1; stage < this.rows.length; stage++) {
        this.combine(this.rows[stage], this.start, this.error);
        this.rate(stage, this.error);
      }
      this.hasExtraStages = true;
    }
    const theta = (time - this.time) / this.step;
    into.set(this.start);
    this.pair.dense.forEach((polynomial, stage) => {
      let weight = 0;
      for (let power = polynomial.length - 1; power >= 0; power--) weight = weight * theta + polynomial[power];
      weight *= this.step;
      const rate = this.stages[stage];
      for (let index = 0; index < into.length; index++) into[index] += weight * rate[index];
    });
  }

  errorBetween() {
    return 0;
  }

  accept() {
    this.time += this.step;
    this.start.set(this.end);
    this.stages[0].set(this.stages[this.last]);
  }

  // |h lambda| of the fastest motion that the last two stages show, both at the end of the
  // step (Hairer, Wanner, section IV.2).
  stiffness() {
    const { atol, rtol } = this.stretch;
    const distance = (a, b) => {
      let sum = 0;
      for (let index = 0; index < a.length; index++) {
        const ratio = (a[index] - b[index]) / (atol[index] + rtol * Math.abs(this.end[index]));
        sum += ratio * ratio;
      }
      return sum;
    };
    const rates = distance(this.stages[this.last], this.stages[this.last - 1]);
    const ratio = Math.sqrt(rates / distance(this.end, this.argument));
    return Number.isFinite(ratio) ? Math.abs(this.step) * ratio : 0;
  }
}
