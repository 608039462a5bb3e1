//! Confidence intervals contain the exact value as often as they say.

use machinist::scatter::{Design, Distribution, Estimate, Law, Sampler, Summary, Tally};

use super::sampled;

/// Number of repetitions with other seeds.
const REPEATS: usize = 1000;

/// Share of repetitions in which each of four intervals holds its exact value: mean, standard
/// deviation, quantile, probability.
fn coverage(sampler: Sampler, samples: usize) -> [f64; 4] {
    // A product of lognormal variables is lognormal.
    let (mean, deviation) = (1.0, 0.2);
    let factor = Distribution::new(Law::Lognormal { mean, deviation }).expect("a distribution");
    let variance = 2.0 * 1.04_f64.ln();
    let median = (-0.5 * variance).exp();
    let quantile_score = 1.281_551_565_544_600_4;
    let exact_quantile = median * (variance.sqrt() * quantile_score).exp();
    // P(product > limit) = 0.05
    let limit = median * (variance.sqrt() * 1.644_853_626_951_472_7).exp();
    let exact_deviation = (1.04_f64 * 1.04 - 1.0).sqrt();
    let mut inside = [0; 4];
    for repeat in 0..REPEATS {
        let seed = 1000 * samples as u64 + repeat as u64;
        let design = Design { sampler, dimensions: 2, samples, seed };
        let (values, groups) = sampled(design, |u| u.iter().map(|u| factor.quantile(*u)).product());
        let summary = Summary::of(&values, &groups, 0.95).expect("statistics");
        let hits: Vec<_> = values.iter().map(|value| Some(*value > limit)).collect();
        let tally = Tally::of(&hits, &groups, 0.95).expect("a probability");
        let holds = |estimate: Estimate, exact: f64| {
            usize::from(estimate.low <= exact && exact <= estimate.high)
        };
        inside[0] += holds(summary.mean, 1.0);
        inside[1] += holds(summary.deviation, exact_deviation);
        inside[2] += holds(summary.quantile(0.9), exact_quantile);
        inside[3] += holds(tally.probability, 0.05);
    }
    inside.map(|count| count as f64 / REPEATS as f64)
}

fn check(sampler: Sampler, samples: usize) {
    let found = coverage(sampler, samples);
    println!("{}, {samples}: {found:?}", sampler.name());
    for (share, name) in found.iter().zip(["mean", "deviation", "quantile", "probability"]) {
        assert!((0.93..=0.97).contains(share), "{} {name}: {share}", sampler.name());
    }
}

#[test]
fn intervals_of_random_points_hold_the_exact_value_in_95_of_100_cases() {
    check(Sampler::Random, 2048);
}

#[test]
fn intervals_of_sobol_points_hold_the_exact_value_in_95_of_100_cases() {
    check(Sampler::Sobol, 2048);
}
