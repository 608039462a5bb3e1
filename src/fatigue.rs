//! Rainflow counting of a signal and the damage of its cycles.
//!
//! The turning points of a signal are counted by the rules of ASTM E1049-85 (reapproved 2017):
//! section 5.4.4 counts what is left at the end as half cycles, section 5.4.5 repeats the signal.
//! Each range that a material takes as a closed loop of hysteresis is one cycle, with its range and
//! mean.
//!
//! ```
//! use machinist::fatigue::{Residue, rainflow};
//!
//! // The example of the standard.
//! let cycles = rainflow(&[-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0], 0.0, Residue::Half);
//! let of_range = |range: f64| -> f64 {
//!     cycles.iter().filter(|cycle| cycle.range == range).map(|cycle| cycle.count).sum()
//! };
//! assert_eq!([3.0, 4.0, 6.0, 8.0, 9.0].map(of_range), [0.5, 1.5, 0.5, 1.0, 0.5]);
//! ```

mod damage;

use serde::Serialize;

pub use damage::{Curve, MeanStress, MinerRule, equivalent_amplitude};

/// Treatment of the ranges that close no loop within the signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Residue {
    /// Half cycles, as for a signal that happens once (section 5.4.4).
    Half,
    /// The signal repeats, so that all cycles close (section 5.4.5). The rise from its end to its
    /// beginning counts.
    Repeated,
}

/// A counted cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CountedCycle {
    /// Difference of its turning points, in the unit of the signal.
    pub range: f64,
    /// Mean of its turning points.
    pub mean: f64,
    /// 1 for a cycle, 0.5 for a half cycle.
    pub count: f64,
    /// Samples at its turning points.
    pub samples: [usize; 2],
}

impl CountedCycle {
    fn between(samples: &[f64], [a, b]: [usize; 2], count: f64) -> Self {
        let [x, y] = [samples[a], samples[b]];
        Self { range: (x - y).abs(), mean: 0.5 * x + 0.5 * y, count, samples: [a, b] }
    }

    /// Returns half the range.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        0.5 * self.range
    }
}

/// Returns the indices of peaks and valleys, with both ends. Ranges up to `gate` are left out
/// (hysteresis filter); equal neighbours count once, at the first of them.
#[must_use]
pub fn turning_points(samples: &[f64], gate: f64) -> Vec<usize> {
    if samples.is_empty() {
        return Vec::new();
    }
    // Greatest and least sample since the last turning point; the direction is unknown at first.
    let (mut high, mut low) = (0, 0);
    let mut points = Vec::new();
    let mut is_rising = None;
    for (at, value) in samples.iter().enumerate() {
        if *value > samples[high] {
            high = at;
        }
        if *value < samples[low] {
            low = at;
        }
        if is_rising != Some(true) && value - samples[low] > gate {
            points.push(low);
            (is_rising, high) = (Some(true), at);
        } else if is_rising != Some(false) && samples[high] - value > gate {
            points.push(high);
            (is_rising, low) = (Some(false), at);
        }
        match is_rising {
            Some(true) => low = high,
            Some(false) => high = low,
            None => {}
        }
    }
    points.push(if is_rising == Some(true) { high } else { low });
    points
}

/// Counts the cycles of a signal with finite samples by ASTM E1049-85. Ranges up to `gate`, in the
/// unit of the signal, do not count.
#[must_use]
pub fn rainflow(samples: &[f64], gate: f64, residue: Residue) -> Vec<CountedCycle> {
    let points = turning_points(samples, gate);
    match residue {
        Residue::Half => count(samples, &points),
        Residue::Repeated => count(samples, &repeated(samples, points, gate)),
    }
}

/// Returns the turning points from the greatest absolute one around to itself, without those that
/// are none where the end joins the beginning.
fn repeated(samples: &[f64], points: Vec<usize>, gate: f64) -> Vec<usize> {
    let size = |at: &usize| samples[*at].abs();
    let largest = (0..points.len()).max_by(|a, b| size(&points[*a]).total_cmp(&size(&points[*b])));
    let Some(largest) = largest else { return points };
    let around: Vec<usize> = points[largest..]
        .iter()
        .chain(&points[..largest])
        .chain(&points[largest..=largest])
        .copied()
        .collect();
    let values: Vec<f64> = around.iter().map(|at| samples[*at]).collect();
    turning_points(&values, gate).into_iter().map(|at| around[at]).collect()
}

/// Counts turning points by section 5.4.4, steps 1 to 6.
fn count(samples: &[f64], points: &[usize]) -> Vec<CountedCycle> {
    let range = |[a, b]: [usize; 2]| (samples[a] - samples[b]).abs();
    let mut cycles = Vec::new();
    let mut left: Vec<usize> = Vec::new();
    for point in points {
        left.push(*point);
        while let [.., a, b, c] = left[..] {
            if range([b, c]) < range([a, b]) {
                break;
            }
            // The first of all points left is the start.
            if left.len() == 3 {
                cycles.push(CountedCycle::between(samples, [a, b], 0.5));
                left.remove(0);
            } else {
                cycles.push(CountedCycle::between(samples, [a, b], 1.0));
                left.drain(left.len() - 3..left.len() - 1);
            }
        }
    }
    let halves =
        left.windows(2).map(|pair| CountedCycle::between(samples, [pair[0], pair[1]], 0.5));
    cycles.extend(halves);
    cycles
}

