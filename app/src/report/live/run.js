// A run of the machine: cut at jumps in time, stepped by a method with control of the error, ended
// at events and changes of branches, sampled from the method's dense output. A generator, so that
// the page stays alive: it yields after every step.

// Steps that speak for stiffness before the method changes, and against it before they are void.
const STIFF_STEPS = 15;
const EASY_STEPS = 6;

class Run {
  // `run` holds parameters, both ends and the number of output times, equally spaced unless given.
  constructor(machine, { parameters, from, until, points, times }) {
    const { known } = machine;
    machine.begin(parameters);
    Object.assign(this, { machine, parameters, from, until, taken: 0, stopped: null, work: machine.work, used: new Set() });
    const at = (k) => (k === points - 1 ? until : from + (until - from) * (k / (points - 1)));
    this.times = Float64Array.from(times ?? range(points).map(at));
    this.outputs = known.outputs.map(() => new Float64Array(this.times.length));
    this.tracks = new Map(known.tracked.map((entry) => [entry, new Float64Array(this.times.length)]));
    this.system = new System(machine, from, until);
    this.isStiff = known.run.is_stiff;
    this.watch = known.events.length + known.kinks > 0 ? new Watch(this.system, until - from) : null;
  }

  column(name) {
    return this.outputs[this.machine.known.outputs.indexOf(name)];
  }

  // Names of the methods that took steps.
  methods() {
    return [...this.used].join(" and ");
  }

  get switches() {
    return this.watch?.switches ?? [];
  }

  // Runs to the end, or to where it stops, which is told in `stopped`.
  *steps() {
    try {
      const state = this.start();
      this.sampleUntil(this.from, state);
      const jumps = [...this.machine.live("discontinuities", 0, state, this.machine.known.discontinuities)];
      if (!jumps.every(Number.isFinite)) throw new Stopped(this.from, "the time of a jump is no finite number");
      const isWithin = (time) => this.from < time && time < this.until;
      const ends = [this.from, ...new Set(jumps.filter(isWithin).sort((a, b) => a - b)), this.until];
      for (let k = 1; k < ends.length; k++) yield* this.stretch(ends[k - 1], ends[k], state);
    } catch (error) {
      if (!(error instanceof Stopped)) throw error;
      this.stopped = error;
    }
  }

  // The state at the start, on the constraints, in modes that fit to it.
  start() {
    const { machine, system, watch, from } = this;
    const { run, equilibrium } = machine.known;
    const state = machine.values("initial_state", 0, new Float64Array(machine.size), machine.size);
    if (equilibrium) equilibrium.state.forEach((value, entry) => { state[entry] += value - equilibrium.guess[entry]; });
    system.require(from, state, "the initial value of");
    system.constraints?.start(from, state);
    if (equilibrium) balance(system, from, state);
    // Steps of `auto` are no looser where they may be many.
    if (run.method === "auto") system.rtol = Math.min(run.rtol, 1e-5);
    system.atol = this.scales(state).map((scale) => system.rtol * scale);
    for (let round = 0, before = null; watch && before?.join() !== state.join(); round++) {
      if (round > 20) throw new Stopped(from, "the modes of the start change without end");
      before = state.slice();
      watch.settleRelations(from, state);
      watch.settle(from, state, range(watch.events.length), true);
      if (equilibrium) balance(system, from, state);
    }
    system.project(from, state);
    return state;
  }

  // Scales of states for absolute tolerances: those of the spec; of first-order states without one,
  // by what they do to others at the start (balancing of the Jacobian).
  scales(state) {
    const { known } = this.machine;
    const scales = [...this.machine.scales];
    const isOpen = known.states.map((it) => it.kind === "first order" && it.scale === 1);
    range(scales.length).filter((by) => isOpen.includes(true) && !isOpen[by] && known.states[by].kind !== "mode").forEach((by) => {
      const changes = this.system.difference(this.from, state, by);
      range(scales.length).filter((on) => isOpen[on] && changes[on] !== 0).forEach((on) => {
        const back = this.system.difference(this.from, state, on)[by];
        const balanced = known.states[by].scale * Math.sqrt(Math.abs(changes[on] / back));
        if (balanced > 0 && balanced < scales[on]) scales[on] = balanced;
      });
    });
    return scales;
  }

