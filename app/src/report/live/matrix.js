// Linear equations with dense matrices, row after row, and solutions of least size.

const { EPSILON } = Number;

const range = (length) => Array.from({ length }, (_, index) => index);
function dot(a, b) {
  let sum = 0;
  for (let index = 0; index < a.length; index++) sum += a[index] * b[index];
  return sum;
}
const length = (values) => Math.sqrt(dot(values, values));
function largest(values) {
  let most = 0;
  for (let index = 0; index < values.length; index++) most = Math.max(most, Math.abs(values[index]));
  return most;
}

// LU factors with partial pivoting.
class Factors {
  constructor(size) {
    Object.assign(this, { size, values: new Float64Array(size * size), pivots: new Int32Array(size) });
  }

  // Factors `values` in place; false if they are singular. `isNegative` is the determinant's sign.
  factor() {
    const { size, values, pivots } = this;
    this.isNegative = false;
    for (let k = 0; k < size; k++) {
      let pivot = k;
      for (let row = k + 1; row < size; row++) {
        if (Math.abs(values[row * size + k]) > Math.abs(values[pivot * size + k])) pivot = row;
      }
      const divisor = values[pivot * size + k];
      if (!(Math.abs(divisor) > 0 && Number.isFinite(divisor))) return false;
      pivots[k] = pivot;
      for (let column = 0; pivot !== k && column < size; column++) {
        const kept = values[k * size + column];
        values[k * size + column] = values[pivot * size + column];
        values[pivot * size + column] = kept;
      }
      if ((pivot !== k) !== (divisor < 0)) this.isNegative = !this.isNegative;
      for (let row = k + 1; row < size; row++) {
        if (values[row * size + k] === 0) continue;
        const factor = (values[row * size + k] /= divisor);
        for (let column = k + 1; column < size; column++) {
          values[row * size + column] -= factor * values[k * size + column];
        }
      }
    }
    return true;
  }

  // Solves for a right side, in place.
  solve(x) {
    const { size, values, pivots } = this;
    pivots.forEach((pivot, k) => { [x[k], x[pivot]] = [x[pivot], x[k]]; });
    for (let row = 0; row < size; row++) {
      for (let column = 0; column < row; column++) x[row] -= values[row * size + column] * x[column];
    }
    for (let row = size - 1; row >= 0; row--) {
      for (let column = row + 1; column < size; column++) x[row] -= values[row * size + column] * x[column];
      x[row] /= values[row * size + row];
    }
    return x;
  }
}

// Rows made perpendicular to those before them, of length 1; null for a row that follows from them
// but for a share of its length.
function perpendicular(rows, share) {
  const basis = [];
  return rows.map((row) => {
    let rest = row;
    // Twice is enough (Kahan).
    for (const unit of [...basis, ...basis]) {
      const along = dot(unit, rest);
      rest = rest.map((value, index) => value - along * unit[index]);
    }
    const left = length(rest);
    if (!(left > share * length(row))) return null;
    basis.push(rest.map((value) => value / left));
    return basis[basis.length - 1];
  });
}

// Moves entries of a state to where residuals vanish, by the shortest way over their weights:
// Newton's method with halved steps and slopes by differences. Returns what is left of each, over
// its change as entries move by their weights.
function nearest(state, entries, weights, residuals) {
  const [ROUNDS, HALVINGS, FOLLOWS] = [100, 30, 1e-7];
  const at = () => [...residuals()];
  let off = at();
  for (let round = 0; ; round++) {
    const columns = entries.map((entry, k) => {
      const [value, by] = [state[entry], Math.cbrt(EPSILON) * Math.max(weights[k], Math.abs(state[entry]))];
      const [ahead, behind] = [by, -by].map((by) => {
        state[entry] = value + by;
        return at();
      });
      state[entry] = value;
      return ahead.map((value, row) => ((value - behind[row]) / (2 * by)) * weights[k]);
    });
    const rows = off.map((_, row) => columns.map((column) => column[row]));
    const left = off.map((value, row) => (value === 0 ? 0 : Math.abs(value) / length(rows[row])));
    if (round === ROUNDS || !(largest(left) > EPSILON)) return left;
    const step = new Array(entries.length).fill(0);
    perpendicular(rows, FOLLOWS).forEach((unit, row) => {
      if (!unit) return;
      const missing = (off[row] - dot(rows[row], step)) / dot(rows[row], unit);
      unit.forEach((value, k) => { step[k] += missing * value; });
    });
    const before = state.slice();
    let next = off;
    for (let halving = 0, share = 1; halving < HALVINGS && !(length(next) < length(off)); halving++, share /= 2) {
      entries.forEach((entry, k) => { state[entry] = before[entry] - share * weights[k] * step[k]; });
      next = at();
    }
    if (!(length(next) < length(off))) {
      state.set(before);
      return left;
    }
    off = next;
  }
}
