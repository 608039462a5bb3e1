// Places of a machine in space, computed by functions that the generator wrote: elements of the
// drawing with their numbers along the axes of the world.

// Numbers of each kind of element: points, directions, lengths.
const NUMBERS = {
  up: [["d", 3]],
  hinge: [["p", 3], ["d", 3]],
  slide: [["p", 3], ["p", 3], ["d", 3]],
  ball: [["p", 3]],
  link: [["p", 3], ["p", 3]],
  rod: [["p", 3], ["p", 3]],
  spring: [["p", 3], ["p", 3]],
  mass: [["p", 3]],
  cylinder: [["p", 3], ["p", 3], ["d", 3], ["l", 1]],
  sphere: [["p", 3], ["d", 3], ["d", 3], ["l", 1]],
  box: [["p", 3], ["d", 3], ["d", 3], ["d", 3]],
};

function decoded(text, type) {
  return new type(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
}

class Places {
  static async of(known) {
    const math = Object.assign(Object.create(Math), { ln: Math.log, powf: Math.pow });
    const { instance } = await WebAssembly.instantiate(decoded(known.module, Uint8Array), { math });
    return new Places(known, instance.exports);
  }

  constructor(known, functions) {
    const { layout, states, parameters, elements } = known;
    const numbers = (place, count) => new Float64Array(functions.memory.buffer, place, count);
    Object.assign(this, { known, functions, elements });
    this.state = numbers(layout.state, states);
    this.parameters = numbers(layout.parameters, parameters.length);
    this.results = numbers(layout.results);
    this.stored = stored(known);
  }

  // Parameters of a run; its elements are placed by them from now on.
  begin({ parameters }) {
    this.parameters.set(parameters);
    this.functions.prepare(0);
  }

  // Elements at a time of a run: kind, name, and parts of three numbers or one. Nothing if some
  // number is none.
  at(run, time) {
    const where = place(run, time);
    for (const entry of this.known.entries) this.state[entry] = between(run.tracks.get(entry), where);
    this.functions.outputs(time);
    let next = 0;
    const placed = this.elements.map(({ kind, name }) => {
      const parts = NUMBERS[kind].map(([what, count]) => {
        const values = this.results.slice(next, next + count);
        next += count;
        return { what, values };
      });
      return { kind, name, parts, of: parts.map(({ what, values }) => (what === "l" ? values[0] : [...values])) };
    });
    return this.results.subarray(0, next).every(Number.isFinite) ? placed : null;
  }
}

// The stored run, as far as drawings need it.
function stored({ run, tracked, parameters }) {
  const times = Float64Array.from(decoded(run.times, Float32Array));
  const values = decoded(run.values, Float32Array);
  const taken = times.length;
  const tracks = new Map(tracked.map((entry, k) => [entry, Float64Array.from(values.subarray(k * taken, (k + 1) * taken))]));
  return { times, taken, from: times[0], tracks, parameters };
}
