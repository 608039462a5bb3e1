// Where within a step a guard passes zero. As the engine finds it, see its `watch/passing.rs`.

// Below this share of its largest value over a step, a guard is zero but for rounding.
const ROUNDING = 1e-12;
// A guard that would change by less than this share, at the rate it has, is at rest.
const AT_REST = 1e-9;
// A step is looked at in so many parts, and in so many times more at most.
const PARTS = 4;
const FINEST = 32;

// What became of a guard where events happened: it passed zero, and was watched all the time; or
// its event left the modes in which it is watched for.
const GOES_ON = "goes on";
const LEFT = "left";
const IDLE = { kind: "idle" };
const known = (side) => ({ kind: "known", side });
const fresh = (passed, residual) => ({ kind: "fresh", passed, residual });

// Whether a guard that comes from `side` passes in this direction.
function isWanted(direction, side) {
  if (direction === "both") return true;
  return direction === "rising" ? side < 0 : side > 0;
}

// Between two times, if numbers lie there that differ by more than rounding.
function middleOf(low, high) {
  const middle = low + 0.5 * (high - low);
  const resolved = 4 * Number.EPSILON * Math.max(Math.abs(low), Math.abs(high));
  return high - low > resolved && low < middle && middle < high ? middle : null;
}

// The cubic through two times, values and rates, at a time between.
function cubic([from, low, lowRate], [until, high, highRate], time) {
  const span = until - from;
  const [s, left] = [(time - from) / span, (until - time) / span];
  const ends = left * left * (1 + 2 * s) * low + s * s * (3 - 2 * s) * high;
  return ends + span * s * left * (left * lowRate - s * highRate);
}

// Guards and their rates at the ends of the parts of a step.
class Parts {
  constructor(machine) {
    this.machine = machine;
    this.events = machine.events;
    this.count = machine.events + machine.kinks;
    this.state = new Float64Array(machine.size);
    this.times = [];
    this.guards = [];
    this.rates = [];
    this.one = [new Float64Array(this.count), new Float64Array(this.count)];
    this.bends = new Float64Array(this.count);
    this.sizes = new Float64Array(this.count);
    // Of each guard, what a relative change of 1 of all states does, and how many steps ago.
    this.noise = new Float64Array(this.count);
    this.age = Infinity;
  }

  // Looks at a step of `method`, in parts so short that guards between their ends are as these
  // and their rates foretell.
  fill(method, stretch, from, until, start, sides) {
    this.method = method;
    this.stretch = stretch;
    for (let finer = 1; ; finer *= 2) {
      this.fillParts(from, until, start, finer * PARTS);
      if (finer === 1) this.lookForNoise(from, start);
      if (finer >= FINEST || this.isForetold(sides)) break;
    }
    for (let guard = 0; guard < this.count; guard++) {
      this.sizes[guard] = Math.max(this.sizes[guard], this.largest(guard));
      this.bends[guard] = 0;
      for (let part = 0; part < this.parts; part++) {
        const change = this.rates[part + 1][guard] - this.rates[part][guard];
        const bend = Math.abs(change / (this.times[part + 1] - this.times[part]));
        if (Number.isFinite(bend)) this.bends[guard] = Math.max(this.bends[guard], bend);
      }
    }
  }

  fillParts(from, until, start, parts) {
    this.parts = parts;
    for (let part = 0; part <= parts; part++) {
      const time = part === parts ? until : from + (until - from) * (part / parts);
      if (part === 0) this.state.set(start);
      else if (part === parts) this.state.set(this.method.end);
      else this.method.interpolate(time, this.state);
      this.times[part] = time;
      this.guards[part] ??= new Float64Array(this.count);
      this.rates[part] ??= new Float64Array(this.count);
      this.evaluate(time, this.state, this.guards[part], this.rates[part]);
    }
  }

  evaluate(time, state, guards, rates) {
    const at = this.stretch.within(time);
    this.machine.guards(at, state, guards);
    this.machine.guardRates(at, state, rates);
  }