#[cfg(test)]
mod tests {
    use super::*;

    /// History of figure 6 of the standard.
    const HISTORY: [f64; 9] = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];

    fn counted(cycles: &[CountedCycle]) -> Vec<(f64, f64)> {
        let mut found: Vec<(f64, f64)> = Vec::new();
        for cycle in cycles {
            match found.iter_mut().find(|(range, _)| range.to_bits() == cycle.range.to_bits()) {
                Some((_, count)) => *count += cycle.count,
                None => found.push((cycle.range, cycle.count)),
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found
    }

    #[test]
    fn the_example_of_the_standard_is_counted_as_printed() {
        let once = rainflow(&HISTORY, 0.0, Residue::Half);
        assert_eq!(counted(&once), [(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)]);
        // Section 5.4.5, figure 7.
        let repeated = rainflow(&HISTORY, 0.0, Residue::Repeated);
        let halves = counted(&repeated);
        assert_eq!(halves, [(3.0, 1.0), (4.0, 1.0), (7.0, 1.0), (9.0, 1.0)]);
        let means: Vec<(f64, f64)> = once.iter().map(|cycle| (cycle.range, cycle.mean)).collect();
        // Figure 6: A to B, B to C, E to F, C to D, D to G, G to H, H to I.
        let printed =
            [(3.0, -0.5), (4.0, -1.0), (4.0, 1.0), (8.0, 1.0), (9.0, 0.5), (8.0, 0.0), (6.0, 1.0)];
        assert_eq!(means, printed);
    }

    /// A wave has one range; a signal that adds a small wave of a higher frequency has one cycle of
    /// each small loop and one large one.
    #[test]
    fn samples_between_turning_points_do_not_count() {
        let wave = |n: usize| (0.01 * n as f64 * std::f64::consts::TAU).cos();
        let samples: Vec<f64> = (0..=1000).map(wave).collect();
        let cycles = rainflow(&samples, 1e-9, Residue::Repeated);
        let count = |cycles: &[CountedCycle]| cycles.iter().map(|cycle| cycle.count).sum::<f64>();
        assert!((count(&cycles) - 10.0).abs() < 1e-12);
        assert!(cycles.iter().all(|cycle| (cycle.range - 2.0).abs() < 1e-12), "{cycles:?}");
        let once = rainflow(&samples, 1e-9, Residue::Half);
        assert!((count(&once) - 10.0).abs() < 1e-12);
    }

    /// Loops by their definition: a cycle of range r closes where the signal, after leaving a
    /// turning point by less than the excursions around it, comes back past it. Counted here by
    /// removing the smallest inner range again and again (four-point rule).
    #[test]
    fn random_signals_have_the_cycles_of_the_four_point_rule() {
        let mut seed = 7_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / f64::from(1 << 24)
        };
        for length in [1, 2, 3, 5, 10, 100, 1000] {
            for _ in 0..30 {
                let samples: Vec<f64> = (0..length).map(|_| draw()).collect();
                let found = rainflow(&samples, 0.0, Residue::Repeated);
                let mut found: Vec<f64> =
                    found.iter().flat_map(|c| vec![c.range; (2.0 * c.count) as usize]).collect();
                let mut wanted = of_four_points(&samples);
                found.sort_by(f64::total_cmp);
                wanted.sort_by(f64::total_cmp);
                assert_eq!(found, wanted, "{samples:?}");
            }
        }
    }

    /// Each range of the loops of a repeated signal, twice.
    fn of_four_points(samples: &[f64]) -> Vec<f64> {
        let highest = (0..samples.len()).max_by(|a, b| samples[*a].total_cmp(&samples[*b]));
        let Some(highest) = highest else { return Vec::new() };
        let mut ring: Vec<f64> = [&samples[highest..], &samples[..=highest]].concat();
        let mut ranges = Vec::new();
        // Points that are no turning points.
        let mut at = 1;
        while at + 1 < ring.len() {
            if (ring[at] - ring[at - 1]) * (ring[at + 1] - ring[at]) >= 0.0 {
                ring.remove(at);
                at = at.max(2) - 1;
            } else {
                at += 1;
            }
        }
        loop {
            let inner = (0..ring.len().saturating_sub(3)).find(|at| {
                let range = |k: usize| (ring[at + k] - ring[at + k + 1]).abs();
                range(1) <= range(0) && range(1) <= range(2)
            });
            let Some(at) = inner else { break };
            ranges.extend([(ring[at + 1] - ring[at + 2]).abs(); 2]);
            ring.drain(at + 1..at + 3);
        }
        ranges.extend(ring.windows(2).map(|pair| (pair[0] - pair[1]).abs()));
        ranges.retain(|range| *range > 0.0);
        ranges
    }

    #[test]
    fn the_gate_leaves_out_small_ranges_and_keeps_the_large_ones() {
        let samples = [0.0, 10.0, 9.5, 12.0, 3.0, 3.4, 3.1, -1.0, 0.0];
        let points: Vec<f64> =
            turning_points(&samples, 1.0).iter().map(|at| samples[*at]).collect();
        assert_eq!(points, [0.0, 12.0, -1.0]);
        assert_eq!(turning_points(&[1.0, 1.0, 1.0], 0.0), [0]);
        assert!(turning_points(&[], 0.0).is_empty());
    }
}
