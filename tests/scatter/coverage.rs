//! Confidence intervals contain the exact value as often as they say.

use std::f64::consts::{LN_2, LN_10, PI, SQRT_2};

use machinist::scatter::{
    Design, Distribution, Estimate, Law, Morris, Saltelli, Sampler, SobolIndices, Summary, Tally,
    normal_quantile,
};

use super::sampled;

type Function = fn(&[f64]) -> f64;

const CONFIDENCE: f64 = 0.95;
/// Number of repetitions with other seeds.
#[derive(Clone, Copy)]
struct Study {
    repeats: u64,
    /// Room for the noise of the share of so many repetitions.
    room: f64,
}

/// The room is that of three standard deviations.
const QUICK: Study = Study { repeats: 1000, room: 0.0207 };
/// The shares have a standard deviation of 0.35 %.
const FULL: Study = Study { repeats: 4000, room: 0.0 };

/// Result of independent uniform variables with its closed forms.
struct Case {
    name: &'static str,
    dimensions: usize,
    f: Function,
    mean: f64,
    deviation: f64,
    median: f64,
    /// Quantiles at 0.9 and 0.95.
    high: f64,
    limit: f64,
}

/// Standard normal quantiles at 0.9 and 0.95.
const SCORES: [f64; 2] = [1.281_551_565_544_600_4, 1.644_853_626_951_472_7];

/// Product of two lognormal variables of mean 1 and deviation 0.2.
fn lognormal(u: &[f64]) -> f64 {
    let factor = Distribution::new(Law::Lognormal { mean: 1.0, deviation: 0.2 });
    let factor = factor.expect("a distribution");
    u.iter().map(|u| factor.quantile(*u)).product()
}

/// Symmetric, skewed and bounded results.
fn cases() -> [Case; 5] {
    let spread = (2.0 * 1.04_f64.ln()).sqrt();
    let of_score = |score: f64| (spread * score - 0.5 * spread * spread).exp();
    let [high, limit] = SCORES;
    [
        Case {
            name: "normal",
            dimensions: 2,
            f: |u| (normal_quantile(u[0]) + 2.0 * normal_quantile(u[1])) / 5_f64.sqrt(),
            mean: 0.0,
            deviation: 1.0,
            median: 0.0,
            high,
            limit,
        },
        Case {
            name: "lognormal",
            dimensions: 2,
            f: lognormal,
            mean: 1.0,
            deviation: (1.04_f64 * 1.04 - 1.0).sqrt(),
            median: of_score(0.0),
            high: of_score(high),
            limit: of_score(limit),
        },
        Case {
            // Half the square of the distance of two normal variables: P(y > x) = exp(-x)
            name: "exponential",
            dimensions: 2,
            f: |u| 0.5 * u.iter().map(|u| normal_quantile(*u).powi(2)).sum::<f64>(),
            mean: 1.0,
            deviation: 1.0,
            median: LN_2,
            high: LN_10,
            limit: 20_f64.ln(),
        },
        Case {
            name: "triangular",
            dimensions: 2,
            f: |u| u[0] + u[1],
            mean: 1.0,
            deviation: 6_f64.sqrt().recip(),
            median: 1.0,
            high: 2.0 - 0.2_f64.sqrt(),
            limit: 2.0 - 0.1_f64.sqrt(),
        },
        Case {
            // Most values are near the bounds: P(y < x) = 1/2 + asin(x)/pi
            name: "sine",
            dimensions: 2,
            f: |u| (2.0 * PI * (u[0] + u[1])).sin(),
            mean: 0.0,
            deviation: SQRT_2.recip(),
            median: 0.0,
            high: (0.4 * PI).sin(),
            limit: (0.45 * PI).sin(),
        },
    ]
}

