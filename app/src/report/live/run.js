// A run of the machine: cut at jumps and events, stepped by a method with control of the error,
// sampled from the method's dense output. A generator, so that the page stays alive: it yields
// after every step. The driver is the engine's, see its `one_step.rs`.

// Steps that speak for stiffness before the method changes, and those that speak against it
// before the evidence is void (Hairer, Wanner, section IV.2).
const STIFF_STEPS = 15;
const EASY_STEPS = 6;
// So many steps at least from end to end of a stretch where nothing moves.
const LOOKS = 100;

class Run {
  // Of parameters, its ends and the number of its output times; equally spaced, unless these are
  // given.
  constructor(machine, { parameters, from, until, points, times }) {
    const { known } = machine;
    Object.assign(this, { machine, from, until, points, taken: 0, stopped: null });
    this.rtol = known.run.rtol;
    machine.restart();
    machine.set(parameters);
    this.times = times ? Float64Array.from(times) : Float64Array.from({ length: points }, (_, index) =>
      (index === points - 1 ? until : Math.min(from + (until - from) * (index / (points - 1)), until)));
    this.outputs = known.outputs.map(() => new Float64Array(points));
    this.row = new Float64Array(known.outputs.length);
    this.tracks = new Map(known.tracked.map((entry) => [entry, new Float64Array(points)]));
    this.scratch = new Float64Array(machine.size);
    this.constraints = machine.constraints ? new Constraints(machine) : null;
    this.watch = null;
    this.isStiff = known.run.is_stiff;
    this.used = new Set();
  }

  // A column by its name.
  column(name) {
    return this.outputs[this.machine.known.outputs.indexOf(name)];
  }

  // Names of the methods that took steps.
  methods() {
    return [...this.used].join(" and ");
  }

  get work() {
    return this.machine.work;
  }

  get switches() {
    return this.watch?.switches ?? [];
  }

  // Runs to the end, or to where it stops, which is told in `stopped`.
  *steps() {
    try {
      yield* this.carry();
    } catch (error) {
      if (!(error instanceof Stopped)) throw error;
      this.stopped = error;
    }
  }

  *carry() {
    const { machine, from, until } = this;
    const equilibrium = machine.known.equilibrium ? new Equilibrium(machine, from) : null;
    const state = equilibrium?.guess() ?? machine.initial();
    const bad = state.findIndex((value) => !Number.isFinite(value));
    if (bad >= 0) throw new Stopped(from, `the initial value of ${machine.nameOf(bad)} is no finite number`);
    this.constraints?.start(from, state);
    equilibrium?.find(state);
    this.atol = this.scales(state).map((scale) => this.rtol * scale);
    this.tighten(state);
    if (machine.events + machine.kinks > 0) {
      this.watch = new Watch(this);
      this.watch.parts.stretch = new Stretch(this, from, until);
      this.watch.settleStart(from, state);
      this.settle(equilibrium, state);
      this.constraints?.project(from, state);
    }
    this.sampleUntil(from, state);
    const jumps = machine.jumps();
    const wrong = jumps.find((time) => !Number.isFinite(time));
    if (wrong !== undefined) throw new Stopped(from, "the time of a jump is no finite number");
    const ends = [...new Set([...jumps.filter((time) => from < time && time < until), until])];
    ends.sort((a, b) => a - b);
    let start = from;
    for (const end of ends) {
      while (start < end) {
        const stretch = new Stretch(this, start, end);
        start = yield* this.integrate(stretch, state);
      }
    }
  }

  // The equilibrium of the modes that guards ask for, which may ask for others there.
  settle(equilibrium, state) {
    const ROUNDS = 20;
    if (!equilibrium) return;
    for (let round = 0; round < ROUNDS; round++) {
      const before = state.slice();
      equilibrium.find(state);
      this.watch.settleStart(this.from, state);
      if (state.every((value, index) => value === before[index])) return;
    }
    throw new Stopped(this.from, "the modes of the start change without end");
  }

