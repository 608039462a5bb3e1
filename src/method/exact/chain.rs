//! Eigenmodes of chains: masses on a line, springs between neighbours and to ground.
//!
//! ```text
//! K = L D L^T     d_i = p_i + k_i    p_(i+1) = g_(i+1) + k_i p_i / d_i    p_0 = g_0
//! ```
//!
//! where k_i is the spring behind the i-th mass and g_i the one to ground. Without subtractions, L
//! and D keep all their digits, and so does every eigenvalue of M^-1 K, even the slowest of a stiff
//! chain. Eigenvalues are bracketed by counting signs of L D L^T - w^2 M factored anew. They are
//! refined together with their eigenmodes by factors from both ends that meet where the eigenmode
//! is large. All eigenmodes cost n^2.
//!
//! Source: B. N. Parlett, I. S. Dhillon: Relatively robust representations of symmetric
//! tridiagonals, Linear Algebra Appl. 309 (2000) 121-151.

use nalgebra::DMatrix;

/// Number of eigenvalues bracketed side by side.
const LANES: usize = 8;
/// Relative width of a bracket from which the refinement starts.
const ENCLOSED: f64 = 1e-4;
/// Maximum number of bisections, from the largest eigenvalue down to any rounding.
const HALVINGS: usize = 1100;
/// Maximum number of refinements; three are usual.
const REFINEMENTS: usize = 60;
/// Number of roundings within which corrections may stop decreasing.
const STUCK: f64 = 16.0;
/// Ratio of a ground spring to its neighbouring springs below which it is rounding.
const NO_SPRING: f64 = 4.0 * f64::EPSILON;

/// Eigenvalues and eigenmodes of M^-1 K.
pub(super) struct ChainModes {
    pub(super) eigenvalues: Vec<f64>,
    /// Eigenmodes as columns, normalized by mass.
    pub(super) shapes: DMatrix<f64>,
    /// Largest product of neighbouring eigenmodes by mass, which should be zero: the amount by
    /// which rounding has mixed close eigenmodes.
    pub(super) mixing: f64,
}

/// Returns `None` if K is not such a chain. `stiffness` has each entry of K once.
pub(super) fn modes(mass: &[f64], stiffness: &[(usize, usize, f64)]) -> Option<ChainModes> {
    let n = mass.len();
    if mass.iter().any(|mass| !(*mass > 0.0 && mass.is_finite())) {
        return None;
    }
    let matrix = Tridiagonal::of(n, stiffness)?;
    let mut eigenvalues = Vec::with_capacity(n);
    let mut shapes = DMatrix::zeros(n, n);
    let mut mixing: f64 = 0.0;
    for line in &matrix.lines {
        if let [place] = line[..] {
            shapes[(place, eigenvalues.len())] = mass[place].sqrt().recip();
            eigenvalues.push(matrix.diagonal[place] / mass[place]);
            continue;
        }
        let chain = Factored::new(mass, &matrix, line)?;
        let first = eigenvalues.len();
        let mut room = Room::new(line.len());
        let enclosed = chain.enclosures();
        let mut before = vec![0.0; line.len()];
        for (index, ends) in enclosed.iter().enumerate() {
            let eigenvalue = chain.refine(*ends, &mut room)?;
            let mut shape = shapes.column_mut(first + index);
            for (place, value) in line.iter().zip(&room.mode) {
                shape[*place] = *value / mass[*place].sqrt();
            }
            let product: f64 = room.mode.iter().zip(&before).map(|(a, b)| a * b).sum();
            mixing = mixing.max(product.abs());
            before.copy_from_slice(&room.mode);
            eigenvalues.push(eigenvalue);
        }
    }
    Some(ChainModes { eigenvalues, shapes, mixing })
}

/// A matrix whose graph consists of separate lines.
struct Tridiagonal {
    diagonal: Vec<f64>,
    /// Neighbours of each place with their coupling entries.
    beside: Vec<Vec<(usize, f64)>>,
    /// Places along each line.
    lines: Vec<Vec<usize>>,
}