  // Carries `state` over a stretch without jumps in time.
  *stretch(from, until, state) {
    const { system, watch, work } = this;
    const { explicit, implicit } = this.machine.known.methods;
    system.ends = [from, until];
    const near = 8 * EPSILON * Math.max(Math.abs(from), until - from);
    if (watch && from > this.from) {
      watch.leaveSurfaces(watch.relations.surfaces(from - near, state), from, state, near);
      watch.settleRelations(from, state);
    }
    const before = state.slice();
    if (watch && from > this.from) this.requireSame(from, this.inertia(from - near, state), this.inertia(from + near, state));
    if (watch && from > this.from) {
      watch.reopenFrictions(from, state);
      watch.settle(from, state, range(watch.events.length).filter((index) => !watch.sides[index]), false);
    }
    system.project(system.within(from), state);
    let [time, step, method, isStiff, last, isRejected] = [from, 0, null, null, null, false];
    const restart = (next) => {
      system.ends[0] = time;
      system.require(time, system.rates(time, state), "the rate of");
      if (isStiff !== this.isStiff) {
        isStiff = this.isStiff;
        method = isStiff ? new RosenbrockSteps(system, implicit) : new ExplicitSteps(system, explicit);
        this.used.add(method.name);
      }
      method.begin(time, state);
      step = next ?? method.firstStep();
      [last, isRejected] = [null, false];
    };
    watch?.begin(time, state, { before: this.from < from ? watch.values(time, before) : null });
    restart();
    for (let [found, missed] = [0, 0]; time < until;) {
      yield;
      if (until - time <= 512 * EPSILON * Math.max(Math.abs(time), Math.abs(until))) {
        system.rates(time, state).forEach((rate, k) => { state[k] += (until - time) * rate; });
        break;
      }
      if (watch?.now.length) {
        this.happen(time, state, watch.now);
        restart();
        continue;
      }
      const rest = until - time;
      const limited = Math.min(step, watch?.longest ?? Infinity);
      // The rest is halved rather than cut into a step and a sliver.
      const tried = limited >= 0.99 * rest ? rest : 2 * limited > rest ? rest / 2 : limited;
      const now = tried === rest ? until : time + tried;
      let error = method.attempt(tried);
      if (error <= 1) error = Math.max(error, method.errorBetween());
      let next = tried * Math.max(0.2, Math.min(0.9, 0.9 * error ** -method.exponent || 0));
      const passing = error <= 1 && watch ? watch.firstPassing(method, now) : null;
      if (passing !== null && watch.isTooLong(tried)) continue;
      if (passing !== null) {
        const reached = this.reach(method, time, now, passing);
        if (reached !== null) {
          const end = reached > time ? method.end.slice() : state;
          if (reached > time) watch.tally(method, reached);
          system.project(system.within(reached), end);
          this.sample(method, reached, end);
          watch.enter(reached, end);
          time = reached;
          state.set(end);
          work.steps++;
          restart(this.happen(time, state, watch.happening(time, state)) ? undefined : tried);
          continue;
        }
        [error, next] = [Infinity, Math.min(0.5 * (passing - time), 0.5 * tried) || 0.5 * tried];
      }
      if (!(error <= 1)) {
        work.rejected++;
        [step, isRejected] = [next, true];
        if (!(step > 10 * EPSILON * Math.abs(time) && step > 1e-100)) this.fail(time, state);
        continue;
      }
      work.steps++;
      const isAtRest = method.end.every((value, k) => Math.abs(value - method.start[k]) <= 1e-3 * system.atol[k]);
      watch?.tally(method, now);
      const end = method.end.slice();
      system.project(system.within(now), end);
      system.require(now, end, "the state");
      this.sample(method, now, end);
      // One that is suddenly far below what the step before foretells is not believed at once.
      const told = last ? Math.max(error, 1e-2 * last.error * (tried / last.tried) ** (1 / method.exponent)) : error;
      step = tried * Math.min(isRejected ? 1 : 8, Math.max(0.2, 0.9 * told ** -method.exponent));
      if (isAtRest) step = Math.min(step, (until - from) / 100);
      [last, isRejected, time] = [{ error, tried }, false, now];
      watch?.pass(now, end);
      method.accept();
      if (system.constraints || system.slides.length) method.begin(now, end);
      state.set(end);
      if (this.isStiff || !implicit || this.machine.known.run.stays_explicit) continue;
      const isHeld = method.stiffness() > explicit.stability;
      [found, missed] = [found + Number(isHeld), isHeld ? 0 : missed + 1];
      if (missed === EASY_STEPS) found = 0;
      this.isStiff = found >= STIFF_STEPS;
      if (this.isStiff) restart(tried);
    }
    watch?.enter(until, state);
    this.sampleUntil(until, state);
  }

