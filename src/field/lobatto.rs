//! Gauss-Lobatto points of the unit interval, with weights and slopes of the shape functions.
//!
//! Source: Canuto, Hussaini, Quarteroni, Zang, "Spectral methods: fundamentals in
//! single domains", 2006, section 2.3.1.

use machinist_contract::field::Rule;

use crate::legendre::legendre;

/// A [`Rule`] that owns its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Lobatto {
    points: Vec<f64>,
    weights: Vec<f64>,
    slopes: Vec<f64>,
}

impl Lobatto {
    /// Creates the rule of p + 1 points, p at least 1.
    ///
    /// On \[-1, 1\] the inner points are the zeros of P_p', the weights are
    /// 2/(p (p + 1) P_p^2), and l_j'(x_i) = P_p(x_i)/(P_p(x_j) (x_i - x_j)).
    #[must_use]
    pub fn new(order: usize) -> Self {
        let x: Vec<f64> = (0..=order).map(|index| point(order, index)).collect();
        let values: Vec<f64> = x.iter().map(|x| legendre(order, *x)[0]).collect();
        let p = order as f64;
        let weight = |value: &f64| 1.0 / (p * (p + 1.0) * value * value);
        let mut slopes = Vec::with_capacity(x.len() * x.len());
        for (i, (x_i, value_i)) in x.iter().zip(&values).enumerate() {
            let row = x.iter().zip(&values).enumerate();
            let mut row: Vec<f64> = row
                .map(
                    |(j, (x_j, value_j))| {
                        if i == j { 0.0 } else { 2.0 * value_i / (value_j * (x_i - x_j)) }
                    },
                )
                .collect();
            // The slope of a constant is zero to the last bit.
            row[i] = -row.iter().sum::<f64>();
            slopes.extend(row);
        }
        Self {
            points: x.iter().map(|x| f64::midpoint(1.0, *x)).collect(),
            weights: values.iter().map(weight).collect(),
            slopes,
        }
    }

    /// Returns the integrals of l_i' l_j' over the unit interval, row by row.
    #[must_use]
    pub(super) fn stiffness(&self) -> Vec<f64> {
        let len = self.points.len();
        let slopes = |node: usize| self.slopes[node..].iter().step_by(len);
        let integral = |i: usize, j: usize| -> f64 {
            let products = slopes(i).zip(slopes(j)).zip(&self.weights);
            products.map(|((a, b), weight)| weight * a * b).sum()
        };
        (0..len * len).map(|entry| integral(entry / len, entry % len)).collect()
    }

    /// Returns the rule in the form of the contract.
    #[must_use]
    pub fn rule(&self) -> Rule<'_> {
        Rule { points: &self.points, weights: &self.weights, slopes: &self.slopes }
    }
}

/// Returns the `index`-th point on \[-1, 1\], by Newton's iteration from a cosine.
fn point(order: usize, index: usize) -> f64 {
    match index {
        0 => return -1.0,
        _ if index == order => return 1.0,
        _ if 2 * index == order => return 0.0,
        _ => {}
    }
    let p = order as f64;
    let mut x = -(std::f64::consts::PI * index as f64 / p).cos();
    for _ in 0..50 {
        let [value, slope] = legendre(order, x);
        // (1 - x^2) P'' = 2 x P' - p (p + 1) P
        let bend = (2.0 * x * slope - p * (p + 1.0) * value) / (1.0 - x * x);
        let step = slope / bend;
        x -= step;
        if step.abs() < 1e-16 {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::Lobatto;

    #[test]
    fn rules_integrate_polynomials_to_twice_their_order_less_one() {
        for order in 1..=16 {
            let lobatto = Lobatto::new(order);
            let rule = lobatto.rule();
            for power in 0..2 * order as i32 {
                let terms = rule.points.iter().zip(rule.weights);
                let sum: f64 = terms.map(|(x, weight)| weight * x.powi(power)).sum();
                let exact = 1.0 / f64::from(power + 1);
                assert!((sum - exact).abs() < 1e-14, "order {order}, x^{power}: {sum}");
            }
        }
    }

    #[test]
    fn slopes_differentiate_polynomials_of_their_order_and_find_none_of_a_constant() {
        for order in 1..=16 {
            let lobatto = Lobatto::new(order);
            let rule = lobatto.rule();
            for power in 0..=order as i32 {
                for (x, row) in rule.points.iter().zip(rule.slopes.chunks_exact(rule.len())) {
                    let values = rule.points.iter().map(|x| x.powi(power));
                    let slope: f64 =
                        row.iter().zip(values).map(|(slope, value)| slope * value).sum();
                    let exact = f64::from(power) * x.powi((power - 1).max(0));
                    assert!(
                        (slope - exact).abs() < 1e-12,
                        "order {order}, x^{power} at {x}: {slope}"
                    );
                }
            }
        }
    }
}