impl Tridiagonal {
    /// Returns `None` if the graph has another form, or the matrix is not symmetric to rounding.
    fn of(n: usize, entries: &[(usize, usize, f64)]) -> Option<Self> {
        let mut matrix =
            Self { diagonal: vec![0.0; n], beside: vec![Vec::new(); n], lines: Vec::new() };
        for &(row, column, value) in entries {
            if row == column {
                matrix.diagonal[row] += value;
            } else if value != 0.0 {
                if matrix.beside[row].len() == 2 {
                    return None;
                }
                matrix.beside[row].push((column, value));
            }
        }
        let coupling = |row: usize, column: usize| {
            let entry = matrix.beside[row].iter().find(|(place, _)| *place == column);
            entry.map(|(_, value)| *value)
        };
        let size = matrix.diagonal.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for (row, beside) in matrix.beside.iter().enumerate() {
            for (column, value) in beside {
                let other = coupling(*column, row)?;
                if (value - other).abs() > super::forms::ROUNDING * size {
                    return None;
                }
            }
        }
        let mut is_seen = vec![false; n];
        for start in 0..n {
            if is_seen[start] || matrix.beside[start].len() == 2 {
                continue;
            }
            let mut line = vec![start];
            is_seen[start] = true;
            let mut at = start;
            while let Some((next, _)) = matrix.beside[at].iter().find(|(next, _)| !is_seen[*next]) {
                at = *next;
                is_seen[at] = true;
                line.push(at);
            }
            matrix.lines.push(line);
        }
        // Remaining places form a ring.
        is_seen.iter().all(|is_seen| *is_seen).then_some(matrix)
    }

    /// Returns the spring between neighbours.
    fn spring(&self, row: usize, column: usize) -> f64 {
        let of = |row: usize, column: usize| {
            let entry = self.beside[row].iter().find(|(place, _)| *place == column);
            entry.map_or(0.0, |(_, value)| -value)
        };
        0.5 * (of(row, column) + of(column, row))
    }
}

/// Factors of M^-1/2 L D L^T M^-1/2 of one line.
struct Factored {
    /// Diagonal D.
    pivots: Vec<f64>,
    /// L below the diagonal.
    lower: Vec<f64>,
    /// D L^2.
    products: Vec<f64>,
    /// Upper bound of all eigenvalues.
    largest: f64,
}

impl Factored {
    /// Returns `None` if a spring has negative stiffness.
    fn new(mass: &[f64], matrix: &Tridiagonal, line: &[usize]) -> Option<Self> {
        let springs: Vec<f64> =
            line.windows(2).map(|pair| matrix.spring(pair[0], pair[1])).collect();
        if springs.iter().any(|spring| !(*spring > 0.0 && spring.is_finite())) {
            return None;
        }
        let mut chain = Self {
            pivots: Vec::with_capacity(line.len()),
            lower: Vec::with_capacity(springs.len()),
            products: Vec::with_capacity(springs.len()),
            largest: 0.0,
        };
        let mut in_series = 0.0;
        for (index, place) in line.iter().enumerate() {
            let before = index.checked_sub(1).map_or(0.0, |before| springs[before]);
            let after = springs.get(index).copied().unwrap_or(0.0);
            let diagonal = matrix.diagonal[*place];
            let to_ground = diagonal - before - after;
            let to_ground = if to_ground.abs() <= NO_SPRING * diagonal { 0.0 } else { to_ground };
            if !(to_ground >= 0.0 && to_ground.is_finite()) {
                return None;
            }
            let own = mass[*place];
            let stiffness = to_ground + in_series;
            let pivot = stiffness + after;
            chain.pivots.push(pivot / own);
            if let Some(next) = line.get(index + 1) {
                let ratio = after / pivot;
                chain.lower.push(-ratio * (own / mass[*next]).sqrt());
                chain.products.push(ratio * after / mass[*next]);
                in_series = ratio * stiffness;
            }
            let beside = |neighbour: Option<&usize>, spring: f64| {
                neighbour.map_or(0.0, |other| spring / (own * mass[*other]).sqrt())
            };
            let neighbours = beside(index.checked_sub(1).map(|i| &line[i]), before)
                + beside(line.get(index + 1), after);
            chain.largest = chain.largest.max(diagonal / own + neighbours);
        }
        chain.largest *= 1.0 + 1e-12;
        Some(chain)
    }

    fn len(&self) -> usize {
        self.pivots.len()
    }

    /// Returns the number of eigenvalues below each shift.
    fn below(&self, shifts: &[f64; LANES]) -> [u32; LANES] {
        let mut counts = [0; LANES];
        let mut rest = shifts.map(|shift| -shift);
        let products = self.products.iter().chain(&[0.0]);
        for (pivot, product) in self.pivots.iter().zip(products) {
            for lane in 0..LANES {
                let shifted = pivot + rest[lane];
                counts[lane] += u32::from(shifted < 0.0);
                // Avoids division by zero; the shift is an eigenvalue of the upper part, to
                // rounding.
                let shifted = if shifted == 0.0 { f64::MIN_POSITIVE } else { shifted };
                rest[lane] = product * (rest[lane] / shifted) - shifts[lane];
            }
        }
        counts
    }

