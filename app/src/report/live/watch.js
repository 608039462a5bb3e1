// Watches guards while a method steps, and applies events and changes of branches where one passes
// zero. The rules are those of the engine, see its `watch.rs`.

// Number of events within this share of the run that count as endless (Zeno).
const ENDLESS = 50;
const NO_TIME = 1e-10;
const KINDS = { branch: ["branch", "fromBelow", "fromAbove"], whole: ["low", "high", "fromBelow", "fromAbove"], zone: ["zone", "nearest"] };
const WAYS = { rising: 1, falling: -1, both: 0 };

class Watch {
  constructor(system, span) {
    const { machine } = system;
    const { events, relations, kinks } = machine.known;
    Object.assign(this, { system, machine, span, events, latest: [], switches: [], now: [], longest: Infinity, entered: system.ends[0] });
    this.list = [
      ...events.map((_, of) => ({ kind: "event", of })),
      ...relations.flatMap(({ kind }, of) => KINDS[kind].map((own) => ({ kind: own, of }))),
      ...range(kinks).slice(relations.length).map((of) => ({ kind: "border", of })),
    ];
    this.place = relations.map((_, of) => this.list.findIndex((it) => it.kind !== "event" && it.of === of));
    this.ways = this.list.map(({ kind, of }) => (kind === "event" ? WAYS[events[of].direction] : kind === "nearest" ? -1 : 0));
    this.hasZones = this.list.some(({ kind }) => kind === "zone");
    // The side of each, zero if it is not watched, and where it was zero but for rounding.
    this.sides = this.list.map(() => 0);
    this.zeros = this.list.map(() => null);
    this.relations = new Relations(system);
    this.looks = new Looks((time, state) => this.values(time, state), this.list.length);
    let first = 0;
    this.firstSet = events.map(({ sets }) => (first += sets.length) - sets.length);
    this.sets = first;
    this.most = 2 * events.length + 8;
    this.counters = range(events.length).filter((index) => events[index].counts);
    this.counts = { before: new Map(), within: [] };
  }

  values(time, state) {
    const { system, machine, list } = this;
    const at = system.within(time);
    const values = new Float64Array(list.length);
    if (this.events.length) {
      const guards = machine.call("guards", at, state);
      for (let index = 0; index < this.events.length; index++) values[index] = guards[index];
    }
    if (!machine.known.kinks) return values;
    const kinks = machine.call("kink_guards", at, state);
    for (let index = this.events.length; index < values.length; index++) {
      const { kind, of } = list[index];
      if (kind === "low") values[index] = kinks[of] - machine.slots[of];
      else if (kind === "high") values[index] = 1 + machine.slots[of] - kinks[of];
      else values[index] = kinks[of];
    }
    if (this.hasZones) {
      const rates = machine.call("kink_rates", at, state);
      list.forEach(({ kind, of }, index) => { if (kind === "nearest") values[index] = rates[of]; });
    }
    if (system.slides.length) {
      const { alphas } = system.combination(at, state);
      const alpha = (of) => alphas[system.slides.findIndex(({ relation }) => relation === of)] ?? 0.5;
      list.forEach(({ kind, of }, index) => {
        if (kind === "fromBelow") values[index] = alpha(of);
        if (kind === "fromAbove") values[index] = 1 - alpha(of);
      });
    }
    return values;
  }

  // Rates of guards along the motion; none of shares.
  rates(time, state) {
    const at = this.system.within(time);
    const guards = this.system.blended("guard_rates", at, state, this.events.length);
    const kinks = this.system.blended("kink_rates", at, state, this.machine.known.kinks);
    const sign = { event: 1, branch: 1, low: 1, border: 1, zone: 1, high: -1 };
    return this.list.map(({ kind, of }) => (kind === "event" ? guards[of] : (sign[kind] ?? NaN) * kinks[of]));
  }

  isEvent(index) {
    return index < this.events.length;
  }

  isArmed(index, state) {
    return this.events[index].when.every(([entry, value]) => Math.abs(state[entry] - value) < 0.5);
  }

  isBeyond(index, value) {
    return this.ways[index] * value > 0;
  }

  // The change of the relation whose guard passes zero.
  changeAt(index) {
    const { kind, of: relation } = this.list[index];
    const slot = this.machine.slots[relation];
    const change = (below, isUp, leaves = false) =>
      ({ relation, below, leaves, slot: isUp ? aboveSlot(below) : below });
    switch (kind) {
      case "branch": return change(BELOW, slot < 0);
      case "low": return change(slot - 1, false);
      case "high": return change(slot, true);
      // Along a surface the slot below it is held.
      case "fromBelow": return change(slot, false, true);
      case "fromAbove": return change(slot, true, true);
      default: return null;
    }
  }

