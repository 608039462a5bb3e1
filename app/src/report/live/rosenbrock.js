// Steps of a Rosenbrock method, whose coefficients are the engine's; each stage solves linear
// equations with the Jacobian of the model:
// (I / (gamma h) - J) U_i = f(t + c_i h, Y_i) + sum C_ij U_j / h + d_i h f_t.

class RosenbrockSteps {
  constructor(method, stretch) {
    const { size } = stretch.machine;
    Object.assign(this, { method, stretch, size, name: method.name, time: 0, step: 0, trouble: "" });
    const zeros = () => new Float64Array(size);
    [this.start, this.end, this.argument, this.slope] = [zeros(), zeros(), zeros(), zeros()];
    [this.startRate, this.timeDerivative] = [zeros(), zeros()];
    this.jacobian = new Float64Array(size * size);
    this.factors = new Factors(size);
    [this.endJacobian, this.endFactors] = [new Float64Array(size * size), new Factors(size)];
    this.knowsEnd = false;
    this.stages = method.stages.map(zeros);
    this.dense = method.dense.map(zeros);
    this.isLinearized = false;
    this.hasDense = false;
    this.pace = { exponent: 0.2, memory: 0, safety: 0.9, smallest: 0.2, largest: 6 };
  }

  begin(time, state) {
    this.time = time;
    this.start.set(state);
    this.end.set(state);
    this.isLinearized = false;
    this.knowsEnd = false;
  }

  firstStep() {
    this.stretch.rate(this.time, this.start, this.startRate);
    return firstStep(this.stretch, 5, this.time, this.start, this.startRate);
  }

  // The error over what the tolerances allow; not finite if the step leads nowhere.
  attempt(step) {
    this.step = step;
    this.hasDense = false;
    // What was looked at belongs to a step that was taken, once.
    if (this.isLinearized) this.knowsEnd = false;
    if (!this.linearize() || !this.factor(this.factors, this.jacobian)) return Infinity;
    for (let stage = 0; stage < this.stages.length; stage++) this.stage(stage);
    this.end.set(this.argument);
    const error = this.stretch.norm(this.stages[this.stages.length - 1], this.start, this.end);
    if (Number.isFinite(error) && this.end.every(Number.isFinite)) {
      return error <= 1 && this.growsAtEnd() ? Infinity : error;
    }
    this.trouble = "the rate within the step is no finite number";
    return Infinity;
  }

  // f, f_t and J at the start, once a step however often it is tried.
  linearize() {
    if (this.isLinearized) return true;
    const { machine } = this.stretch;
    const time = this.stretch.within(this.time);
    machine.rate(time, this.start, this.startRate);
    machine.timeDerivative(time, this.start, this.timeDerivative);
    // The end of the step before was looked at already.
    if (this.knowsEnd) [this.jacobian, this.endJacobian] = [this.endJacobian, this.jacobian];
    else machine.jacobian(time, this.start, this.jacobian);
    this.knowsEnd = false;
    const isBad = (values) => values.some((value) => !Number.isFinite(value));
    if (isBad(this.startRate) || isBad(this.timeDerivative) || isBad(this.jacobian)) {
      this.trouble = "the rate or its Jacobian is no finite number";
      return false;
    }
    this.isLinearized = true;
    return true;
  }

  // Factors I / (gamma h) - J. A negative determinant tells of a motion that grows within the
  // step, which to an implicit method looks like decay: then the step is too long.
  factor(factors, jacobian) {
    const { size } = this;
    this.stretch.machine.work.factorizations++;
    for (let index = 0; index < size * size; index++) factors.values[index] = -jacobian[index];
    for (let index = 0; index < size; index++) {
      factors.values[index * (size + 1)] += 1 / (this.method.gamma * this.step);
    }
    if (factors.factor() && !factors.isNegative) return true;
    this.trouble = "the equations of a step are singular";
    return false;
  }

  // Whether something grows at the end of the step that it could have passed over.
  growsAtEnd() {
    const { machine } = this.stretch;
    this.knowsEnd = false;
    machine.jacobian(this.stretch.within(this.time + this.step), this.end, this.endJacobian);
    const isSame = this.endJacobian.every((value, index) => value === this.jacobian[index]);
    if (!isSame && !this.factor(this.endFactors, this.endJacobian)) return true;
    this.knowsEnd = true;
    return false;
  }

  // U of one stage, and Y of the next one as the argument.
  stage(stage) {
    const { method, slope, step } = this;
    const of = this.stages[stage];
    if (stage > 0) this.stretch.rate(this.time + method.nodes[stage] * step, this.argument, slope);
    else slope.set(this.startRate);
    const explicit = method.time_weights[stage] * step;
    for (let index = 0; index < this.size; index++) of[index] = slope[index] + explicit * this.timeDerivative[index];
    for (const [before, weight] of method.stages[stage]) this.add(of, weight / step, this.stages[before]);
    this.factors.solve(of);
    const next = method.states[stage + 1];
    if (stage > 0 && next[0][0] === stage) {
      this.add(this.argument, 1, of);
      return;
    }
    this.argument.set(this.start);
    for (const [before, weight] of next) this.add(this.argument, weight, this.stages[before]);
  }

  add(into, factor, values) {
    for (let index = 0; index < this.size; index++) into[index] += factor * values[index];
  }

  interpolate(time, into) {
    if (!this.hasDense) {
      this.dense.forEach((dense, row) => {
        dense.fill(0);
        this.method.dense[row].forEach((weight, stage) => this.add(dense, weight, this.stages[stage]));
      });
      this.hasDense = true;
    }
    const theta = (time - this.time) / this.step;
    const rest = 1 - theta;
    const [first, second, third] = this.dense;
    for (let index = 0; index < this.size; index++) {
      const inner = first[index] + theta * (second[index] + theta * third[index]);
      into[index] = rest * this.start[index] + theta * (this.end[index] + rest * inner);
    }
  }

  // The error half way through the step, over ten tolerances: any end of a step of a stiff
  // machine is right, and says nothing of states between.
  errorBetween() {
    const BETWEEN = 10;
    const theta = 0.5;
    const { slope, step } = this;
    const time = this.time + theta * step;
    this.interpolate(time, this.argument);
    this.stretch.rate(time, this.argument, slope);
    const [first, second, third] = this.dense;
    for (let index = 0; index < this.size; index++) {
      const chord = this.end[index] - this.start[index];
      const bow = theta * (1 - theta) * (second[index] + 2 * theta * third[index]);
      slope[index] -= (chord + bow) / step;
    }
    this.factors.solve(slope);
    return this.stretch.norm(slope, this.start, this.end) / BETWEEN;
  }

  accept() {
    this.time += this.step;
    this.start.set(this.end);
    this.isLinearized = false;
  }
}
