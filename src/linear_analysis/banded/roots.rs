//! All eigenvalues of a part: zeros of det T(s), found simultaneously.
//!
//! Uses the Ehrlich-Aberth iteration: Newton's method on det T divided by the contributions of the
//! other zeros. It starts from the eigenvalues of both halves without their coupling, and these
//! likewise, down to halves small enough for a dense matrix. An evaluation costs as much as the
//! band has entries, so all eigenvalues of n bodies take n^2 operations and the memory of the band.
//!
//! Source: Bini, Gemignani, Tisseur, "The Ehrlich-Aberth method for the nonsymmetric tridiagonal
//! eigenvalue problem", SIAM J. Matrix Anal. Appl. 27 (2005).

use std::ops::Range;

use nalgebra::linalg::Schur;
use num_complex::Complex64;

use super::pencil::Pencil;
use crate::dense::balance;
use crate::sorting::{sort_ascending, sort_descending};

/// Number of rows up to which a dense matrix is as good.
const SMALL: usize = 16;
/// Number of iterations after which zeros that do not settle are exchanged for ones of the other
/// kind, and maximum number of such exchanges.
const PATIENCE: usize = 20;
const EXCHANGES: usize = 4;
/// Relative corrections at which a zero has settled, for the whole and for halves, which only
/// provide start values.
const SETTLED: f64 = 1e-15;
const NEARLY: f64 = 1e-5;
/// Limit of corrections that no longer decrease and count as rounding, relative to the squared
/// ratio of the fastest zero to this one: T(s) is a difference of numbers of that size.
const ROUNDING: f64 = 1e-13;
/// Minimum distance from 0 after a step, relative to that before: a zero that passes 0 would not
/// return.
const NEAREST: f64 = 0.1;
/// Distance from the previous zero, relative to that from the next, below which a zero is moved
/// away.
const TOGETHER: f64 = 0.1;

/// A zero, or a conjugate pair if the imaginary part is positive.
#[derive(Clone, Copy)]
struct Root {
    value: Complex64,
    is_pair: bool,
    is_settled: bool,
    /// Absolute value of the last correction.
    correction: f64,
}

impl Root {
    fn at(value: Complex64, is_pair: bool) -> Self {
        Self { value, is_pair, is_settled: false, correction: f64::INFINITY }
    }

    fn count(&self) -> usize {
        1 + usize::from(self.is_pair)
    }

    /// Returns the sum of 1/(s - zero); for a pair a + b i this is 2 d/(d^2 + b^2) with d = s - a,
    /// in a form without cancellation near it.
    #[inline]
    fn contribution(&self, s: Complex64) -> Complex64 {
        let distance = s - self.value;
        if !self.is_pair {
            return distance.inv();
        }
        let d = Complex64::new(distance.re, s.im);
        let product =
            Complex64::new(d.re * d.re - distance.im * (s.im + self.value.im), 2.0 * d.re * d.im);
        d * product.conj() * (2.0 / product.norm_sqr())
    }
}

/// Returns eigenvalues with nonnegative imaginary part, except `zeros` ones that are zero. Returns
/// `None` if they are not found one by one, for example if some are double.
pub(super) fn eigenvalues(pencil: &Pencil, zeros: usize) -> Option<Vec<Complex64>> {
    let fastest = pencil.fastest();
    let search = Search { pencil, rows: 0..pencil.size(), zeros, tolerance: SETTLED, fastest };
    let mut roots = search.starts()?;
    for _ in 0..=EXCHANGES {
        if search.settle(&mut roots) {
            return Some(roots.into_iter().map(|root| root.value).collect());
        }
        exchange_kinds(&mut roots);
    }
    None
}

/// Search for the zeros of some rows, decoupled from others.
struct Search<'p> {
    pencil: &'p Pencil,
    rows: Range<usize>,
    /// Number of zeros at 0, which are not searched for.
    zeros: usize,
    tolerance: f64,
    /// Approximate absolute value of the largest zero.
    fastest: f64,
}