    /// Returns brackets that contain one eigenvalue each.
    fn enclosures(&self) -> Vec<[f64; 2]> {
        let n = self.len();
        let mut enclosed = Vec::with_capacity(n);
        for first in (0..n).step_by(LANES) {
            let number = |lane: usize| (first + lane).min(n - 1) as u32;
            let (mut low, mut high) = ([0.0; LANES], [self.largest; LANES]);
            let (mut at_low, mut at_high) = ([0; LANES], [n as u32; LANES]);
            for _ in 0..HALVINGS {
                let is_open = |lane: usize| {
                    let is_alone =
                        at_low[lane] == number(lane) && at_high[lane] == number(lane) + 1;
                    let width = high[lane] - low[lane];
                    let rounding = 2.0 * f64::EPSILON * high[lane];
                    width > rounding.max(f64::MIN_POSITIVE)
                        && !(is_alone && width <= ENCLOSED * high[lane])
                };
                let is_open: [bool; LANES] = std::array::from_fn(is_open);
                if !is_open.contains(&true) {
                    break;
                }
                let middle: [f64; LANES] =
                    std::array::from_fn(|lane| 0.5 * (low[lane] + high[lane]));
                let counts = self.below(&middle);
                for lane in (0..LANES).filter(|lane| is_open[*lane]) {
                    if counts[lane] > number(lane) {
                        (high[lane], at_high[lane]) = (middle[lane], counts[lane]);
                    } else {
                        (low[lane], at_low[lane]) = (middle[lane], counts[lane]);
                    }
                }
            }
            enclosed.extend((0..LANES.min(n - first)).map(|lane| [low[lane], high[lane]]));
        }
        enclosed
    }

    /// Returns the eigenvalue in a bracket, accurate to rounding, and stores its normalized
    /// eigenmode in `room`. Returns `None` if it does not converge.
    fn refine(&self, [mut low, mut high]: [f64; 2], room: &mut Room) -> Option<f64> {
        let mut eigenvalue =
            if low == 0.0 && high <= f64::MIN_POSITIVE * 4.0 { 0.0 } else { 0.5 * (low + high) };
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let correction = self.twisted(eigenvalue, room);
            if !correction.is_finite() {
                return None;
            }
            let rounding = 2.0 * f64::EPSILON * eigenvalue;
            let is_stuck = correction.abs() > 0.5 * last;
            if correction.abs() <= if is_stuck { STUCK * rounding } else { rounding } {
                return Some(eigenvalue + correction);
            }
            let next = eigenvalue + correction;
            if next > low && next < high && !is_stuck {
                last = correction.abs();
                eigenvalue = next;
            } else {
                let is_above = self.below(&[eigenvalue; LANES])[0] == self.below(&[low; LANES])[0];
                if is_above {
                    low = eigenvalue;
                } else {
                    high = eigenvalue;
                }
                eigenvalue = 0.5 * (low + high);
                last = f64::INFINITY;
            }
        }
        None
    }

    /// Makes one step of inverse iteration from the meeting point of the factors from both ends.
    /// Stores the normalized vector in `room`, and returns the correction of the eigenvalue.
    fn twisted(&self, shift: f64, room: &mut Room) -> f64 {
        let n = self.len();
        let safe = |value: f64| if value == 0.0 { f64::MIN_POSITIVE } else { value };
        let mut rest = -shift;
        for index in 0..n {
            room.from_start[index] = rest;
            let Some(lower) = self.lower.get(index) else { break };
            let inverse = 1.0 / safe(self.pivots[index] + rest);
            room.down[index] = lower * self.pivots[index] * inverse;
            rest = self.products[index] * (rest * inverse) - shift;
        }
        let mut rest = self.pivots[n - 1] - shift;
        let mut best = (n - 1, room.from_start[n - 1] + rest + shift);
        for index in (0..n - 1).rev() {
            let ratio = self.pivots[index] / safe(self.products[index] + rest);
            room.up[index] = self.lower[index] * ratio;
            rest = rest * ratio - shift;
            let meeting = room.from_start[index] + rest + shift;
            if meeting.abs() < best.1.abs() {
                best = (index, meeting);
            }
        }
        let (place, meeting) = best;
        room.mode[place] = 1.0;
        let mut sum = 1.0;
        for index in (0..place).rev() {
            room.mode[index] = -room.down[index] * room.mode[index + 1];
            sum += room.mode[index] * room.mode[index];
        }
        for index in place..n - 1 {
            room.mode[index + 1] = -room.up[index] * room.mode[index];
            sum += room.mode[index + 1] * room.mode[index + 1];
        }
        let length = sum.sqrt();
        room.mode.iter_mut().for_each(|value| *value /= length);
        meeting / sum
    }
}

