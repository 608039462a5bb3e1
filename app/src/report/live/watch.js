// Watches guards while a method steps, and does what events say where one passes zero. As the
// engine does it, see its `watch.rs`.

// So many events within this share of the run are taken for endless ones.
const ENDLESS = 50;
const NO_TIME = 1e-10;
// Behind a kink within this share of the time reached, or of the stretch, or not at all.
const BEHIND = 1e-12;

class Watch {
  constructor(run) {
    const { machine } = run;
    Object.assign(this, { run, machine, happening: null, latest: [], switches: [] });
    this.known = machine.known.events;
    this.count = machine.events + machine.kinks;
    this.sides = Array(this.count).fill(IDLE);
    this.parts = new Parts(machine);
    this.start = new Float64Array(machine.size);
    this.time = run.from;
    this.outcomes = [];
    let first = 0;
    this.firstReset = this.known.map((event) => (first += event.sets.length) - event.sets.length);
    this.resets = new Float64Array(first);
    // So many events may follow on one another without time.
    this.most = 2 * machine.events + 8;
  }

  isKink(index) {
    return index >= this.machine.events;
  }

  direction(index) {
    return this.isKink(index) ? "both" : this.known[index].direction;
  }

  // Modes are whole numbers, and stay so but for rounding.
  isArmed(index, state) {
    return this.isKink(index) || this.known[index].when.every(([entry, value]) => Math.abs(state[entry] - value) < 0.5);
  }

  guards(time, state) {
    const guards = new Float64Array(this.count);
    this.machine.guards(time, state, guards);
    return guards;
  }

  startAt(time, state) {
    this.time = time;
    this.start.set(state);
  }

  // The first time at which a guard passes zero within the current step, which ends at `until`;
  // if none does, the step's end is the start of the next one.
  firstPassing(method, stretch, until) {
    this.parts.fill(method, stretch, this.time, until, this.start, this.sides);
    this.outcomes = this.sides.map((side, index) => this.parts.outcome(index, this.direction(index), side));
    const first = this.first();
    if (first !== null) return this.outcomes[first].time;
    this.outcomes.forEach((outcome, index) => { this.sides[index] = outcome.stays; });
    this.startAt(until, method.end);
    return null;
  }

  // The guard that passes first.
  first() {
    let first = null;
    this.outcomes.forEach((outcome, index) => {
      if (!outcome.stays && (first === null || outcome.time < this.outcomes[first].time)) first = index;
    });
    return first;
  }

  passesKink() {
    const first = this.first();
    return first !== null && this.isKink(first);
  }

  // How far a state is in front of the kink that is passed first, and the time until there.
  beforeKink(time, state) {
    const first = this.first();
    const [guard, rate] = this.parts.at(time, state, first);
    return [this.outcomes[first].from * guard, -guard / rate];
  }

  // By how much a passing at `time` is early.
  correction(time, end) {
    const [guard, rate] = this.parts.at(time, end, this.first());
    return -guard / rate;
  }

  // The step ends at `time` because of what was found, in state `end`.
  happens(time, first, end) {
    const near = 64 * Number.EPSILON * Math.max(Math.abs(time), Math.abs(this.time));
    const events = [];
    this.outcomes.forEach((outcome, index) => {
      const [guard] = this.parts.at(time, end, index);
      if (!outcome.stays) {
        if (outcome.time <= first + near || guard * outcome.from < 0) events.push(index);
        else this.sides[index] = known(outcome.from);
      } else if (outcome.stays.kind === "known" && Math.abs(guard) > this.parts.rounding(index) && time > this.time) {
        this.sides[index] = known(Math.sign(guard));
      }
    });
    this.happening = { time, events };
  }

  // If what happens is that kinks are passed and nothing else: puts the state behind them, and
  // gives the time.
  cross(stretch, state) {
    if (!this.happening?.events.every((index) => this.isKink(index))) return null;
    const { time, events } = this.happening;
    this.happening = null;
    return events.reduce((behind, kink) => this.putBehind(stretch, kink, behind, state), time);
  }