  leaveSurfaces(before, time, state, passed) {
    this.relations.leaveSurfaces(before, time, state, (relation) => this.looks.rounding(this.place[relation]), passed);
  }

  settleRelations(time, state, changes) {
    const armed = this.events.map((_, index) => this.isArmed(index, state));
    this.relations.settle(time, state, armed, changes, (relation, guard) => {
      const zero = this.zeros[this.place[relation]];
      return zero !== null && Math.abs(guard) <= Math.abs(zero.residual);
    });
  }

  // Starts a segment of a run: the sides of all guards. Events of `passed` just happened; guards of
  // `crossed` passed zero, and all others are looked at anew where they changed.
  begin(time, state, { passed = [], crossed = [], before = null } = {}) {
    const { sides } = this;
    const [values, rates] = [this.values(time, state), this.rates(time, state)];
    this.counts = { before: new Map(), within: [] };
    [this.time, this.start, this.now] = [time, state.slice(), []];
    this.listen(time, state, values);
    this.list.forEach(({ kind, of }, index) => {
      const [value, rate, hasCrossed] = [values[index], rates[index], crossed.includes(index)];
      if (kind === "event") {
        const isSame = sides[index] && before?.[index] === value && !passed.includes(index);
        if (!isSame || value === 0 || !this.isArmed(index, state)) this.take(index, time, state, value, rate, passed.includes(index));
        return;
      }
      const [isActive, isSliding] = [this.relations.active[of], this.relations.isSliding(of)];
      let side = Number(kind === "fromBelow" || kind === "fromAbove" ? isSliding : isActive && !isSliding);
      if (kind === "branch") side *= Math.sign(this.machine.slots[of]);
      if (kind === "border" || kind === "zone") side = sides[index] ? sides[index] * (hasCrossed ? -1 : 1) : value < 0 ? -1 : 1;
      if (kind === "zone" && hasCrossed) [this.longest, this.entered] = [Infinity, time];
      if (kind === "nearest") side = Number(sides[index - 1] > 0 && value > 0 && !hasCrossed);
      sides[index] = side;
      const isZero = kind !== "nearest" && side && (side * value <= 0 || (hasCrossed && Math.abs(value) < 0.5));
      this.zeros[index] = isZero ? { time, residual: value, rate } : null;
    });
  }

  // Rounding of guards by that of the states that they compare, now and then.
  listen(time, state, values) {
    const [EVERY, CHANGE] = [32, 1e-7];
    this.age = (this.age ?? 0) + 1;
    if (this.age % EVERY !== 1) return;
    const noise = this.list.map(() => 0);
    state.forEach((value, entry) => {
      const size = Math.max(Math.abs(value), this.machine.isMode[entry] ? 0 : this.machine.scales[entry]);
      const shifted = state.slice();
      shifted[entry] += CHANGE * size;
      if (size > 0) this.values(time, shifted).forEach((other, index) => {
        const change = Math.abs(other - values[index]) / CHANGE;
        if (Number.isFinite(change)) noise[index] += this.isEvent(index) ? change : change * (Math.abs(value) / size);
      });
    });
    this.looks.noise = noise;
  }

  // The side of the guard of an event: of one that is zero, the side to which it leaves. One that
  // leaves beyond zero happens, unless it just passed.
  take(index, time, state, value, rate, hasPassed) {
    this.sides[index] = 0;
    this.zeros[index] = null;
    if (!this.isArmed(index, state)) return;
    const byTime = ROUNDINGS * EPSILON * Math.abs(time * rate);
    let zero = Math.max(this.looks.rounding(index), byTime) * (hasPassed ? 4 : 1);
    if (!hasPassed && this.isBeyond(index, value)) zero = Math.max(zero, this.blur(index, time, state));
    if (Math.abs(value) > zero) {
      this.sides[index] = Math.sign(value);
      return;
    }
    const along = this.system.rates(time, state);
    const bend = this.system.bend(index, time, state, along, "guard_rates", this.events.length);
    const isAtOnce = Math.abs(rate) * this.span > this.rest(index) && Math.abs(rate) > 4 * EPSILON * Math.abs(time * bend);
    const isSeen = isAtOnce || Math.abs(bend) * this.span ** 2 > this.rest(index);
    const side = isSeen ? Math.sign(isAtOnce ? rate : bend) : 0;
    this.sides[index] = side;
    this.zeros[index] = side ? { time, residual: value, rate } : null;
    if (this.isBeyond(index, side) && !(hasPassed && isAtOnce)) this.now.push(index);
  }

