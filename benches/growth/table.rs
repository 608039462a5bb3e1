//! Tables of cost over size, with exponents.

/// Costs of a machine of one size.
pub struct Row<const N: usize> {
    pub size: usize,
    pub costs: [f64; N],
}

/// Prints a table in Markdown with the exponents of each column below, over all sizes and over the
/// upper half of them, where fixed costs no longer matter.
pub fn print<const N: usize>(name: &str, size: &str, what: &[&str; N], rows: &[Row<N>]) {
    println!("\n| {name}, {size} | {} |", what.join(" | "));
    println!("| {}--- |", "--- | ".repeat(N));
    for row in rows {
        let costs = row.costs.map(|cost| format!("{cost:.4}"));
        let costs = costs.each_ref().map(|cost| cost.trim_end_matches('0').trim_end_matches('.'));
        println!("| {} | {} |", row.size, costs.join(" | "));
    }
    for (label, rows) in [("all", rows), ("the upper half", &rows[rows.len() / 2..])] {
        let exponents: [String; N] =
            std::array::from_fn(|place| format!("{:.2}", exponent(rows, place)));
        println!("| exponent, {label} | {} |", exponents.join(" | "));
    }
}

/// Returns the slope of a straight line through the logarithms, by least squares.
fn exponent<const N: usize>(rows: &[Row<N>], place: usize) -> f64 {
    let points: Vec<[f64; 2]> =
        rows.iter().map(|row| [(row.size as f64).ln(), row.costs[place].ln()]).collect();
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let products: f64 = points.iter().map(|[a, b]| (a - x) * (b - y)).sum();
    products / points.iter().map(|[a, _]| (a - x).powi(2)).sum::<f64>()
}