  putBehind(stretch, kink, time, state) {
    const { from } = this.outcomes[kink];
    if (from === undefined) return time;
    const rate = new Float64Array(state.length);
    stretch.rate(time, state, rate);
    const [here, slope] = this.parts.at(time, state, kink);
    // The state may be behind the kink already, where it is driven back.
    const way = from * slope > 0 ? -1 : 1;
    const shifted = (by) => state.map((value, index) => value + by * way * rate[index]);
    const size = Math.max(Math.abs(time), stretch.until - stretch.from);
    const distance = here === 0 ? 0 : 2 * Math.abs(here / slope);
    let by = Number.isNaN(distance) ? Infinity : Math.max(distance, 4 * Number.EPSILON * size);
    let side = by <= BEHIND * size ? fresh(true, 4 * Math.abs(here)) : known(Math.sign(here));
    // It is on both sides, and however slowly it moves: it has passed.
    if (Math.abs(here) <= this.parts.rounding(kink)) side = known(-from);
    let now = time;
    for (; by <= BEHIND * size; by *= 4) {
      const ahead = shifted(by);
      const [behind, slopeBehind] = this.parts.at(time + by, ahead, kink);
      const [before, slopeBefore] = this.parts.at(time - by, shifted(-by), kink);
      if (!(from * behind < 0 && from * before > 0)) continue;
      const isDrivenBack = from * slopeBefore < 0 && from * slopeBehind > 0;
      if (isDrivenBack) {
        const chatters = this.run.chattering(stretch, time, ahead);
        if (chatters) throw new Stopped(time, chatters);
      }
      side = known(-from);
      now = Math.min(time + by, stretch.until);
      state.set(ahead);
      break;
    }
    this.sides[kink] = side;
    return now;
  }

  // What of the guard that passes first may be rounding.
  rounding() {
    return this.parts.rounding(this.first());
  }

  // Where the method stopped for events: does what they say to `state`, each only if it is
  // still watched for. Gives the time, or nothing if there are none.
  switch(state) {
    if (!this.happening) return null;
    const { time, events } = this.happening;
    this.happening = null;
    const before = this.guards(time, state);
    const passed = Array(this.count).fill(null);
    for (const index of events) {
      if (this.isKink(index)) {
        passed[index] = GOES_ON;
      } else if (this.isArmed(index, state)) {
        this.apply(index, time, state);
        passed[index] = this.isArmed(index, state) ? GOES_ON : LEFT;
        this.tally(index, time);
      }
    }
    this.settleAfter(time, state, before, passed);
    const after = this.guards(time, state);
    this.sides = this.sides.map((side, index) => {
      if (!this.isArmed(index, state)) return IDLE;
      // Kinks have no more than sides.
      const isClear = Math.abs(after[index]) > this.parts.rounding(index);
      if (this.isKink(index) && isClear) return known(Math.sign(after[index]));
      if (passed[index] === GOES_ON) return fresh(true, 4 * Math.abs(before[index]));
      if (passed[index] !== LEFT && side !== IDLE && after[index] === before[index]) return side;
      return fresh(false, this.residual(index, time, state, after[index]));
    });
    return time;
  }

  // Gives the entries that an event sets their new values.
  apply(index, time, state) {
    this.machine.resets(time, state, this.resets);
    const { name, sets } = this.known[index];
    sets.forEach((entry, k) => {
      const value = this.resets[this.firstReset[index] + k];
      if (!Number.isFinite(value)) {
        throw new Stopped(time, `the new value of ${this.machine.nameOf(entry)} at event ${name} is no finite number`);
      }
      state[entry] = this.machine.known.states[entry].is_mode ? Math.round(value) : value;
    });
  }

  // Counts an event, and stops what does not end.
  tally(index, time) {
    const { name } = this.known[index];
    this.machine.work.switches++;
    this.latest.push(time);
    const endless = Math.max(ENDLESS, this.most);
    if (this.latest.length > endless) {
      const span = Math.max(this.run.until - this.run.from, Math.abs(time));
      if (time - this.latest.shift() <= NO_TIME * span) {
        throw new Stopped(time, `event ${name} and others happen ${endless} times within no time`);
      }
    }
    this.switches.push({ time, event: name });
  }

