// Relations: the branch of each, whether it is active, and surfaces along which the motion slides.
// A relation at zero takes the side to which g' on both sides points, or g'' where g' vanishes; the
// motion slides where both point at the surface.

// Slot above a surface, and its place, by the slot below: of a comparison, or of an integer.
const aboveSlot = (below) => (below === BELOW ? ABOVE : below + 1);
const levelOf = (below) => (below === BELOW ? 0 : below + 1);

class Relations {
  constructor(system) {
    Object.assign(this, { system, machine: system.machine, all: system.machine.known.relations });
    this.active = this.all.map(() => false);
    // Guard and time of the last change of each.
    this.atChange = [];
    this.times = [];
  }

  isSliding(relation) {
    return this.system.slides.some((slide) => slide.relation === relation);
  }

  slide(slides) {
    slides.forEach(({ relation, below }) => { this.machine.slots[relation] = below; });
    this.system.slides = slides.slice().sort((a, b) => a.relation - b.relation);
  }

  // Settles all at a state at which some change. `isWithin` tells of a guard too near to zero.
  settle(time, state, armed, changes = [], isWithin = () => false) {
    const isLeft = ({ relation }) => changes.some((change) => change.relation === relation);
    let slides = this.system.slides.filter((slide) => !isLeft(slide));
    const before = this.surfaces(time, state);
    const zero = this.takeSides(time, state, changes, slides, isWithin);
    // A surface that jumps with the relations that it reads leaves the motion behind.
    const after = this.surfaces(time, state);
    const stays = ({ relation }) => before.guards[relation] === after.guards[relation];
    if (before && !slides.every(stays)) {
      slides = slides.filter(stays);
      const isKnown = ({ relation }) => zero.some((one) => one.relation === relation);
      zero.push(...this.takeSides(time, state, [], slides, isWithin).filter((one) => !isKnown(one)));
    }
    this.findActive(armed);
    const isActive = ({ relation }) => this.active[relation];
    this.leaveOrSlide(time, state, slides.filter(isActive), zero.filter(isActive));
    this.findActive(armed);
  }

  // Guards and their rates, if the motion slides along any surface.
  surfaces(time, state) {
    if (!this.system.slides.length) return null;
    const [guards, rates] = ["kink_guards", "kink_rates"].map((of) => this.machine.kinks(of, time, state));
    return { guards, rates };
  }

  // Ends the sliding along surfaces off which a jump takes the motion: no finite force follows a
  // surface that jumps, or brings back a state that is moved off it. `passed` is the time between.
  leaveSurfaces(before, time, state, rounding, passed = 0) {
    if (!before) return;
    const { guards, rates } = this.surfaces(time, state);
    this.slide(this.system.slides.filter(({ relation, isSecond }) => {
      const way = passed * Math.max(Math.abs(before.rates[relation]), Math.abs(rates[relation]));
      const hasLeft = Math.abs(guards[relation] - before.guards[relation]) > rounding(relation) + way;
      return !hasLeft && !(isSecond && rates[relation] !== before.rates[relation]);
    }));
  }

  // Takes the sides of guards, each after those that it reads. Returns those at their
  // surfaces, with the slots to which they were going.
  takeSides(time, state, changes, slides, isWithin) {
    const { slots } = this.machine;
    const before = this.machine.kinks("kink_guards", time, state);
    let guards = before;
    const zero = [];
    this.all.forEach(({ kind }, relation) => {
      if (kind === "zone" || slides.some((slide) => slide.relation === relation)) return;
      const [guard, slot] = [guards[relation], slots[relation]];
      const hasJumped = kind === "branch" && guard !== before[relation];
      const change = hasJumped ? undefined : changes.find((it) => it.relation === relation);
      if (!change && this.atChange[relation] === guard) return;
      const isWhole = kind === "whole";
      let next = isWhole ? Math.floor(guard) : guard < 0 ? BELOW : ABOVE;
      if (isWhole && (change ? Math.abs(guard - change.slot - 0.5) > 1 : guard !== next)) {
        // Between integers, moved there by what it reads if it changes.
      } else if (change) {
        next = change.slot;
        // One that changes again at once was seen to leave for that side.
        const isAgain = Math.abs(time - this.times[relation]) <= 4 * EPSILON * Math.abs(time);
        this.times[relation] = time;
        if (!change.leaves && !isAgain) zero.push({ relation, below: change.below, toward: next });
      } else if (isWhole) {
        // What reads it is evaluated on the side to which it goes.
        if (this.machine.kinks("kink_rates", time, state)[relation] < 0) next--;
        zero.push({ relation, below: guard - 1, toward: next });
      } else if (guard === 0) {
        next = slot || ABOVE;
        zero.push({ relation, below: BELOW, toward: next });
      } else if (slot && isWithin(relation, guard)) {
        next = slot;
      }
      if (change) this.atChange[relation] = guard;
      if (next === slot) return;
      slots[relation] = next;
      guards = this.machine.kinks("kink_guards", time, state);
    });
    return zero;
  }

