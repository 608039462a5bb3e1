// The machine's equations, as WebAssembly, on arrays of numbers. Relations are held by slots: the
// branch of a comparison, or the integer of a floor.

const [BELOW, ABOVE] = [-Infinity, Infinity];

class Stopped extends Error {
  constructor(time, cause) {
    super(cause);
    this.time = time;
  }
}

class Machine {
  static async of(known) {
    const bytes = Uint8Array.from(atob(known.module), (letter) => letter.charCodeAt(0));
    const math = Object.assign(Object.create(Math), { ln: Math.log, powf: Math.pow });
    const { instance } = await WebAssembly.instantiate(bytes, { math });
    return new Machine(known, instance.exports);
  }

  constructor(known, functions) {
    const { layout, states, parameters, relations } = known;
    const numbers = (place, count) => new Float64Array(functions.memory.buffer, place, count);
    Object.assign(this, { known, functions, size: states.length });
    this.state = numbers(layout.state, states.length);
    this.parameters = numbers(layout.parameters, parameters.length);
    this.slots = numbers(layout.slots, relations.length);
    this.results = numbers(layout.results);
    this.open = relations.map(({ kind }) => (kind === "whole" ? Infinity : 0));
    this.scales = states.map(({ scale }) => scale);
    this.isMode = states.map(({ kind }) => kind === "mode");
  }

  // Begins a run with these parameters and all relations live.
  begin(parameters) {
    this.work = { steps: 0, rejected: 0, rates: 0, jacobians: 0, switches: 0 };
    this.parameters.set(parameters);
    this.slots.set(this.open);
    this.functions.prepare(0);
  }

  // Results of a function; the machine may lack it where they are none.
  values(name, time, state, count) {
    return count === 0 ? new Float64Array(0) : this.call(name, time, state).slice(0, count);
  }

  // The same in the memory of the module, until the next call.
  call(name, time, state) {
    this.state.set(state);
    this.functions[name](time);
    return this.results;
  }

  // The same with relations as the state has them, whatever is held.
  live(name, time, state, count) {
    const held = this.slots.slice();
    this.slots.set(this.open);
    const found = this.values(name, time, state, count);
    this.slots.set(held);
    return found;
  }

  rate(time, state, into) {
    this.work.rates++;
    const rate = this.call("rate", time, state);
    for (let index = 0; index < into.length; index++) into[index] = rate[index];
  }

  // A dense matrix, row after row; what is not in the pattern stays zero.
  matrix(name, time, state, into) {
    const { entries, columns } = this.known[name];
    this.values(name, time, state, entries.length).forEach((value, index) => {
      into[entries[index][0] * columns + entries[index][1]] = value;
    });
    return into;
  }

  kinks(name, time, state) {
    return this.values(name, time, state, this.known.kinks);
  }

  outputs(time, state) {
    if (this.known.shows_states) return state;
    return this.live("outputs", time, state, this.known.outputs.length);
  }

  name(entry) {
    return this.known.states[entry].name;
  }
}