  // Looks at how far rounding of states moves guards, where one is so small that it may be
  // nothing else; now and then, for that changes slowly.
  lookForNoise(time, start) {
    const SMALL = 1e-6;
    const FRESH = 32;
    const CHANGE = 1e-7;
    this.age++;
    const isSmall = (size, guard) => this.largest(guard) <= SMALL * size;
    if (this.age < FRESH || !this.sizes.some(isSmall)) return;
    this.age = 0;
    this.noise.fill(0);
    const state = start.slice();
    const [here, beside, rates] = [0, 1, 2].map(() => new Float64Array(this.count));
    this.evaluate(time, state, here, rates);
    for (let entry = 0; entry <= state.length; entry++) {
      if (entry < state.length) state[entry] *= 1 + CHANGE;
      this.evaluate(entry < state.length ? time : time * (1 + CHANGE), state, beside, rates);
      if (entry < state.length) state[entry] = start[entry];
      for (let guard = 0; guard < this.count; guard++) {
        const change = Math.abs(beside[guard] - here[guard]) / CHANGE;
        if (Number.isFinite(change)) this.noise[guard] += change;
      }
    }
  }

  // Whether every guard that might pass is, between the ends of parts, as the cubic through its
  // values and rates there has it.
  isForetold(sides) {
    const NEAR = 0.1;
    // Parts are even: what goes round once a part looks as if it stood still but here.
    const UNEVEN = 0.382;
    const { times, guards, rates, parts } = this;
    const ofFirst = times[0] + UNEVEN * (times[1] - times[0]);
    let hasLooked = false;
    for (let guard = 0; guard < this.count; guard++) {
      if (sides[guard] === IDLE) continue;
      let [least, most, fastest] = [Infinity, -Infinity, 0];
      for (let part = 0; part <= parts; part++) {
        least = Math.min(least, guards[part][guard]);
        most = Math.max(most, guards[part][guard]);
        fastest = Math.max(fastest, Math.abs(rates[part][guard]));
      }
      const span = times[parts] - times[0];
      const far = Math.max(most - least, span * fastest, 0.5 * span * span * this.bends[guard]);
      const nearest = least > 0 ? least : -most;
      const rest = AT_REST * this.largest(guard);
      if (nearest > 4 * far || far <= rest) continue;
      const room = Math.max(NEAR * Math.max(most - least, rest), this.rounding(guard));
      const end = (part) => [times[part], guards[part][guard], rates[part][guard]];
      for (let part = 1; part < parts; part += 2) {
        const foretold = cubic(end(part - 1), end(part + 1), times[part]);
        if (!(Math.abs(foretold - guards[part][guard]) <= room)) return false;
      }
      if (!hasLooked) this.between(ofFirst, guard);
      hasLooked = true;
      if (!(Math.abs(cubic(end(0), end(1), ofFirst) - this.one[0][guard]) <= room)) return false;
    }
    return true;
  }

  // A guard and its rate at a state, and within the step.
  at(time, state, guard) {
    this.evaluate(time, state, ...this.one);
    return [this.one[0][guard], this.one[1][guard]];
  }

  between(time, guard) {
    this.method.interpolate(time, this.state);
    return this.at(time, this.state, guard);
  }

  largest(guard) {
    let most = 0;
    for (let part = 0; part <= this.parts; part++) most = Math.max(most, Math.abs(this.guards[part][guard]));
    return most;
  }

  // What of a guard may be rounding of what it compares.
  rounding(guard) {
    const size = Math.max(this.sizes[guard], this.largest(guard), this.noise[guard]);
    return 64 * Number.EPSILON * size;
  }

