// A start in equilibrium: q'' = 0 and z' = 0 near that of the stored run, by Newton's method with
// halved steps. Of what the equations leave open the change is the least, and least of all that of
// values which the spec names. The engine begins at the guess, and creeps where Newton's method fails.

class Equilibrium {
  constructor(machine, time) {
    const { known, size } = machine;
    Object.assign(this, { machine, time, size });
    const { states, equilibrium } = known;
    this.columns = equilibrium.unknown;
    this.rows = equilibrium.still;
    // What is named moves only where nothing else can.
    const NAMED = 1e-6;
    this.weights = this.columns.map((index) => states[index].scale * (states[index].is_given ? NAMED : 1));
    this.rates = new Float64Array(size);
    this.jacobian = new Float64Array(size * size);
  }

  // Where the search begins: the equilibrium of the stored run, moved as the guess is.
  guess() {
    const { guess, state } = this.machine.known.equilibrium;
    return this.machine.initial().map((value, index) => state[index] + (value - guess[index]));
  }

  // Moves a state into the equilibrium of its modes.
  find(state) {
    const ROUNDS = 100;
    const HALVINGS = 30;
    const ACCEPTED = 1e-9;
    let off = this.off(state);
    for (let round = 0; round < ROUNDS && off > Number.EPSILON; round++) {
      const step = this.step(state);
      const before = state.slice();
      let now = Infinity;
      for (let halving = 0, share = 1; halving < HALVINGS && !(now < off); halving++, share *= 0.5) {
        this.columns.forEach((index, k) => { state[index] = before[index] - share * this.weights[k] * step[k]; });
        now = this.off(state);
      }
      if (!(now < off)) {
        state.set(before);
        break;
      }
      off = now;
    }
    if (!(off <= ACCEPTED)) throw new Stopped(this.time, "no equilibrium is found near that of the stored run");
  }

  // The largest rate, over what its row of the Jacobian makes of states that move by their sizes.
  off(state) {
    const { machine, size, rates, jacobian } = this;
    machine.rate(this.time, state, rates);
    machine.jacobian(this.time, state, jacobian);
    let most = 0;
    for (const row of this.rows) {
      if (rates[row] === 0) continue;
      let length = 0;
      for (let column = 0; column < size; column++) {
        length += Math.abs(jacobian[row * size + column]) * machine.known.states[column].scale;
      }
      const off = Math.abs(rates[row]) / length;
      most = off <= most ? most : off;
    }
    return most;
  }

  // The least step, over weights, that would bring all rates to zero if they were linear.
  step(state) {
    const { machine, size, rows, columns, weights, rates, jacobian } = this;
    machine.rate(this.time, state, rates);
    machine.jacobian(this.time, state, jacobian);
    const slope = (row, k) => jacobian[row * size + columns[k]] * weights[k];
    const weighed = Float64Array.from({ length: rows.length * columns.length }, (_, place) =>
      slope(rows[Math.floor(place / columns.length)], place % columns.length));
    return shortest(weighed, rows.length, columns.length, rows.map((row) => rates[row]));
  }
}