  // Sets the modes right at the start of a run: an event that changes a mode of its own `when`,
  // and whose guard is beyond zero already, happens at once.
  settleStart(time, state) {
    for (let happened = 0; ; happened++) {
      const found = this.contradiction(time, state, () => true, true);
      if (!found) break;
      if (found.moves || happened === this.most) {
        throw new Stopped(time, `the start contradicts event ${this.known[found.index].name}, which would change more than modes`);
      }
      state.set(found.state);
      this.tally(found.index, time);
    }
    const guards = this.guards(time, state);
    this.startAt(time, state);
    this.sides = this.sides.map((_, index) => {
      if (!this.isArmed(index, state)) return IDLE;
      return fresh(false, this.residual(index, time, state, guards[index]));
    });
  }

  // After events: lets those happen that were not watched for before, or whose guards have
  // jumped, and whose guards are beyond zero.
  settleAfter(time, state, before, passed) {
    const asked = this.known.map(({ direction }, index) =>
      this.sides[index] === IDLE || (!isBeyond(direction, before[index]) && !passed[index]));
    this.hold(time, state);
    for (let happened = 0; ; happened++) {
      const found = this.contradiction(time, state, (index) => asked[index], false);
      if (!found) return;
      if (happened === this.most) {
        throw new Stopped(time, `event ${this.known[found.index].name} contradicts what others do`);
      }
      state.set(found.state);
      this.hold(time, state);
      passed[found.index] = LEFT;
      this.tally(found.index, time);
    }
  }

  // Puts velocities onto what holds in the modes of the state: what has only now begun to stick
  // is at rest, but for what the search for its time has left.
  hold(time, state) {
    if (this.machine.known.holds_in_modes) this.run.constraints.rest(time, state);
  }

  // The first event of some that contradicts the modes of a state, and what it would do.
  contradiction(time, state, isAsked, orMoves) {
    const guards = this.guards(time, state);
    for (let index = 0; index < this.machine.events; index++) {
      const { direction, when, sets } = this.known[index];
      const setsItsMode = when.some(([entry]) => sets.includes(entry));
      if (!setsItsMode || !isAsked(index) || !this.isArmed(index, state)) continue;
      if (!isBeyond(direction, guards[index])) continue;
      if (Math.abs(guards[index]) <= this.blur(index, time, state)) continue;
      const after = state.slice();
      this.apply(index, time, after);
      const isMoved = (value, entry) =>
        !this.machine.known.states[entry].is_mode && Math.abs(value - state[entry]) > this.allowed(entry, state);
      const moves = after.some(isMoved);
      if (!this.isArmed(index, after) || (orMoves && moves)) return { index, state: after, moves };
    }
    return null;
  }

  // What is zero of a guard that is watched anew: beyond zero by less than the tolerances is at
  // zero.
  residual(index, time, state, guard) {
    return isBeyond(this.direction(index), guard) ? this.blur(index, time, state) : 0;
  }

  // By how much the tolerances of the run may change a guard.
  blur(index, time, state) {
    const guard = this.guards(time, state)[index];
    const shifted = state.slice();
    return state.reduce((blur, value, entry) => {
      if (this.machine.known.states[entry].is_mode) return blur;
      shifted[entry] = value + this.allowed(entry, state);
      const change = Math.abs(this.guards(time, shifted)[index] - guard);
      shifted[entry] = value;
      return blur + change;
    }, 0);
  }

  allowed(entry, state) {
    return this.run.atol[entry] + this.run.rtol * Math.abs(state[entry]);
  }
}

// Whether a guard is on the far side of zero, on which its event has happened.
function isBeyond(direction, guard) {
  if (direction === "both") return false;
  return direction === "rising" ? guard > 0 : guard < 0;
}
