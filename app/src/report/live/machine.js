// The machine's equations, as WebAssembly, on arrays of numbers.

class Machine {
  // What the page knows of the machine; `module` is what makes it run.
  static async of(known) {
    const bytes = Uint8Array.from(atob(known.module), (letter) => letter.charCodeAt(0));
    const math = { ...Machine.HOST };
    const { instance } = await WebAssembly.instantiate(bytes, { math });
    return new Machine(known, instance.exports);
  }

  static HOST = {
    exp: Math.exp, ln: Math.log, powf: Math.pow, sin: Math.sin, cos: Math.cos, tan: Math.tan,
    asin: Math.asin, acos: Math.acos, atan: Math.atan, sinh: Math.sinh, cosh: Math.cosh,
    tanh: Math.tanh, floor: Math.floor,
  };

  constructor(known, functions) {
    this.known = known;
    this.functions = functions;
    const { layout, states, parameters } = known;
    const numbers = (place, count) => new Float64Array(functions.memory.buffer, place, count);
    this.state = numbers(layout.state, states.length);
    this.parameters = numbers(layout.parameters, parameters.length);
    this.results = numbers(layout.results);
    this.size = states.length;
    this.events = known.events.length;
    this.kinks = known.kinks;
    this.constraints = known.constraints.length;
    this.work = {};
    this.restart();
  }

  // Counts from zero.
  restart() {
    this.work = { steps: 0, rejected: 0, rates: 0, jacobians: 0, factorizations: 0, switches: 0 };
  }

  // Runs are at these parameters from now on.
  set(parameters) {
    this.parameters.set(parameters);
    this.functions.prepare(0);
  }

  call(name, time, state, into, count, offset = 0) {
    const own = this.state;
    for (let index = 0; index < own.length; index++) own[index] = state[index];
    this.functions[name](time);
    for (let index = 0; index < count; index++) into[offset + index] = this.results[index];
  }

  rate(time, state, into) {
    this.work.rates++;
    this.call("rate", time, state, into, this.size);
  }

  timeDerivative(time, state, into) {
    this.call("time_derivative", time, state, into, this.size);
  }

  // A dense matrix, row after row; what is not in the pattern stays zero.
  matrix(name, pattern, time, state, into) {
    this.call(name, time, state, this.results, 0);
    const { entries, columns } = pattern;
    for (let index = 0; index < entries.length; index++) {
      const [row, column] = entries[index];
      into[row * columns + column] = this.results[index];
    }
  }

  jacobian(time, state, into) {
    this.work.jacobians++;
    this.matrix("rate_jacobian", this.known.rate_jacobian, time, state, into);
  }

  initial() {
    const state = new Float64Array(this.size);
    this.functions.initial_state(0);
    state.set(this.results.subarray(0, this.size));
    return state;
  }

  // Times at which the rate jumps.
  jumps() {
    this.functions.discontinuities(0);
    return [...this.results.subarray(0, this.known.discontinuities)];
  }

  outputs(time, state, into) {
    if (this.known.shows_states) into.set(state);
    else this.call("outputs", time, state, into, this.known.outputs.length);
  }

  // Guards of events, then of kinks.
  guards(time, state, into) {
    if (this.events) this.call("guards", time, state, into, this.events);
    if (this.kinks) this.call("kink_guards", time, state, into, this.kinks, this.events);
    for (const kink of this.known.whole) {
      into[this.events + kink] = Machine.atWholes(into[this.events + kink])[0];
    }
  }

  // Returns a function that crosses zero where an argument of floor is an integer, and its slope.
  static atWholes(argument) {
    const whole = Math.floor(argument);
    const way = whole % 2 === 0 ? 1 : -1;
    const angle = Math.PI * (argument - whole);
    return [way * Math.sin(angle), way * Math.PI * Math.cos(angle)];
  }

  guardRates(time, state, into) {
    if (this.events) this.call("guard_rates", time, state, into, this.events);
    if (!this.kinks) return;
    const { whole } = this.known;
    const guards = new Float64Array(whole.length ? this.kinks : 0);
    if (whole.length) this.call("kink_guards", time, state, guards, this.kinks);
    this.call("kink_rates", time, state, into, this.kinks, this.events);
    for (const kink of whole) into[this.events + kink] *= Machine.atWholes(guards[kink])[1];
  }

  resets(time, state, into) {
    this.call("resets", time, state, into, into.length);
  }

  // Power supplied and power dissipated.
  powers(time, state) {
    const balance = [0, 0, 0];
    this.call("power_balance", time, state, balance, 3);
    return balance.slice(1);
  }

  nameOf(index) {
    return this.known.states[index].name;
  }
}