  // Scales of states, for absolute tolerances: those of the spec; of first-order states without
  // one, by what they do to others at the start (balancing of the Jacobian).
  scales(state) {
    const { known, size } = this.machine;
    const given = known.states.map(({ scale }) => scale);
    const scales = given.slice();
    const isOpen = known.states.map(({ is_first_order, scale }) => is_first_order && scale === 1);
    if (!isOpen.includes(true)) return scales;
    const jacobian = new Float64Array(size * size);
    this.machine.jacobian(this.from, state, jacobian);
    for (const [on, by] of known.rate_jacobian.entries) {
      if (!isOpen[on] || isOpen[by]) continue;
      const ratio = jacobian[on * size + by] / jacobian[by * size + on];
      const balanced = given[by] * Math.sqrt(Math.abs(ratio));
      if (balanced > 0 && balanced < scales[on]) scales[on] = balanced;
    }
    return scales;
  }

  // Steps of `auto` are no looser than 1e-5 where they may be many; of a machine with constraints that neither gains
  // nor loses energy they are tighter, for it forgets no error.
  tighten(state) {
    const { known } = this.machine;
    if (known.run.method !== "auto") return;
    let rtol = Math.min(this.rtol, 1e-5);
    if (this.constraints && this.isConservative(state)) rtol = Math.max(rtol / 300, Math.min(1e-13, rtol));
    const share = rtol / this.rtol;
    this.rtol = rtol;
    this.atol = this.atol.map((atol) => share * atol);
  }

  isConservative(state) {
    return [0, 0.37, -0.61].every((shift) => {
      const beside = state.map((value, index) => value + shift * this.machine.known.states[index].scale);
      const time = this.from + Math.abs(shift) * (this.until - this.from);
      return this.machine.powers(time, beside).every((power) => power === 0);
    });
  }

  // Carries `state` to the end of a stretch or to an event; gives the time reached.
  *integrate(stretch, state) {
    this.requireFiniteRate(stretch, state);
    const size = Math.max(Math.abs(stretch.from), Math.abs(stretch.until));
    if (stretch.until - stretch.from <= 512 * Number.EPSILON * size) {
      this.leap(stretch, state);
      return stretch.until;
    }
    if (this.watch) {
      this.watch.parts.stretch = stretch;
      this.watch.startAt(stretch.from, state);
    }
    const { explicit, implicit } = this.machine.known.methods;
    let left = { time: stretch.from, step: null };
    if (!this.isStiff) {
      const steps = new ExplicitSteps(explicit, stretch);
      left = yield* this.drive(steps, stretch, left, state, this.evidence());
    }
    if (left && implicit) {
      this.isStiff = true;
      const steps = new RosenbrockSteps(implicit, stretch);
      yield* this.drive(steps, stretch, left, state, () => false);
    }
    const time = this.watch?.switch(state) ?? null;
    if (time === null) return stretch.until;
    this.constraints?.project(stretch.within(time), state);
    return time;
  }

  requireFiniteRate(stretch, state) {
    const rate = new Float64Array(state.length);
    stretch.rate(stretch.from, state, rate);
    const index = rate.findIndex((value) => !Number.isFinite(value));
    if (index >= 0) throw stretch.notFinite(`the rate of ${this.machine.nameOf(index)}`, NaN, stretch.from);
  }

  // One Euler step over a stretch that is as short as rounding.
  leap(stretch, state) {
    const rate = new Float64Array(state.length);
    stretch.rate(stretch.from, state, rate);
    rate.forEach((value, index) => { state[index] += (stretch.until - stretch.from) * value; });
    this.sampleUntil(stretch.until, state);
  }

  // Whether a machine is stiff: asked after every step of the explicit method.
  evidence() {
    const { explicit, implicit } = this.machine.known.methods;
    if (!implicit || this.machine.known.run.stays_explicit) return () => false;
    let [found, missed] = [0, 0];
    return (steps) => {
      if (steps.stiffness() > explicit.stability) {
        missed = 0;
        found++;
      } else if (++missed === EASY_STEPS) {
        found = 0;
      }
      return found >= STIFF_STEPS;
    };
  }

