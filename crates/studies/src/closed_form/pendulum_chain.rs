//! Three point masses hanging on one another by massless links, written by hand.
//!
//! With absolute angles th from the vertical and m_ij the mass at and below the lower
//! of links i and j,
//!
//! ```text
//! sum_j m_ij l_j (cos(th_i - th_j) th_j'' + sin(th_i - th_j) th_j'^2) + m_ii g sin th_i = 0
//! ```
//!
//! from the balance of forces across link i on all that hangs from it. Its equation
//! times l_i is Lagrange's.
//!
//! Source: textbook.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Masses and links, from the top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PendulumChain {
    /// Masses \[kg\], positive.
    pub masses: [f64; 3],
    /// Lengths of the links \[m\], positive.
    pub lengths: [f64; 3],
    /// Acceleration of free fall \[m/s^2\].
    pub gravity: f64,
}

/// The chain of the scene `pendulum_chain`.
pub const CHAIN: PendulumChain =
    PendulumChain { masses: [1.0, 0.8, 0.5], lengths: [1.0, 0.7, 0.4], gravity: 9.81 };

impl PendulumChain {
    /// Angular accelerations \[rad/s^2\] at angles \[rad\] and speeds \[rad/s\].
    ///
    /// NaN if a mass or a length is zero.
    #[must_use]
    pub fn accelerations(&self, angles: [f64; 3], speeds: [f64; 3]) -> [f64; 3] {
        let weighed = |i: usize, j: usize| self.mass_below(i.max(j)) * self.lengths[j];
        let inertia = Matrix3::from_fn(|i, j| weighed(i, j) * (angles[i] - angles[j]).cos());
        let pull = Vector3::from_fn(|i, _| {
            let turning: f64 = (0..3)
                .map(|j| weighed(i, j) * (angles[i] - angles[j]).sin() * speeds[j] * speeds[j])
                .sum();
            -turning - self.mass_below(i) * self.gravity * angles[i].sin()
        });
        let solution = inertia.lu().solve(&pull);
        solution.map_or([f64::NAN; 3], Into::into)
    }

    /// Frequencies \[rad/s\] of small oscillations, ascending: with M_ij = m_ij l_i l_j and
    /// K_i = m_ii g l_i, 1/w^2 are the eigenvalues of K^-1/2 M K^-1/2.
    #[must_use]
    pub fn frequencies(&self) -> [f64; 3] {
        let stiffness = |i: usize| self.mass_below(i) * self.gravity * self.lengths[i];
        let mass =
            |i: usize, j: usize| self.mass_below(i.max(j)) * self.lengths[i] * self.lengths[j];
        let weighed = Matrix3::from_fn(|i, j| mass(i, j) / (stiffness(i) * stiffness(j)).sqrt());
        let squares = SymmetricEigen::new(weighed).eigenvalues;
        let mut frequencies = [0, 1, 2].map(|index| 1.0 / squares[index].sqrt());
        frequencies.sort_by(f64::total_cmp);
        frequencies
    }

    fn mass_below(&self, link: usize) -> f64 {
        self.masses[link..].iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_in_line_swings_in_its_known_modes() {
        // Three equal links and masses: w^2 l/g are the roots of x^3 - 9 x^2 + 18 x - 6.
        let equal = PendulumChain { masses: [1.0; 3], lengths: [1.0; 3], gravity: 1.0 };
        let column = |j: usize| {
            let mut angles = [0.0; 3];
            angles[j] = 1e-6;
            equal.accelerations(angles, [0.0; 3]).map(|acceleration| -acceleration / 1e-6)
        };
        let columns = [column(0), column(1), column(2)];
        let matrix = Matrix3::from_fn(|i, j| columns[j][i]);
        let minors = (matrix.trace().powi(2) - (matrix * matrix).trace()) / 2.0;
        assert!((matrix.trace() - 9.0).abs() < 1e-9);
        assert!((minors - 18.0).abs() < 1e-8);
        assert!((matrix.determinant() - 6.0).abs() < 1e-8);
    }

    #[test]
    fn frequencies_are_those_of_the_equal_chain() {
        let equal = PendulumChain { masses: [1.0; 3], lengths: [1.0; 3], gravity: 1.0 };
        for frequency in equal.frequencies() {
            let square = frequency * frequency;
            let left = ((square - 9.0) * square + 18.0) * square - 6.0;
            assert!(left.abs() < 1e-12, "{frequency}");
        }
    }

    #[test]
    fn a_chain_whirled_straight_is_a_rigid_one() {
        // Level, at rest: the top link's mass point falls freely, all links alike.
        let level = [std::f64::consts::FRAC_PI_2; 3];
        let [first, second, third] = CHAIN.accelerations(level, [2.0; 3]);
        assert!((first + 9.81).abs() < 1e-12);
        assert!(second.abs() < 1e-11 && third.abs() < 1e-11);
    }
}
