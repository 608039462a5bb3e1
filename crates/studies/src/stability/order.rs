//! Observed orders of convergence on the Prothero-Robinson problem.

use serde::Serialize;

use super::machines::PROTHERO_ROBINSON;
use machinist::method::System;
use machinist::method::fixed::{FIXED, Fixed};

/// Values of -lambda, as powers of ten.
pub const POWERS: [i32; 7] = [0, 2, 4, 6, 8, 10, 12];

/// Orders of one implicit method with constant steps.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ObservedOrders {
    /// Name of the method.
    pub method: &'static str,
    /// Its order on smooth problems that are not stiff.
    pub nominal: u32,
    /// Lengths of steps between which the order is measured \[s\].
    pub steps: [f64; 2],
    /// log2 of the ratio of both errors, for lambda = -10^power of [`POWERS`]; `None` where only
    /// rounding is left.
    pub orders: Vec<Option<f64>>,
    /// Errors with the shorter steps: the largest ones at the ends of steps.
    pub errors: Vec<f64>,
}

/// Error below which steps are exact to rounding.
const ROUNDING: f64 = 5e-14;
/// End of the runs \[s\].
const UNTIL: f64 = 3.0;

/// Returns the observed orders of all own implicit methods.
#[must_use]
pub fn observed_orders() -> Vec<ObservedOrders> {
    FIXED.iter().filter(|method| method.is_implicit).map(observed).collect()
}

fn observed(method: &Fixed) -> ObservedOrders {
    // Numbers of steps with errors above rounding for each order.
    let coarse = match method.order {
        0..=5 => 24,
        6..=9 => 4,
        _ => 2,
    };
    let (mut orders, mut errors) = (Vec::new(), Vec::new());
    for power in POWERS {
        let [rough, fine] = [coarse, 2 * coarse].map(|steps| error(method, power, steps));
        orders.push((fine > ROUNDING).then(|| (rough / fine).log2()));
        errors.push(fine);
    }
    let steps = [coarse, 2 * coarse].map(|steps| UNTIL / steps as f64);
    ObservedOrders { method: method.name, nominal: method.order, steps, orders, errors }
}

/// Returns the largest error at the ends of steps.
fn error(method: &Fixed, power: i32, steps: usize) -> f64 {
    let parameters = [-10f64.powi(power)];
    let system = System::new(&PROTHERO_ROBINSON, &parameters, false);
    let mut largest = 0.0f64;
    let done = method.run(&system, &[1.0], (UNTIL, steps), |index, _, end| {
        let time = (index + 1) as f64 * UNTIL / steps as f64;
        largest = largest.max((end[0] - time.cos()).abs());
    });
    if done { largest } else { f64::NAN }
}