/// Requires that 93 to 97 of 100 intervals hold their exact values.
fn require<const N: usize>(
    title: &str,
    Study { repeats, room }: Study,
    of: impl Fn(u64) -> [(Estimate, f64); N],
) {
    let mut inside = [0; N];
    for repeat in 0..repeats {
        for (inside, (estimate, exact)) in inside.iter_mut().zip(of(repeat)) {
            *inside += usize::from((estimate.low..=estimate.high).contains(&exact));
        }
    }
    let found = inside.map(|count| count as f64 / repeats as f64);
    println!("{title}: {:.2?}", found.map(|share| 100.0 * share));
    for share in found {
        assert!((0.93 - room..=0.97 + room).contains(&share), "{title}: {found:?}");
    }
}

/// Intervals of mean, deviation, two quantiles and a probability of 5 %.
fn check_values(sampler: Sampler, samples: usize, study: Study) {
    for case in cases() {
        let title = format!("{}, {samples} {} points", case.name, sampler.name());
        require(&title, study, |repeat| {
            let seed = 1000 * samples as u64 + repeat;
            let design = Design { sampler, dimensions: case.dimensions, samples, seed };
            let (values, groups) = sampled(design, case.f);
            let summary = Summary::of(&values, &groups, CONFIDENCE).expect("statistics");
            let hits: Vec<_> = values.iter().map(|value| Some(*value > case.limit)).collect();
            let tally = Tally::of(&hits, &groups, CONFIDENCE).expect("a probability");
            [
                (summary.mean, case.mean),
                (summary.deviation, case.deviation),
                (summary.quantile(0.5), case.median),
                (summary.quantile(0.9), case.high),
                (tally.probability, 0.05),
            ]
        });
    }
}

#[test]
fn intervals_of_random_points_hold_the_exact_value_in_95_of_100_cases() {
    check_values(Sampler::Random, 1024, QUICK);
}

#[test]
fn intervals_of_sobol_points_hold_the_exact_value_in_95_of_100_cases() {
    check_values(Sampler::Sobol, 1024, QUICK);
}

/// Function with its first and total indices.
struct Shares {
    name: &'static str,
    f: Function,
    exact: Vec<[f64; 2]>,
}

fn ishigami(u: &[f64]) -> f64 {
    let x: Vec<f64> = u.iter().map(|u| PI * (2.0 * u - 1.0)).collect();
    x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
}

const G: [f64; 3] = [0.0, 1.0, 9.0];

/// Product of factors with the variances `parts`, each of mean 1.
fn of_product(parts: &[f64]) -> Vec<[f64; 2]> {
    let whole: f64 = parts.iter().map(|part| 1.0 + part).product();
    parts
        .iter()
        .map(|part| [*part, part * whole / (1.0 + part)].map(|v| v / (whole - 1.0)))
        .collect()
}

fn of_sum(parts: &[f64]) -> Vec<[f64; 2]> {
    let whole: f64 = parts.iter().sum();
    parts.iter().map(|part| [part / whole; 2]).collect()
}

fn functions() -> Vec<Shares> {
    // T. Ishigami, T. Homma 1990, with a = 7 and b = 0.1.
    let one = 0.5 * (1.0 + 0.1 * PI.powi(4) / 5.0).powi(2);
    let two = 49.0 / 8.0;
    let both = 0.01 * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0);
    let of_ishigami = [[one, one + both], [two, two], [0.0, both]]
        .map(|pair| pair.map(|part| part / (one + two + both)));
    let g =
        |u: &[f64]| u.iter().zip(G).map(|(u, a)| ((4.0 * u - 2.0).abs() + a) / (1.0 + a)).product();
    vec![
        Shares { name: "Ishigami", f: ishigami, exact: of_ishigami.to_vec() },
        Shares {
            name: "normal",
            f: |u| 10.0 * normal_quantile(u[0]) + 3.0 * normal_quantile(u[1]),
            exact: of_sum(&[100.0, 9.0]),
        },
        Shares {
            name: "lognormal",
            f: |u| (0.4 * normal_quantile(u[0]) + 0.2 * normal_quantile(u[1])).exp(),
            exact: of_product(&[0.16_f64.exp_m1(), 0.04_f64.exp_m1()]),
        },
        Shares {
            name: "bounded",
            f: |u| 3.0 * u[0] + 2.0 * u[1] + u[2],
            exact: of_sum(&[9.0, 4.0, 1.0]),
        },
        Shares {
            name: "g",
            f: g,
            exact: of_product(&G.map(|a| (3.0 * (1.0 + a).powi(2)).recip())),
        },
    ]
}