  // The first time within the current step at which a watched function passes zero, or null.
  firstPassing(method, until) {
    const { looks } = this;
    looks.begin(method, [this.time, this.start], [until, method.end]);
    let limit = until;
    this.outcomes = [];
    // Borders come last: others are looked at up to the first one.
    for (let index = this.list.length - 1; index >= 0; index--) {
      const outcome = this.counters.includes(index) ? { side: this.sides[index] } : this.outcome(index, limit);
      if (this.list[index].kind === "border" || this.list[index].kind === "zone") limit = Math.min(limit, outcome.time ?? limit);
      this.outcomes[index] = outcome;
    }
    const times = this.outcomes.map(({ time }) => time ?? Infinity);
    const first = Math.min(...times);
    this.first = times.indexOf(first);
    return first < Infinity ? first : null;
  }

  outcome(index, limit) {
    let [side, zero, from] = [this.sides[index], this.zeros[index], this.time];
    while (side) {
      const time = this.looks.first({ index, side, zero }, from, limit);
      if (time === null) break;
      if (this.ways[index] * side <= 0) return { time, from: side };
      side = -side;
      if (time <= zero?.time || time >= limit) break;
      [from, zero] = [time, this.zeroAt(time, index)];
    }
    return { side };
  }

  zeroAt(time, index) {
    const { looks } = this;
    looks.method.interpolate(time, looks.state);
    const [residual, rate] = [this.values(time, looks.state)[index], this.rates(time, looks.state)[index]];
    return { time, residual, rate };
  }

  // Tells if a step is too long for a zone, once it shows where the motion is nearest.
  isTooLong(tried) {
    if (this.list[this.first].kind !== "nearest" || this.longest < Infinity) return false;
    this.longest = (this.outcomes[this.first].time - this.entered) / 16;
    return tried > this.longest;
  }

  // The first function that passes zero, at the end of a step, and its correction by Newton's method.
  crossing(time, end) {
    const { from } = this.outcomes[this.first];
    const guard = this.values(time, end)[this.first] - (this.zeros[this.first]?.residual ?? 0);
    const rate = this.rates(time, end)[this.first];
    const isBorder = this.list[this.first].kind === "border" || this.list[this.first].kind === "zone";
    // It moves the other way there: an error of the step, which a shorter one does not make.
    const isOfError = this.zeros[this.first] !== null && this.first >= 0 && this.list[this.first].kind !== "low" && from * rate > 0;
    return { correction: isBorder ? NaN : -guard / rate, isOfError };
  }

  // Ends an accepted step at which nothing passed zero.
  pass(until, end) {
    this.outcomes.forEach(({ side }, index) => { this.sides[index] = side; });
    [this.time, this.start] = [until, end.slice()];
    // Guards that were zero, with all derivatives, until now.
    const unseen = range(this.events.length).filter((index) => !this.sides[index] && this.isArmed(index, end));
    const values = unseen.length ? this.values(until, end) : [];
    for (const index of unseen.filter((index) => Math.abs(values[index]) > this.rest(index))) {
      this.sides[index] = Math.sign(values[index]);
      if (this.isBeyond(index, values[index])) this.now.push(index);
    }
  }

  // Greatest change of a guard at rest.
  rest(index) {
    return Math.max(1e-9 * this.looks.sizes[index], this.looks.rounding(index));
  }

  // Marks guards that pass zero at a time that a step reached, and all that did so before.
  happening(time, state) {
    const near = ROUNDINGS * EPSILON * Math.max(Math.abs(time), Math.abs(this.time));
    const { time: first } = this.outcomes[this.first];
    const values = this.values(time, state);
    return range(this.list.length).filter((index) => {
      const { time: passing, from } = this.outcomes[index];
      const value = values[index] - (this.zeros[index]?.residual ?? 0);
      // It passed before, against the direction of its event, and would pass back later.
      const isBack = from !== this.sides[index];
      if (passing !== undefined && (passing <= first + near || (!isBack && value * from < 0))) return true;
      if (this.isEvent(index) && this.sides[index] && Math.abs(value) > this.looks.rounding(index)
        && (isBack || !this.isBeyond(index, value))) this.sides[index] = Math.sign(value);
      return false;
    });
  }

