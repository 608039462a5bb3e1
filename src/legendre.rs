//! Legendre polynomials, for the nodes of quadratures.

/// Returns P_n and P_n' at x for |x| < 1; at the ends only P_n is valid.
pub(crate) fn legendre(degree: usize, x: f64) -> [f64; 2] {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=degree {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    [value, degree as f64 * (x * value - before) / (x * x - 1.0)]
}
