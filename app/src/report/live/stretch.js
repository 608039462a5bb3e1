// A stretch of a run without jumps, and why a run stops.

class Stopped extends Error {
  constructor(time, cause) {
    super(cause);
    this.time = time;
  }
}

// The next number below.
function nextDown(value) {
  const number = new Float64Array([value]);
  const bits = new BigInt64Array(number.buffer);
  if (value === 0) return -Number.MIN_VALUE;
  bits[0] += value > 0 ? -1n : 1n;
  return number[0];
}

class Stretch {
  constructor(run, from, until) {
    Object.assign(this, { run, machine: run.machine, from, until });
    this.rtol = run.rtol;
    this.atol = run.atol;
    this.last = nextDown(until);
  }

  // Time moved into the stretch: a jump at its end has its new value from there on.
  within(time) {
    return Math.max(Math.min(time, this.last), this.from);
  }

  rate(time, state, into) {
    this.machine.rate(this.within(time), state, into);
  }

  // Root mean square of errors over what the tolerances allow between two states.
  norm(errors, before, after) {
    const { atol, rtol } = this;
    let sum = 0;
    for (let index = 0; index < errors.length; index++) {
      const size = Math.max(Math.abs(before[index]), Math.abs(after[index]));
      const ratio = errors[index] / (atol[index] + rtol * size);
      sum += ratio * ratio;
    }
    return Math.sqrt(sum / errors.length);
  }

  // Refuses a state that is not finite, or so large that its square is not.
  requireBounded(time, state) {
    const index = state.findIndex((value) => !(Math.abs(value) <= 1e150));
    if (index >= 0) throw this.notFinite(`the state ${this.machine.nameOf(index)}`, state[index], time);
  }

  notFinite(what, value, time) {
    const is = Number.isFinite(value) ? `grows beyond all bounds (${value.toExponential(1)})` : "is no finite number";
    return new Stopped(time, `${what} ${is}`);
  }
}

// A first step by the size of the rate and of its change over a trial step (Hairer, Norsett,
// Wanner, section II.4).
function firstStep(stretch, order, time, state, rate) {
  const { atol, rtol, until } = stretch;
  const size = (values) => {
    let sum = 0;
    for (let index = 0; index < values.length; index++) {
      const ratio = values[index] / (atol[index] + rtol * Math.abs(state[index]));
      sum += ratio * ratio;
    }
    return Math.sqrt(sum / values.length);
  };
  const span = until - time;
  const [ofState, ofRate] = [size(state), size(rate)];
  const first = ofState < 1e-5 || ofRate < 1e-5 ? 1e-6 : (0.01 * ofState) / ofRate;
  const guess = Number.isFinite(first) ? Math.min(first, span) : 1e-6 * span;
  const trial = state.map((value, index) => value + guess * rate[index]);
  const ahead = new Float64Array(state.length);
  stretch.rate(time + guess, trial, ahead);
  const change = size(ahead.map((value, index) => value - rate[index])) / guess;
  const largest = Math.max(ofRate, change);
  let step = (0.01 / largest) ** (1 / order);
  if (Number.isNaN(largest)) step = 1e-3 * guess;
  else if (largest <= 1e-15) step = Math.max(guess * 1e-3, 1e-6);
  step = Math.min(step, 100 * guess, span);
  return step > 0 && Number.isFinite(step) ? step : 1e-6 * span;
}