  // Applies what happens, events in the order of the spec and each only if it is still armed;
  // whether there were any.
  switch(time, state, happening) {
    const before = this.values(time, state);
    const rateOf = (index) => this.rates(time, state)[index];
    const isApproached = (index) => this.isBeyond(index, rateOf(index));
    const passed = [];
    const left = [];
    const turned = [];
    const crossed = happening.filter((index) => !this.isEvent(index));
    this.change(time, state, crossed);
    const events = [...happening.filter((index) => this.isEvent(index)), ...this.jumped(time, state, before, happening)];
    for (const index of events.sort((a, b) => a - b)) {
      if (!this.isArmed(index, state)) continue;
      const surfaces = this.relations.surfaces(time, state);
      this.apply(index, time, state);
      this.leaveSurfaces(surfaces, time, state);
      this.settleRelations(time, state);
      this.count(index, time);
      (this.isArmed(index, state) ? passed : left).push(index);
      if (!isApproached(index)) turned.push(index);
    }
    this.reopenFrictions(time, state);
    // The events moved guards that are beyond zero only now.
    const isAsked = (index) => !this.sides[index]
      || (!this.isBeyond(index, before[index]) && !passed.includes(index) && !left.includes(index));
    const asked = range(this.events.length).filter(isAsked);
    left.push(...this.settle(time, state, asked, false));
    this.settleRelations(time, state);
    // One that others move towards zero happens again, as a ball does that is hit from both sides.
    const again = turned.filter(isApproached);
    const isOn = (index) => passed.includes(index) && !left.includes(index) && !again.includes(index);
    left.forEach((index) => { this.sides[index] = 0; });
    this.begin(time, state, { passed: passed.filter(isOn), crossed, before });
    return passed.length + left.length > 0;
  }

  // Changes relations whose guards pass zero.
  change(time, state, crossed) {
    const changes = crossed.map((index) => this.changeAt(index)).filter(Boolean);
    this.settleRelations(time, state, changes);
    if (this.system.slides.length) this.system.project(time, state);
    changes.forEach(() => this.countOne(time, "a comparison"));
  }

  // Events whose guards passed zero because relations changed.
  jumped(time, state, before, happening) {
    const after = this.values(time, state);
    return range(this.events.length).filter((index) => {
      const side = this.sides[index];
      const hasJumped = side * after[index] < -this.looks.rounding(index) && after[index] !== before[index];
      if (!hasJumped || happening.includes(index)) return false;
      if (this.ways[index] * side <= 0) return true;
      this.sides[index] = -side;
      return false;
    });
  }

  // Corrects modes that contradict guards: an event that ends its own mode, and is beyond zero,
  // happens. At a start it may change modes alone. Returns those that happened.
  settle(time, state, asked, isStart) {
    const happened = [];
    const isContrary = (index) => {
      const { when, sets } = this.events[index];
      if (!when.some(([entry]) => sets.includes(entry)) || !this.isArmed(index, state)) return false;
      const value = this.values(time, state)[index];
      const blur = this.blur(index, time, state, isStart ? EPSILON / this.system.rtol : 1);
      return this.isBeyond(index, value) && Math.abs(value) > Math.max(blur, ROUNDINGS * EPSILON * Math.abs(time * this.rates(time, state)[index]));
    };
    for (;;) {
      const index = asked.find((index) => isContrary(index) && this.isEnded(index, time, state, isStart));
      if (index === undefined) return happened;
      if (happened.length === this.most) throw new Stopped(time, `event ${this.events[index].name} contradicts others`);
      const surfaces = this.relations.surfaces(time, state);
      this.apply(index, time, state);
      this.leaveSurfaces(surfaces, time, state);
      this.settleRelations(time, state);
      this.count(index, time);
      happened.push(index);
      this.system.constraints?.rest(time, state);
    }
  }

  // Lets frictions that stick begin anew if the motion of the rest leaves them behind, as where a
  // prescribed speed jumps: their forces are finite.
  reopenFrictions(time, state) {
    const [STUCK, OPEN] = [0, 2];
    const { constraints, rtol } = this.system;
    const rows = range(constraints?.m ?? 0).filter((row) => state[constraints.friction(row)] === STUCK);
    if (!rows.length) return;
    const [there, speeds] = [state.slice(), constraints.levels[1]];
    rows.forEach((row) => { there[constraints.friction(row)] = OPEN; });
    constraints.project(time, there, [speeds]);
    rows.forEach((row) => {
      there[constraints.friction(row)] = STUCK;
      if (constraints.off(speeds, time, there).off[row] > rtol) state[constraints.friction(row)] = OPEN;
      there[constraints.friction(row)] = OPEN;
    });
  }