  // Takes the current step anew, so that it ends where a guard passes zero, corrected by Newton's
  // method; null if that cannot be.
  reach(method, from, until, passing) {
    const { watch } = this;
    if (passing - from <= 4 * EPSILON * Math.abs(passing)) return from;
    let time = passing;
    for (let round = 0; round <= 3; round++) {
      if (!(method.attempt(time - from) <= 1)) return null;
      const { correction, isOfError } = watch.crossing(time, method.end);
      if (isOfError) return null;
      const next = Math.min(time + correction, until);
      if (!(Math.abs(correction) <= 1e-3 * (until - from)) || next <= from || round === 3) break;
      if (Math.abs(correction) <= 4 * EPSILON * Math.abs(time)) break;
      time = next;
    }
    return time;
  }

  // Applies what happens at a time; whether there were events.
  happen(time, state, happening) {
    const { machine, system, watch } = this;
    const before = state.slice();
    const inertia = this.inertia(time, before);
    const hasEvents = watch.switch(time, state, happening);
    state.forEach((value, k) => { if (machine.isMode[k]) before[k] = value; });
    this.requireSame(time, inertia, this.inertia(time, before));
    system.project(time, state);
    return hasEvents;
  }

  inertia(time, state) {
    const { machine } = this;
    return machine.values("mass_matrix", time, state, machine.known.mass_matrix.entries.length);
  }

  // Velocities jump where the inertia does, which the engine computes and the page does not.
  requireSame(time, before, after) {
    const change = largest(after.map((value, index) => value - before[index]));
    if (change > 1e-9 * largest(before)) throw new Stopped(time, "an inertia jumps, which only the program can run");
  }

  fail(time, state) {
    this.system.require(time, this.system.rates(time, state), "the rate of");
    throw new Stopped(time, "steps become too small");
  }

  // Samples until the end of the current step, on the constraints.
  sample(method, now, end) {
    const state = this.machine.state.slice();
    while (this.taken < this.times.length && this.times[this.taken] < now) {
      const time = this.times[this.taken];
      method.interpolate(time, state);
      this.system.constraints?.project(this.system.within(time), state);
      this.watch?.enter(time, state);
      this.push(state);
    }
    if (this.times[this.taken] === now) {
      state.set(end);
      this.watch?.enter(now, state);
      this.sampleUntil(now, state);
    }
  }

  sampleUntil(now, state) {
    while (this.taken < this.times.length && this.times[this.taken] <= now) this.push(state);
  }

  push(state) {
    this.machine.outputs(this.times[this.taken], state).forEach((value, index) => { this.outputs[index][this.taken] = value; });
    for (const [entry, track] of this.tracks) track[this.taken] = state[entry];
    this.taken++;
  }
}