/// Intervals of first and total indices.
fn check_indices(sampler: Sampler, samples: usize, study: Study) {
    for Shares { name, f, exact } in functions() {
        let title = format!("indices of {name}, {samples} {} rows", sampler.name());
        require(&title, study, |seed| {
            let design = Design { sampler, dimensions: exact.len(), samples, seed };
            let design = Saltelli::new(design).expect("a design");
            let row = |row: usize| design.row(row).iter().map(|point| f(point)).collect();
            let values: Vec<Vec<f64>> = (0..design.rows()).map(row).collect();
            let found = SobolIndices::of(&values, &design.groups(), CONFIDENCE).expect("indices");
            let index = |k: usize| (found.indices[k / 2], exact[k / 2]);
            // The first two parameters, and the last.
            [0, 1, 2, 3, 2 * exact.len() - 2, 2 * exact.len() - 1].map(|k| {
                let (index, exact) = index(k);
                ([index.first, index.total][k % 2], exact[k % 2])
            })
        });
    }
}

#[test]
fn intervals_of_indices_from_random_points_hold_the_exact_ones() {
    check_indices(Sampler::Random, 512, QUICK);
}

#[test]
fn intervals_of_indices_from_sobol_points_hold_the_exact_ones() {
    check_indices(Sampler::Sobol, 512, QUICK);
}

/// Means over the grid of four levels, on which a path crosses two.
fn exact_effect(f: Function) -> f64 {
    let at = |level: usize| (level as f64 + 0.5) / Morris::LEVELS as f64;
    let effects = (0..2).flat_map(|from| {
        (0..4).map(move |other| {
            2.0 * (f(&[at(from + 2), at(other)]) - f(&[at(from), at(other)])).abs()
        })
    });
    effects.sum::<f64>() / 8.0
}

fn check_effects(paths: usize, study: Study) {
    let functions: [(&str, Function); 3] = [
        ("product", |u| u[0] * (1.0 + 2.0 * u[1])),
        ("lognormal", lognormal),
        ("difference", |u| normal_quantile(u[0]) * (2.0 * u[1] - 1.0)),
    ];
    for (name, f) in functions {
        let exact = exact_effect(f);
        require(&format!("mu* of {name}, {paths} paths"), study, |seed| {
            let design = Morris { dimensions: 2, paths, seed };
            let path = |path: usize| design.path(path).iter().map(|point| f(point)).collect();
            let values: Vec<Vec<f64>> = (0..paths).map(path).collect();
            let effect = design.effects(&values, CONFIDENCE).expect("effects")[0];
            let (value, error) = (effect.mean_absolute, effect.error);
            [(Estimate { value, low: value - error, high: value + error }, exact)]
        });
    }
}

#[test]
fn intervals_of_elementary_effects_hold_the_exact_mean() {
    check_effects(20, QUICK);
    check_effects(40, QUICK);
}

#[test]
#[ignore = "takes 20 minutes"]
fn study_of_all_intervals() {
    for sampler in Sampler::ALL {
        for samples in [1024, 4096] {
            check_values(sampler, samples, FULL);
        }
        for samples in [512, 2048] {
            check_indices(sampler, samples, FULL);
        }
    }
    for paths in [20, 40, 80] {
        check_effects(paths, FULL);
    }
}