/// Memory for one eigenmode.
struct Room {
    from_start: Vec<f64>,
    down: Vec<f64>,
    up: Vec<f64>,
    mode: Vec<f64>,
}

impl Room {
    fn new(len: usize) -> Self {
        let zeros = || vec![0.0; len];
        Self { from_start: zeros(), down: zeros(), up: zeros(), mode: zeros() }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::modes;

    /// Returns K of a chain of unit masses and springs, free or held at both ends.
    fn uniform(n: usize, is_held: bool) -> Vec<(usize, usize, f64)> {
        let mut entries = Vec::new();
        for i in 0..n {
            let is_end = i == 0 || i == n - 1;
            entries.push((i, i, if is_end && !is_held { 1.0 } else { 2.0 }));
            if i + 1 < n {
                entries.extend([(i, i + 1, -1.0), (i + 1, i, -1.0)]);
            }
        }
        entries
    }

    #[test]
    fn masses_on_their_own_have_their_own_modes() {
        let lone = modes(&[2.0, 3.0, 4.0], &[(0, 0, 8.0), (1, 1, 27.0)]).unwrap();
        assert_eq!(lone.eigenvalues, [4.0, 9.0, 0.0]);
        for (mode, mass) in [2.0f64, 3.0, 4.0].into_iter().enumerate() {
            for place in 0..3 {
                let exact = if place == mode { mass.sqrt().recip() } else { 0.0 };
                assert_eq!(lone.shapes[(place, mode)].to_bits(), exact.to_bits());
            }
        }
    }

    #[test]
    fn a_uniform_chain_has_the_modes_of_the_textbook() {
        for n in [2, 3, 10, 150] {
            for is_held in [true, false] {
                let chain = modes(&vec![1.0; n], &uniform(n, is_held)).unwrap();
                let (found, shapes) = (chain.eigenvalues, chain.shapes);
                assert!(chain.mixing < 1e-10, "{n}: {}", chain.mixing);
                for (index, found) in found.iter().enumerate() {
                    let angle = if is_held {
                        PI * (index + 1) as f64 / (n + 1) as f64
                    } else {
                        PI * index as f64 / n as f64
                    };
                    let exact = 4.0 * (0.5 * angle).sin().powi(2);
                    assert!((found - exact).abs() <= 1e-14 * exact, "{n}: {found} is not {exact}");
                    let shape = |i: usize| {
                        if is_held {
                            (angle * (i + 1) as f64).sin()
                        } else {
                            (angle * (i as f64 + 0.5)).cos()
                        }
                    };
                    let length = (0..n).map(|i| shape(i).powi(2)).sum::<f64>().sqrt();
                    let sign = (shapes[(0, index)] * shape(0)).signum();
                    for i in 0..n {
                        let error = (shapes[(i, index)] - sign * shape(i) / length).abs();
                        assert!(error < 1e-11, "{n}, mode {index}, mass {i}: {error}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_slow_mode_of_a_stiff_chain_keeps_its_digits() {
        // Two halves of a rigid body, on a soft spring: w^2 = g/(m + m) (1 + O(g/k)).
        let (k, g) = (1e15, 1.0);
        let entries = [(0, 0, k + g), (0, 1, -k), (1, 0, -k), (1, 1, k)];
        let found = modes(&[1.0, 1.0], &entries).unwrap().eigenvalues;
        // k + g is rounded to a multiple of 1/8.
        assert!((found[0] - 0.5).abs() < 1e-14, "{found:?}");
        assert!((found[1] / (2.0 * k) - 1.0).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn lines_in_any_order_are_found_and_rings_and_stars_are_not() {
        // 1 - 0 - 2 and 3 alone.
        let line = [
            (0, 0, 2.0),
            (1, 1, 1.0),
            (2, 2, 1.0),
            (3, 3, 7.0),
            (0, 1, -1.0),
            (1, 0, -1.0),
            (0, 2, -1.0),
            (2, 0, -1.0),
        ];
        let mut found = modes(&[1.0; 4], &line).unwrap().eigenvalues;
        found.sort_by(f64::total_cmp);
        for (found, exact) in found.iter().zip([0.0, 1.0, 3.0, 7.0]) {
            assert!((found - exact).abs() < 1e-14, "{found} is not {exact}");
        }
        let ring = [
            (0, 0, 2.0),
            (1, 1, 2.0),
            (2, 2, 2.0),
            (0, 1, -1.0),
            (1, 0, -1.0),
            (0, 2, -1.0),
            (2, 0, -1.0),
            (1, 2, -1.0),
            (2, 1, -1.0),
        ];
        assert!(modes(&[1.0; 3], &ring).is_none());
        assert!(modes(&[1.0, -1.0], &uniform(2, true)).is_none());
    }
}
