//! Confidence intervals contain the exact value as often as they say.

use std::f64::consts::PI;

use machinist::scatter::{
    Design, Distribution, Estimate, Law, Morris, Saltelli, Sampler, SobolIndices, Summary, Tally,
    normal_quantile,
};

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

/// Returns the shares of repetitions in which the intervals of first and total indices hold the
/// exact ones.
fn coverage_of_indices(
    (sampler, samples, repeats): (Sampler, usize, u64),
    f: impl Fn(&[f64]) -> f64,
    exact: &[[f64; 2]],
) -> Vec<[f64; 2]> {
    let mut inside = vec![[0; 2]; exact.len()];
    for seed in 0..repeats {
        let design = Design { sampler, dimensions: exact.len(), samples, seed };
        let design = Saltelli::new(design).expect("a design");
        let row = |row: usize| design.row(row).iter().map(|point| f(point)).collect();
        let values: Vec<Vec<f64>> = (0..design.rows()).map(row).collect();
        let found = SobolIndices::of(&values, &design.groups(), 0.95).expect("indices");
        for ((inside, index), exact) in inside.iter_mut().zip(&found.indices).zip(exact) {
            for ((inside, estimate), exact) in
                inside.iter_mut().zip([index.first, index.total]).zip(exact)
            {
                *inside += usize::from((estimate.low..=estimate.high).contains(exact));
            }
        }
    }
    inside.iter().map(|pair| pair.map(|count| count as f64 / repeats as f64)).collect()
}

#[test]
fn intervals_of_indices_hold_the_exact_ones() {
    // T. Ishigami, T. Homma 1990, with a = 7 and b = 0.1.
    let ishigami = |u: &[f64]| {
        let x: Vec<f64> = u.iter().map(|u| PI * (2.0 * u - 1.0)).collect();
        x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
    };
    let one = 0.5 * (1.0 + 0.1 * PI.powi(4) / 5.0).powi(2);
    let two = 49.0 / 8.0;
    let both = 0.01 * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0);
    let whole = one + two + both;
    let exact_of_ishigami =
        [[one, one + both], [two, two], [0.0, both]].map(|pair| pair.map(|part| part / whole));
    let linear = |u: &[f64]| 3.0 * normal_quantile(u[0]) + normal_quantile(u[1]);
    let exact_of_linear = [[0.9, 0.9], [0.1, 0.1]];
    // Resampling takes time; the share of 200 cases has a standard deviation of 1.5 %.
    let cases = [(Sampler::Random, 512, 200, 0.031), (Sampler::Sobol, 1024, 1000, 0.02)];
    for (sampler, samples, repeats, room) in cases {
        let settings = (sampler, samples, repeats);
        for found in [
            coverage_of_indices(settings, ishigami, &exact_of_ishigami),
            coverage_of_indices(settings, linear, &exact_of_linear),
        ] {
            println!("{}: {found:?}", sampler.name());
            for share in found.as_flattened() {
                assert!((share - 0.95).abs() <= room, "{}: {found:?}", sampler.name());
            }
        }
    }
}

/// Effects of u_1 (1 + 2 u_2) on a grid of four levels: 1 + 2 u_2, with mean 2.
#[test]
fn intervals_of_elementary_effects_hold_the_exact_mean() {
    let repeats = 1000;
    let mut inside = 0;
    for seed in 0..repeats {
        let design = Morris { dimensions: 2, paths: 40, seed };
        let f = |u: &Vec<f64>| u[0] * (1.0 + 2.0 * u[1]);
        let values: Vec<Vec<f64>> =
            (0..40).map(|path| design.path(path).iter().map(f).collect()).collect();
        let effects = design.effects(&values, 0.95).expect("effects");
        inside += usize::from((effects[0].mean_absolute - 2.0).abs() <= effects[0].error);
    }
    let share = inside as f64 / repeats as f64;
    assert!((0.93..=0.97).contains(&share), "{share}");
}