  // One whose readers are all on branches that are not taken, or events that are not armed, ends
  // no step.
  findActive(armed) {
    const found = [];
    const isTaken = ([reader, of]) => {
      if (reader === "rate") return true;
      if (reader === "event") return armed[of];
      const isThere = reader === "relation" || (this.machine.slots[of] < 0) === (reader === "below") || this.isSliding(of);
      return isThere && isActive(of);
    };
    const isActive = (relation) => {
      if (found[relation] === undefined) {
        found[relation] = true;
        found[relation] = this.all[relation].readers.some(isTaken);
      }
      return found[relation];
    };
    this.active = this.all.map((_, relation) => isActive(relation));
  }

  leaveOrSlide(time, state, slides, zero) {
    this.slide(slides);
    const all = [...slides.map(({ relation, below }) => ({ relation, below, toward: below })), ...zero];
    // Each may change in turn, and once more.
    for (let round = 0; round < 2 * all.length + 2; round++) {
      if (!all.filter((one) => this.leave(time, state, one)).length) return;
    }
    throw this.chatters(time, all[0].relation);
  }

  // Lets one leave its surface or slide along it; whether that changes anything.
  leave(time, state, { relation, below: low, toward }) {
    const { system, machine } = this;
    const { slots } = machine;
    const before = slots[relation];
    const own = system.slides.find((slide) => slide.relation === relation);
    this.slide(system.slides.filter((slide) => slide !== own));
    const high = aboveSlot(low);
    const [below, above] = [low, high].map((slot) => {
      slots[relation] = slot;
      const rate = system.blended("kink_rates", time, state, machine.known.kinks)[relation];
      const bend = system.bend(relation, time, state, system.rates(time, state));
      // A rate that turns before any time has passed is rounding of zero.
      const isSecond = !(Math.abs(rate) > 4 * EPSILON * Math.abs(time * bend));
      return { way: Math.sign(isSecond ? bend : rate), isSecond };
    });
    if (below.way > 0 && above.way < 0) {
      const isSecond = below.isSecond && above.isSecond;
      return this.slideAlong(time, state, { relation, below: low, isSecond }, own, toward);
    }
    slots[relation] = toward;
    if (below.way >= 0 && above.way > 0) slots[relation] = high;
    if (below.way < 0 && above.way <= 0) slots[relation] = low;
    return own !== undefined || slots[relation] !== before;
  }

  slideAlong(time, state, slide, own, toward) {
    const { system, machine } = this;
    const before = system.slides;
    const inertia = [slide.below, aboveSlot(slide.below)].map((slot) => {
      machine.slots[slide.relation] = slot;
      return ["mass_matrix", "constraint_matrix"].map((name) =>
        machine.values(name, time, state, machine.known[name].entries.length).join());
    });
    if (inertia[0].join() !== inertia[1].join()) throw this.chatters(time, slide.relation);
    this.slide([...before, slide]);
    const { alphas } = system.combination(time, state);
    const isShare = (alpha) => alpha >= -1e-9 && alpha <= 1 + 1e-9;
    // With several surfaces, no share of the rates may stay on all of them.
    if (before.length && !alphas.every(isShare)) {
      this.slide(before);
      machine.slots[slide.relation] = toward;
      return own !== undefined;
    }
    if (!alphas.every(Number.isFinite)) throw this.chatters(time, slide.relation);
    return own?.isSecond !== slide.isSecond;
  }

  chatters(time, relation) {
    return new Stopped(time, `the motion cannot go on along switching surface ${relation + 1}: it chatters`);
  }
}