impl Search<'_> {
    /// Returns start values: the zeros of both halves, corrected to the number of zeros.
    fn starts(&self) -> Option<Vec<Root>> {
        let middle = usize::midpoint(self.rows.start, self.rows.end);
        let mut roots = if self.rows.len() <= SMALL {
            self.of_full_matrix()?
        } else {
            let half = |rows| Search { rows, zeros: 0, tolerance: NEARLY, ..*self };
            let halves = [half(self.rows.start..middle), half(middle..self.rows.end)];
            let [mut roots, others] = [halves[0].nearly()?, halves[1].nearly()?];
            roots.extend(others);
            roots
        };
        sort_descending(&mut roots, |root| root.value.norm());
        let degree = self.pencil.degree(self.rows.clone()).checked_sub(self.zeros)?;
        let mut count: usize = roots.iter().map(Root::count).sum();
        while count > degree {
            let last = roots.pop()?;
            count -= last.count();
            if count < degree {
                roots.push(Root::at(Complex64::from(-last.value.norm()), false));
                count += 1;
            }
        }
        part(&mut roots);
        (count == degree).then_some(roots)
    }

    /// Returns the zeros as far as they converge.
    fn nearly(&self) -> Option<Vec<Root>> {
        if self.rows.len() <= SMALL {
            return self.of_full_matrix();
        }
        let mut roots = self.starts()?;
        self.settle(&mut roots);
        Some(roots.iter().map(|root| Root::at(root.value, root.is_pair)).collect())
    }

    fn of_full_matrix(&self) -> Option<Vec<Root>> {
        let mut matrix = self.pencil.companion(self.rows.clone());
        balance(&mut matrix);
        let values = Schur::try_new(matrix, f64::EPSILON, 10_000)?.complex_eigenvalues();
        let upper = values.iter().filter(|value| value.im >= 0.0);
        Some(upper.map(|value| Root::at(*value, value.im > 0.0)).collect())
    }

    /// Iterates until zeros settle; returns whether all of them do.
    fn settle(&self, roots: &mut [Root]) -> bool {
        (0..PATIENCE).any(|_| {
            for index in 0..roots.len() {
                if !roots[index].is_settled {
                    self.improve(roots, index);
                }
            }
            roots.iter().all(|root| root.is_settled)
        })
    }

    /// Makes a step of one zero: 1/(p'/p - sum of 1/(s - others)).
    fn improve(&self, roots: &mut [Root], index: usize) {
        let Root { value: s, is_pair, correction: before, .. } = roots[index];
        let Some(slope) = self.pencil.logarithmic_slope(self.rows.clone(), s) else {
            roots[index].is_settled = true;
            return;
        };
        let mut others = Complex64::ZERO;
        if self.zeros > 0 {
            others += s.inv() * self.zeros as f64;
        }
        let (before_it, from_it) = roots.split_at(index);
        for other in before_it.iter().chain(&from_it[1..]) {
            others += other.contribution(s);
        }
        if is_pair {
            others += (s - s.conj()).inv();
        }
        let step = (slope - others).inv();
        if !step.is_finite() {
            return;
        }
        let (size, correction) = (s.norm(), step.norm());
        let rounding = ROUNDING * self.fastest.max(size).powi(2) / size;
        let mut next = s - step;
        if next.norm() < NEAREST * size {
            let direction = if next == Complex64::ZERO { s } else { next };
            next = direction * (NEAREST * size / direction.norm());
        }
        let root = &mut roots[index];
        root.value =
            if is_pair { Complex64::new(next.re, next.im.abs()) } else { Complex64::from(next.re) };
        root.correction = correction;
        root.is_settled = correction <= self.tolerance * size
            || (correction <= rounding && correction >= before / 2.0);
    }
}

/// Separates zeros that coincide because both halves are alike.
fn part(roots: &mut [Root]) {
    let distance = |a: &Root, b: &Root| (a.value - b.value).norm();
    for index in 1..roots.len() {
        let (before, root) = (roots[index - 1], roots[index]);
        let next = roots.get(index + 1);
        let room = next.map_or(f64::INFINITY, |next| distance(next, &root));
        if distance(&before, &root) >= TOGETHER * room.min(root.value.norm()) {
            continue;
        }
        let step = match next {
            Some(next) => (next.value - root.value) * 0.25,
            None => root.value * -0.01,
        };
        roots[index].value += if root.is_pair { step } else { Complex64::from(step.re) };
    }
}

/// Replaces pairs that do not settle by two neighbouring real zeros, and two such real zeros by a
/// pair.
fn exchange_kinds(roots: &mut Vec<Root>) {
    let (mut changed, mut reals) = (Vec::new(), Vec::new());
    roots.retain(|root| {
        match (root.is_settled, root.is_pair) {
            (true, _) => return true,
            (false, true) => changed.extend([-1.0, 1.0].map(|side| {
                let apart = (0.05 * root.value.re.abs()).max(root.value.im);
                Root::at(Complex64::from(root.value.re + side * apart), false)
            })),
            (false, false) => reals.push(*root),
        }
        false
    });
    sort_ascending(&mut reals, |root| root.value.re);
    for two in reals.chunks(2) {
        match two {
            [a, b] => {
                let middle = f64::midpoint(a.value.re, b.value.re);
                let apart = (0.05 * middle.abs()).max((b.value.re - a.value.re) / 2.0);
                changed.push(Root::at(Complex64::new(middle, apart), true));
            }
            alone => changed.extend_from_slice(alone),
        }
    }
    roots.extend(changed);
}