  // What a guard does over the step that is on `side` at its start: `{ stays }` with the side
  // at its end, or `{ time, from }` where it passes.
  outcome(guard, direction, side) {
    if (side === IDLE) return { stays: IDLE };
    const isKink = guard >= this.events;
    const start = side.kind === "known" ? this.carried(guard, side.side) : this.firstSeen(guard, direction, side);
    if (start === null) return { stays: side };
    let on = start.on;
    if (start.leaves) {
      if (!isKink && isWanted(direction, start.leaves)) return { time: this.times[0], from: start.leaves };
      on = -start.leaves;
    }
    const rounding = this.rounding(guard);
    const { guards, rates } = this;
    for (let part = start.part ?? 0; part < this.parts; part++) {
      const bracket = [this.times[part], this.times[part + 1]];
      // It is behind, whatever was taken for its side.
      if (isKink && on * guards[part][guard] < -rounding) on = -on;
      const crosses = on * guards[part + 1][guard] < -rounding;
      const turns = on * rates[part][guard] < 0 && on * rates[part + 1][guard] > 0;
      if (crosses && isKink && on * guards[part][guard] < 0 && on * rates[part][guard] <= 0) {
        // By rounding it was there already as the part began.
        on = -on;
      } else if (crosses) {
        if (on * guards[part][guard] <= 0 && on * rates[part][guard] > 0) {
          // It sets out from zero, and is back beyond it: the top is between.
          bracket[0] = this.turn(guard, bracket, on);
        }
        if (isWanted(direction, on)) {
          const time = this.root(guard, bracket, on);
          // A step cannot end at a kink at which it starts.
          if (!isKink || time > this.times[0]) return { time, from: on };
        }
        on = -on;
      } else if (turns) {
        const turn = this.turn(guard, bracket, -on);
        if (on * this.between(turn, guard)[0] < -rounding) {
          const there = isWanted(direction, on);
          const within = there ? [bracket[0], turn] : [turn, bracket[1]];
          const from = there ? on : -on;
          const time = this.root(guard, within, from);
          if (!isKink || time > this.times[0]) return { time, from };
        }
      }
    }
    return { stays: known(on) };
  }

  // The start of a step for a guard whose side is known: it is still there, unless it jumped.
  carried(guard, side) {
    const least = Math.max(ROUNDING * this.largest(guard), this.rounding(guard));
    const hasJumped = side * this.guards[0][guard] < -least;
    return hasJumped ? { leaves: side } : { on: side, part: 0 };
  }

  // The start of a step for a guard whose side is not known; nothing if it is zero throughout.
  firstSeen(guard, direction, { passed, residual }) {
    const [value, rate] = [this.guards[0][guard], this.rates[0][guard]];
    const largest = this.largest(guard);
    const span = this.times[this.parts] - this.times[0];
    const byTime = 16 * Number.EPSILON * Math.abs(this.times[0]) * Math.abs(rate);
    const zero = Math.max(residual, ROUNDING * largest, byTime);
    // What may be beyond zero by rounding alone is not taken for beyond.
    const rounding = this.rounding(guard);
    const isFar = (side) => direction !== "both" && isWanted(direction, -Math.sign(side));
    const unclear = isFar(value) ? Math.max(zero, rounding) : zero;
    if (Math.abs(value) > unclear) return { on: Math.sign(value), part: 0 };
    let [seen, part] = [Math.sign(rate), 0];
    const moved = Math.abs(rate) * span;
    const isKnown = moved > AT_REST * largest && rate !== 0;
    if (!(isKnown && (!isFar(rate) || moved > rounding))) {
      const clear = Math.max(zero, AT_REST * largest, rounding);
      part = 1;
      while (part <= this.parts && !(Math.abs(this.guards[part][guard]) > clear)) part++;
      if (part > this.parts) return null;
      seen = Math.sign(this.guards[part][guard]);
    }
    // What has just passed at a finite rate goes on; what then rests does not.
    const goesOn = passed && part === 0;
    if (!goesOn && isFar(seen)) return { leaves: -seen };
    return { on: seen, part };
  }

  // Where `side` g is largest between two times, at which its rate is above and below zero.
  turn(guard, [low, high], side) {
    for (let middle; (middle = middleOf(low, high)) !== null;) {
      if (side * this.between(middle, guard)[1] > 0) low = middle;
      else high = middle;
    }
    return low;
  }

  // Where g leaves `side` between two times, by the rule of false position with halving
  // (Illinois); never early.
  root(guard, [low, high], side) {
    let lowValue = side * this.between(low, guard)[0];
    let highValue = side * this.between(high, guard)[0];
    let kept = 0;
    let count = 0;
    for (let middle; (middle = middleOf(low, high)) !== null;) {
      count++;
      const chord = high - (high - low) * (highValue / (highValue - lowValue));
      const time = low < chord && chord < high && count % 4 !== 0 ? chord : middle;
      const value = side * this.between(time, guard)[0];
      if (value > 0) {
        [low, lowValue] = [time, value];
        if (kept === 1) highValue *= 0.5;
        kept = 1;
      } else {
        [high, highValue] = [time, value];
        if (kept === -1) lowValue *= 0.5;
        kept = -1;
      }
      if (value === 0) break;
    }
    return high;
  }
}
