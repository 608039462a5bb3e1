// Dense linear equations: LU factors with partial pivoting, rows one after another.

class Factors {
  constructor(size) {
    this.size = size;
    this.values = new Float64Array(size * size);
    this.pivots = new Int32Array(size);
    this.room = new Float64Array(size);
  }

  // Factors what is in `values`, in place; false if it is singular. The sign of the determinant
  // is told in `isNegative`.
  factor() {
    const { size, values, pivots } = this;
    this.isNegative = false;
    for (let k = 0; k < size; k++) {
      let pivot = k;
      for (let row = k + 1; row < size; row++) {
        if (Math.abs(values[row * size + k]) > Math.abs(values[pivot * size + k])) pivot = row;
      }
      const largest = values[pivot * size + k];
      if (!(Math.abs(largest) > 0 && Number.isFinite(largest))) return false;
      pivots[k] = pivot;
      if (pivot !== k) this.swap(pivot, k);
      if ((pivot !== k) !== (largest < 0)) this.isNegative = !this.isNegative;
      for (let row = k + 1; row < size; row++) {
        if (values[row * size + k] === 0) continue;
        const factor = (values[row * size + k] /= largest);
        for (let column = k + 1; column < size; column++) {
          values[row * size + column] -= factor * values[k * size + column];
        }
      }
    }
    return true;
  }

  swap(one, other) {
    const { size, values } = this;
    for (let column = 0; column < size; column++) {
      const kept = values[one * size + column];
      values[one * size + column] = values[other * size + column];
      values[other * size + column] = kept;
    }
  }

  // Solves for a right side, in place.
  solve(x, offset = 0) {
    const { size, values, pivots } = this;
    for (let k = 0; k < size; k++) {
      const pivot = offset + pivots[k];
      [x[offset + k], x[pivot]] = [x[pivot], x[offset + k]];
    }
    for (let row = 0; row < size; row++) {
      let sum = x[offset + row];
      for (let column = 0; column < row; column++) sum -= values[row * size + column] * x[offset + column];
      x[offset + row] = sum;
    }
    for (let row = size - 1; row >= 0; row--) {
      let sum = x[offset + row];
      for (let column = row + 1; column < size; column++) sum -= values[row * size + column] * x[offset + column];
      x[offset + row] = sum / values[row * size + row];
    }
  }
}

// The shortest x of those that fulfil A x = b, rows of A one after another; rows that follow
// from others are left out. By rows made perpendicular to each other.
function shortest(matrix, rows, columns, right) {
  const NOTHING = 1e-11;
  const basis = [];
  const x = new Float64Array(columns);
  const dot = (a, b) => a.reduce((sum, value, index) => sum + value * b[index], 0);
  for (let row = 0; row < rows; row++) {
    const line = matrix.slice(row * columns, (row + 1) * columns);
    const length = Math.sqrt(dot(line, line));
    if (!(length > 0)) continue;
    // Twice is enough (Kahan).
    for (let round = 0; round < 2; round++) {
      for (const unit of basis) {
        const share = dot(unit, line);
        unit.forEach((value, index) => { line[index] -= share * value; });
      }
    }
    const rest = Math.sqrt(dot(line, line));
    if (rest <= NOTHING * length) continue;
    const unit = line.map((value) => value / rest);
    const own = matrix.subarray(row * columns, (row + 1) * columns);
    // What is still missing of this row, by the new direction alone.
    const missing = (right[row] - dot(own, x)) / dot(own, unit);
    unit.forEach((value, index) => { x[index] += missing * value; });
    basis.push(unit);
  }
  return x;
}