  // Steps of `method` from where it is; nothing at the end of the stretch or at an event, else
  // the time and step at which it was left because `leave` said so.
  *drive(method, stretch, left, state, leave) {
    const { pace } = method;
    this.used.add(method.name);
    let { time } = left;
    method.begin(time, state);
    let step = left.step ?? method.firstStep();
    let [lastError, before, isRejected] = [1e-4, null, false];
    const end = state.slice();
    for (;;) {
      yield;
      const { now, tried, arrives } = endOfStep(time, step, stretch.until);
      let error = method.attempt(tried);
      if (error <= 1 && (this.watch || this.isDue(now))) error = Math.max(error, method.errorBetween());
      if (!(error <= 1)) {
        this.work.rejected++;
        const shrink = Number.isFinite(error) ? Math.max(pace.smallest, Math.min(0.9, pace.safety * error ** -pace.exponent)) : 0.2;
        step = tried * shrink;
        isRejected = true;
        if (isTooSmall(step, time)) this.tooSmall(stretch, time, end, Number.isFinite(error) ? "" : method.trouble);
        continue;
      }
      const passing = this.watch?.firstPassing(method, stretch, now) ?? null;
      if (passing !== null) {
        const ending = this.endAt(method, stretch, time, now, passing, state);
        if (ending.event) return null;
        if (ending.behind !== undefined) {
          time = ending.behind;
          method.begin(time, state);
          end.set(state);
          this.watch.startAt(time, state);
          step = tried;
          [before, isRejected] = [null, false];
          if (time >= stretch.until) return null;
          continue;
        }
        this.work.rejected++;
        step = 0.5 * (passing - time);
        isRejected = true;
        if (isTooSmall(step, time)) this.tooSmall(stretch, time, end, "");
        continue;
      }
      this.work.steps++;
      const stoodStill = end.every((value, index) => Math.abs(method.end[index] - value) <= 1e-3 * stretch.atol[index]);
      const hasMoved = this.putBack(method, stretch, now, end);
      stretch.requireBounded(now, end);
      this.sample(method, stretch, now, end);
      method.accept();
      const factor = factorOf(pace, believed(pace, error, tried, before), lastError);
      step = tried * (isRejected ? Math.min(factor, 1) : factor);
      if (stoodStill) step = Math.min(step, (stretch.until - stretch.from) / LOOKS);
      lastError = Math.max(error, 1e-4);
      before = { step: tried, error };
      isRejected = false;
      time = now;
      const isEnough = leave(method);
      if (hasMoved) {
        method.begin(now, end);
        this.watch?.startAt(now, end);
      }
      if (arrives || isEnough) {
        state.set(end);
        return arrives ? null : { time, step };
      }
      if (time + step <= time) this.tooSmall(stretch, time, end, "");
    }
  }

  // Takes the current step anew, so that it ends where a guard passes zero.
  endAt(method, stretch, from, until, passing, state) {
    const { watch } = this;
    if (passing <= from) {
      state.set(watch.start);
      watch.happens(from, passing, state);
      return { event: true };
    }
    const reach = watch.passesKink() ? approach : correct;
    const time = reach(method, watch, from, until, passing);
    if (time === null) return {};
    this.work.steps++;
    const end = state.slice();
    this.putBack(method, stretch, time, end);
    this.sample(method, stretch, time, end);
    state.set(end);
    watch.happens(time, passing, state);
    const behind = watch.cross(stretch, state);
    return behind === null ? { event: true } : { behind };
  }

  // Takes the end of the current step and puts it back onto the constraints; whether that is a
  // move that the next step should start with.
  putBack(method, stretch, time, end) {
    const NOTICED = 1e-3;
    end.set(method.end);
    if (!this.constraints) return false;
    this.constraints.project(stretch.within(time), end);
    return end.some((value, index) => {
      const allowed = stretch.atol[index] + stretch.rtol * Math.abs(method.end[index]);
      return Math.abs(value - method.end[index]) > NOTICED * allowed;
    });
  }

  isDue(now) {
    return this.taken < this.points && this.times[this.taken] < now;
  }

  // What is wanted until the end of the current step, all of it on the constraints.
  sample(method, stretch, now, end) {
    while (this.isDue(now)) {
      const time = this.times[this.taken];
      method.interpolate(time, this.scratch);
      this.constraints?.project(stretch.within(time), this.scratch);
      this.push(this.scratch);
    }
    this.sampleUntil(now, end);
  }

  sampleUntil(now, state) {
    while (this.taken < this.points && this.times[this.taken] <= now) this.push(state);
  }

