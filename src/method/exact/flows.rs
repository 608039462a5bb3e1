//! Energy flows along a solution, by Gauss's rule on intervals that are halved until both halves
//! agree with the whole.

use super::Solution;
use crate::method::Stretch;
use crate::method::system::FLOWS;
use crate::method::taylor::quadrature::Gauss;

/// Number of points of an interval.
pub(super) const POINTS: usize = 8;
/// Maximum number of halvings.
const DEEPEST: usize = 20;

/// Adds the flows between two times.
pub(super) fn carry(
    stretch: &Stretch<'_>,
    solution: &mut dyn Solution,
    rule: &Gauss,
    [from, until]: [f64; 2],
    totals: &mut [f64],
) {
    let states = stretch.system.states();
    let mut sums = Sums {
        stretch,
        solution,
        rule,
        between: vec![0.0; states],
        tolerance: stretch.atol[states],
    };
    let whole = sums.over(from, until);
    let gained = sums.refined([from, until], whole, 0);
    for (total, gained) in totals.iter_mut().zip(gained) {
        *total += gained;
    }
}

struct Sums<'a> {
    stretch: &'a Stretch<'a>,
    solution: &'a mut dyn Solution,
    rule: &'a Gauss,
    between: Vec<f64>,
    tolerance: f64,
}

impl Sums<'_> {
    fn over(&mut self, from: f64, until: f64) -> [f64; FLOWS] {
        let mut sum = [0.0; FLOWS];
        for (time, weight) in self.rule.points(from, until) {
            self.solution.state_at(time, &mut self.between);
            let rates = self.stretch.flow_rates(time, &self.between);
            sum = std::array::from_fn(|flow| sum[flow] + weight * rates[flow]);
        }
        sum
    }

    fn refined(
        &mut self,
        [from, until]: [f64; 2],
        whole: [f64; FLOWS],
        depth: usize,
    ) -> [f64; FLOWS] {
        let middle = 0.5 * (from + until);
        let halves = [self.over(from, middle), self.over(middle, until)];
        let sum: [f64; FLOWS] = std::array::from_fn(|flow| halves[0][flow] + halves[1][flow]);
        // The last flow is a sum of absolute values with kinks, and only serves as a scale.
        let scale = self.tolerance + self.stretch.rtol * sum[FLOWS - 1];
        let is_settled = (0..FLOWS - 1).all(|flow| (sum[flow] - whole[flow]).abs() <= scale);
        if is_settled || depth == DEEPEST {
            return sum;
        }
        let first = self.refined([from, middle], halves[0], depth + 1);
        let second = self.refined([middle, until], halves[1], depth + 1);
        std::array::from_fn(|flow| first[flow] + second[flow])
    }
}