  // Tells if an event would leave its mode.
  isEnded(index, time, state, isStart) {
    const after = state.slice();
    this.apply(index, time, after);
    const hasMoved = (value, entry) => !this.machine.isMode[entry] && Math.abs(value - state[entry]) > this.allowed(entry, state);
    if (isStart && after.some(hasMoved)) throw new Stopped(time, `the start contradicts event ${this.events[index].name}`);
    return !this.isArmed(index, after);
  }

  allowed(entry, state) {
    return this.system.atol[entry] + this.system.rtol * Math.abs(state[entry]);
  }

  // The change of a guard within a share of the tolerances of states.
  blur(index, time, state, share = 1) {
    const value = this.values(time, state)[index];
    return range(state.length).filter((entry) => !this.machine.isMode[entry]).reduce((sum, entry) => {
      const shifted = state.slice();
      shifted[entry] += share * this.allowed(entry, state);
      return sum + Math.abs(this.values(time, shifted)[index] - value);
    }, 0);
  }

  apply(index, time, state) {
    const values = this.machine.live("resets", time, state, this.sets);
    this.events[index].sets.forEach((entry, k) => {
      const value = values[this.firstSet[index] + k];
      if (!Number.isFinite(value)) {
        throw new Stopped(time, `the new value of ${this.machine.name(entry)} at event ${this.events[index].name} is no finite number`);
      }
      state[entry] = this.machine.isMode[entry] ? Math.round(value) : value;
    });
  }

  count(index, time) {
    this.machine.work.switches++;
    this.switches.push({ time, event: this.events[index].name });
    this.countOne(time, `event ${this.events[index].name}`);
  }

  countOne(time, what) {
    const most = Math.max(ENDLESS, this.most + 2 * this.relations.all.length);
    this.latest.push(time);
    if (this.latest.length <= most) return;
    if (time - this.latest.shift() <= NO_TIME * Math.max(this.span, Math.abs(time))) {
      throw new Stopped(time, `${what} happens without end, ${most} times in no time`);
    }
  }

  // Applies events that only count, at all their times within an accepted step up to `until`: they
  // end no step, and steps go on with the old values.
  tally(method, until) {
    if (!this.counters.length) return;
    const { before, within } = this.counts;
    within.splice(0).forEach(([, entry, value]) => before.set(entry, value));
    const latest = new Map(before);
    const times = this.counters.flatMap((index) => this.passings(index, until).map((time) => [time, index]));
    const { state } = this.looks;
    for (const [time, index] of times.sort((a, b) => a[0] - b[0] || a[1] - b[1])) {
      method.interpolate(time, state);
      latest.forEach((value, entry) => { state[entry] = value; });
      this.apply(index, time, state);
      for (const entry of this.events[index].sets) {
        within.push([time, entry, state[entry]]);
        latest.set(entry, state[entry]);
      }
      this.machine.work.switches++;
      this.switches.push({ time, event: this.events[index].name });
    }
  }

  // All times within the step at which a counter passes zero; its side is that at the end.
  passings(index, until) {
    const { looks } = this;
    const found = [];
    let [side, zero, from] = [this.sides[index], this.zeros[index], this.time];
    this.spans ??= [];
    let span = Math.min(this.spans[index] ?? Infinity, until - from);
    while (side && from < until) {
      looks.samples = new Map();
      const to = from + span < until ? from + span : until;
      const pieces = { left: 1000 };
      const time = looks.first({ index, side, zero }, from, to, pieces);
      if (pieces.left <= 0 && middleOf(from, 0.5 * (from + to)) !== null) {
        span = 0.5 * (to - from);
      } else if (time === null || time <= (zero?.time ?? -Infinity)) {
        span *= to < until ? 1.25 : 1;
        from = to;
      } else {
        if (this.ways[index] * side <= 0) found.push(time);
        span = middleOf(from, time) === null ? span : time - from;
        [from, zero, side] = [time, this.zeroAt(time, index), -side];
      }
    }
    [this.spans[index], this.sides[index], this.zeros[index], this.outcomes[index]] = [span, side, zero, { side }];
    return found;
  }

  // Enters counts at a time within the current step into a state.
  enter(time, state) {
    this.counts.before.forEach((value, entry) => { state[entry] = value; });
    for (const [at, entry, value] of this.counts.within) if (at <= time) state[entry] = value;
  }
}