  push(state) {
    this.machine.outputs(this.times[this.taken], state, this.row);
    for (let index = 0; index < this.row.length; index++) this.outputs[index][this.taken] = this.row[index];
    for (const [entry, track] of this.tracks) track[this.taken] = state[entry];
    this.taken++;
  }

  tooSmall(stretch, time, state, trouble) {
    const cause = trouble || this.chattering(stretch, time, state) || "steps become too small";
    throw new Stopped(time, cause);
  }

  // A state whose rate, near where it is, jumps through zero so that it is driven back from both
  // sides.
  chattering(stretch, time, state) {
    const rate = new Float64Array(state.length);
    const shifted = state.slice();
    const index = state.findIndex((value, entry) => {
      const allowed = stretch.atol[entry] + stretch.rtol * Math.abs(value);
      const at = (by) => {
        shifted[entry] = value + by * allowed;
        stretch.rate(time, shifted, rate);
        shifted[entry] = value;
        return rate[entry];
      };
      const isSame = (a, b) => Math.abs(a - b) <= 0.1 * Math.abs(a);
      const [above, below] = [at(100), at(-100)];
      return above < 0 && below > 0 && isSame(above, at(50)) && isSame(below, at(-50));
    });
    if (index < 0) return "";
    return `the rate of ${this.machine.nameOf(index)} drives it back from both sides of ${state[index].toPrecision(4)}: it chatters`;
  }
}

// What is left of the stretch is halved rather than cut into a step and a sliver.
function endOfStep(time, step, until) {
  const remaining = until - time;
  if (step >= 0.99 * remaining) return { now: until, tried: remaining, arrives: true };
  const now = time + (2 * step > remaining ? 0.5 * remaining : step);
  return { now, tried: now - time, arrives: false };
}

function isTooSmall(step, time) {
  return Number.isNaN(step) || step <= 10 * Number.EPSILON * Math.abs(time) || step < 1e-100;
}

// The error to choose the next step by: one that is suddenly far below what the step before
// foretells is not believed at once.
function believed(pace, error, step, before) {
  const LUCK = 1e-2;
  if (!before) return error;
  return Math.max(error, LUCK * before.error * (step / before.step) ** (1 / pace.exponent));
}

function factorOf({ exponent, memory, safety, smallest, largest }, error, lastError) {
  const wanted = safety * error ** -exponent * lastError ** memory;
  return Math.max(smallest, Math.min(largest, wanted));
}

// Steps that end where an event is, corrected by Newton's method; the time at which the last of
// them ends.
function correct(method, watch, from, until, passing) {
  const CORRECTIONS = 3;
  let time = passing;
  for (let round = 0; round <= CORRECTIONS; round++) {
    if (!(method.attempt(time - from) <= 1)) return null;
    const correction = watch.correction(time, method.end);
    if (!(Math.abs(correction) <= 1e-3 * (until - from))) break;
    const corrected = Math.min(time + correction, until);
    const isSettled = Math.abs(correction) <= 4 * Number.EPSILON * Math.abs(time) || corrected <= from;
    if (isSettled || round === CORRECTIONS) break;
    time = corrected;
  }
  return time;
}

// Steps that end nearer and nearer to a kink, in front of it: a rate that jumps there spoils
// those that end beyond.
function approach(method, watch, from, until, passing) {
  const ROUNDS = 12;
  const resolved = 4 * Number.EPSILON * Math.max(Math.abs(until), until - from);
  let [front, beyond, foretold, time] = [from, until, null, passing];
  const isBetween = (next) => next !== null && front < next && next < beyond;
  for (let round = 0; round < ROUNDS; round++) {
    const isGood = method.attempt(time - from) <= 1;
    const [distance, correction] = watch.beforeKink(time, method.end);
    if (isGood && (Math.abs(correction) <= resolved || Math.abs(distance) <= watch.rounding())) return time;
    const next = Number.isFinite(correction) ? time + correction : null;
    if (isGood && distance > 0) [front, foretold] = [time, next];
    else beyond = time;
    if (isGood && isBetween(next)) time = next;
    else time = isBetween(foretold) ? foretold : 0.5 * (front + beyond);
    if (beyond - front <= resolved) break;
  }
  return front > from && method.attempt(front - from) <= 1 ? front : null;
}
