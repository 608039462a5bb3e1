//! Scatter: points, distributions, estimates with their confidence, and sensitivity indices,
//! against closed forms and scipy.

mod coverage;

use machinist::improve::{Expression, gradient};
use machinist::scatter::{
    Correlation, Design, Distribution, Groups, Law, Morris, REPLICATES, Saltelli, Sampler,
    ScatterError, ScrambledSobol, Sobol, SobolIndices, Summary, normal_cdf, normal_quantile,
    propagate, value_over,
};
use machinist::{Method, Simulation, Sweep};
use machinist_scenes::scenes::bouncing_mass::BouncingMass;
use machinist_scenes::scenes::two_mass::TwoMass;
use nalgebra::DMatrix;

/// Returns the values of a function at the points of a design.
pub fn sampled(design: Design, f: impl Fn(&[f64]) -> f64) -> (Vec<f64>, Groups) {
    let points = design.points().expect("points");
    ((0..points.len()).map(|index| f(&points.get(index))).collect(), points.groups())
}

/// The reference is `qmc.Sobol(512, scramble=False, bits=32).random(1001)*2**32` of scipy 1.17.
#[test]
fn sobol_points_are_those_of_scipy() {
    let sobol = Sobol::new(512).expect("512 dimensions");
    let dimensions = [0, 1, 2, 9, 99, 511];
    for (index, digits) in [
        (1, [2_147_483_648; 6]),
        (
            2,
            [
                3_221_225_472,
                1_073_741_824,
                1_073_741_824,
                3_221_225_472,
                3_221_225_472,
                3_221_225_472,
            ],
        ),
        (
            3,
            [
                1_073_741_824,
                3_221_225_472,
                3_221_225_472,
                1_073_741_824,
                1_073_741_824,
                1_073_741_824,
            ],
        ),
        (
            17,
            [
                2_550_136_832,
                4_160_749_568,
                4_160_749_568,
                2_818_572_288,
                2_281_701_376,
                1_476_395_008,
            ],
        ),
        (1000, [943_718_400, 415_236_096, 2_227_175_424, 297_795_584, 801_112_064, 1_698_693_120]),
    ] {
        let found = dimensions.map(|dimension| sobol.digits(index, dimension));
        assert_eq!(found, digits, "point {index}");
    }
    assert_eq!(Sobol::new(513).expect_err("too many"), ScatterError::Dimensions(513));
}

#[test]
fn scrambled_points_stay_a_net_and_are_uniform_over_scramblings() {
    const COUNT: u32 = 1024;
    let points = ScrambledSobol::new(Sobol::new(2).expect("2 dimensions"), 7);
    // Every elementary interval of area 1/1024 holds one of the first 1024 points in two
    // dimensions.
    for split in 0..=10 {
        let (columns, rows) = (f64::from(1 << split), f64::from(1 << (10 - split)));
        let mut hits = vec![0; COUNT as usize];
        for index in 0..COUNT {
            let [x, y] = [0, 1].map(|dimension| points.coordinate(index, dimension));
            hits[((x * columns).floor() * rows + (y * rows).floor()) as usize] += 1;
        }
        assert!(hits.iter().all(|count| *count == 1), "split {split}");
    }
    // The mean of one coordinate of one point over scramblings is 1/2 within 4 deviations.
    let seeds = 4000;
    let of = |seed: u64| {
        ScrambledSobol::new(Sobol::new(3).expect("3 dimensions"), seed).coordinate(5, 2)
    };
    let mean = (0..seeds).map(of).sum::<f64>() / seeds as f64;
    let deviation = (1.0 / 12.0 / seeds as f64).sqrt();
    assert!((mean - 0.5).abs() < 4.0 * deviation, "{mean}");
}

/// Root mean square error of a mean over independent replicates, for two numbers of samples.
fn error_of_mean(sampler: Sampler, samples: usize) -> f64 {
    let square = |seed: u64| {
        let design = Design { sampler, dimensions: 3, samples, seed };
        let product = |u: &[f64]| u.iter().map(|u| 1.0 + 0.5 * (u * u * u - 0.25)).product();
        let (values, _) = sampled(design, product);
        (values.iter().sum::<f64>() / values.len() as f64 - 1.0).powi(2)
    };
    ((0..40).map(square).sum::<f64>() / 40.0).sqrt()
}

#[test]
fn scrambled_sobol_points_converge_much_faster_than_random_ones() {
    let order = |sampler: Sampler| {
        (error_of_mean(sampler, 512) / error_of_mean(sampler, 8192)).log2() / 4.0
    };
    // Theory: N^-1/2 for random points, up to N^-3/2 for scrambled nets and smooth functions.
    assert!((0.3..0.7).contains(&order(Sampler::Random)), "{}", order(Sampler::Random));
    assert!(order(Sampler::Sobol) > 1.0, "{}", order(Sampler::Sobol));
    assert!(error_of_mean(Sampler::Latin, 8192) < 0.5 * error_of_mean(Sampler::Random, 8192));
}

#[test]
fn latin_hypercubes_have_one_value_in_each_interval() {
    let design =
        Design { sampler: Sampler::Latin, dimensions: 5, samples: REPLICATES * 50, seed: 3 };
    let points = design.points().expect("points");
    for replicate in 0..REPLICATES {
        for dimension in 0..5 {
            let mut hit = [false; 50];
            for number in 0..50 {
                let u = points.get(number * REPLICATES + replicate)[dimension];
                hit[(u * 50.0) as usize] = true;
            }
            assert!(hit.iter().all(|hit| *hit), "replicate {replicate}, dimension {dimension}");
        }
    }
}

/// The references are those of mpmath with 40 digits, and of `scipy.stats.triang.ppf(p, 0.25, 1,
/// 4)`:
///
/// ```python
/// z = lambda p: findroot(lambda z: log(erfc(-z/sqrt(2))/2) - log(p), norm.ppf(p))
/// v = log(1 + mpf(2)**2/mpf(3)**2); lognormal = 3*exp(sqrt(v)*z(p) - v/2)
/// ```
#[test]
fn quantiles_are_those_of_scipy_and_mpmath() {
    let p = [1e-300, 1e-12, 1e-6, 0.01, 0.3, 0.5, 0.9, 0.999_999];
    let close = |law: Law, expected: [f64; 8]| {
        let distribution = Distribution::new(law).expect("a distribution");
        for (p, expected) in p.iter().zip(expected) {
            let found = distribution.quantile(*p);
            let off = (found - expected).abs();
            assert!(off <= 1e-12 * expected.abs(), "{law:?} at {p}: {found}, {expected}");
        }
    };
    close(
        Law::Normal { mean: 0.0, deviation: 1.0 },
        [
            -37.047_096_299_361_2,
            -7.034_483_825_301_132,
            -4.753_424_308_822_899,
            -2.326_347_874_040_841,
            -0.524_400_512_708_040_8,
            0.0,
            1.281_551_565_544_600_6,
            4.753_424_308_817_087,
        ],
    );
    close(
        Law::Lognormal { mean: 3.0, deviation: 2.0 },
        [
            4.371_581_926_485_761_5e-10,
            0.035_049_874_346_223_31,
            0.139_772_165_017_156_64,
            0.608_989_179_052_831_8,
            1.816_209_752_389_158_5,
            2.496_150_883_013_531,
            5.429_715_859_211_065,
            44.578_040_484_544_72,
        ],
    );
    close(
        Law::Triangular { low: 1.0, mode: 2.0, high: 5.0 },
        [
            1.0,
            1.000_002,
            1.002,
            1.2,
            2.101_724_650_762_112_6,
            2.550_510_257_216_822,
            3.904_554_884_989_668,
            4.996_535_898_384_812_5,
        ],
    );
    close(Law::Uniform { low: -1.0, high: 3.0 }, p.map(|p| -1.0 + 4.0 * p));
    for (z, expected) in [
        (-10.0, 7.619_853_024_160_525e-24),
        (-30.0, 4.906_713_927_148_187e-198),
        (-20.0, 2.753_624_118_606_233_7e-89),
        (-4.49, 3.561_158_679_597_56e-6),
        (-1.25, 0.105_649_773_666_855_26),
        (-3.0, 0.001_349_898_031_630_094_6),
        (-0.5, 0.308_537_538_725_986_9),
        (0.7, 0.758_036_347_776_927),
        (6.0, 0.999_999_999_013_412_3),
    ] {
        assert!((normal_cdf(z) / expected - 1.0).abs() < 1e-12, "{z}: {}", normal_cdf(z));
    }
}

#[test]
fn quantiles_lead_back_to_their_probability_and_moments_are_those_of_samples() {
    for z in (-800..=800).map(|k| f64::from(k) / 100.0) {
        let p = normal_cdf(z);
        // Probabilities near 1 have no more digits than this.
        let lost = f64::EPSILON / (-0.5 * z * z).exp() * 3.0;
        assert!((normal_quantile(p) - z).abs() < 1e-12 + lost, "{z}");
    }
    for law in [
        Law::Normal { mean: 10.0, deviation: 0.5 },
        Law::Uniform { low: 2.0, high: 7.0 },
        Law::Triangular { low: -1.0, mode: 4.0, high: 5.0 },
        Law::Lognormal { mean: 3.0, deviation: 1.0 },
    ] {
        let distribution = Distribution::new(law).expect("a distribution");
        let design = Design { sampler: Sampler::Sobol, dimensions: 1, samples: 1 << 16, seed: 5 };
        let (values, groups) = sampled(design, |u| distribution.quantile(u[0]));
        let summary = Summary::of(&values, &groups, 0.95).expect("statistics");
        let (mean, deviation) = (distribution.mean(), distribution.deviation());
        assert!((summary.mean.value / mean - 1.0).abs() < 1e-4, "{law:?}: {:?}", summary.mean);
        let off = summary.deviation.value / deviation - 1.0;
        assert!(off.abs() < 2e-3, "{law:?}: {:?}, {deviation}", summary.deviation);
    }
}

#[test]
fn impossible_distributions_and_correlations_are_refused() {
    for law in [
        Law::Normal { mean: f64::NAN, deviation: 1.0 },
        Law::Normal { mean: 0.0, deviation: -1.0 },
        Law::Uniform { low: 1.0, high: 0.0 },
        Law::Uniform { low: -1e308, high: 1e308 },
        Law::Triangular { low: 0.0, mode: 2.0, high: 1.0 },
        Law::Lognormal { mean: 0.0, deviation: 1.0 },
        Law::Lognormal { mean: 1.0, deviation: f64::INFINITY },
    ] {
        assert!(Distribution::new(law).is_err(), "{law:?}");
    }
    let matrix = |entries: [f64; 9]| Correlation::new(DMatrix::from_row_slice(3, 3, &entries));
    assert!(matrix([1.0, 0.9, 0.0, 0.9, 1.0, 0.9, 0.0, 0.9, 1.0]).is_err(), "contradictory");
    assert!(matrix([1.0, 0.5, 0.0, 0.4, 1.0, 0.0, 0.0, 0.0, 1.0]).is_err(), "not symmetric");
    assert!(matrix([2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).is_err(), "diagonal");
    assert!(matrix([1.0, f64::NAN, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).is_err(), "nan");
}

#[test]
fn correlated_parameters_have_their_correlation_and_their_own_distributions() {
    let matrix = DMatrix::from_row_slice(3, 3, &[1.0, 0.8, 0.0, 0.8, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let correlation = Correlation::new(matrix).expect("a correlation");
    let design = Design { sampler: Sampler::Sobol, dimensions: 3, samples: 1 << 14, seed: 2 };
    let points = design.points().expect("points");
    let scores: Vec<Vec<Option<f64>>> =
        (0..points.len()).map(|index| correlation.scores(&points.get(index))).collect();
    let of = |k: usize| scores.iter().map(move |scores| scores[k].expect("mixed"));
    let product = of(0).zip(of(1)).map(|(a, b)| a * b).sum::<f64>() / scores.len() as f64;
    assert!((product - 0.8).abs() < 2e-3, "{product}");
    assert!(scores.iter().all(|scores| scores[2].is_none()), "the third is independent");
    let uniform = Distribution::new(Law::Uniform { low: 0.0, high: 1.0 }).expect("uniform");
    let mean = of(1).map(|z| uniform.of_score(z)).sum::<f64>() / scores.len() as f64;
    assert!((mean - 0.5).abs() < 1e-3, "{mean}");
}

/// Indices of a function of `dimensions` uniform variables.
fn indices_of(
    sampler: Sampler,
    (dimensions, samples): (usize, usize),
    f: impl Fn(&[f64]) -> f64,
) -> SobolIndices {
    let design =
        Saltelli::new(Design { sampler, dimensions, samples, seed: 11 }).expect("a design");
    let row = |row: usize| design.row(row).iter().map(|point| f(point)).collect();
    let values: Vec<Vec<f64>> = (0..design.rows()).map(row).collect();
    SobolIndices::of(&values, &design.groups(), 0.95).expect("indices")
}

/// Compares indices with closed forms: within a limit, and most of them within their intervals.
fn compare(found: &SobolIndices, first: &[f64], total: &[f64], limit: f64) {
    let mut inside = 0;
    for ((index, first), total) in found.indices.iter().zip(first).zip(total) {
        for (estimate, exact) in [(index.first, first), (index.total, total)] {
            assert!((estimate.value - exact).abs() < limit, "{estimate:?}, {exact}");
            let slack = 1e-12;
            inside += usize::from((estimate.low - slack..=estimate.high + slack).contains(exact));
        }
    }
    let all = 2 * first.len();
    assert!(inside * 10 >= all * 8, "{inside} of {all} intervals hold the exact index");
}

/// Closed form: T. Ishigami, T. Homma 1990, with a = 7 and b = 0.1.
#[test]
fn indices_of_ishigami_are_those_of_its_closed_form() {
    let pi = std::f64::consts::PI;
    let (a, b) = (7.0, 0.1);
    let of_first = 0.5 * (1.0 + b * pi.powi(4) / 5.0).powi(2);
    let of_second = a * a / 8.0;
    let together = b * b * pi.powi(8) * (1.0 / 18.0 - 1.0 / 50.0);
    let variance = of_first + of_second + together;
    let first = [of_first / variance, of_second / variance, 0.0];
    let total = [(of_first + together) / variance, of_second / variance, together / variance];
    let ishigami = |u: &[f64]| {
        let x: Vec<f64> = u.iter().map(|u| pi * (2.0 * u - 1.0)).collect();
        x[0].sin() + a * x[1].sin().powi(2) + b * x[2].powi(4) * x[0].sin()
    };
    for (sampler, limit) in
        [(Sampler::Sobol, 0.03), (Sampler::Random, 0.06), (Sampler::Latin, 0.06)]
    {
        let found = indices_of(sampler, (3, 4096), ishigami);
        compare(&found, &first, &total, limit);
        assert!((found.variance / variance - 1.0).abs() < 0.1);
    }
}

/// Closed form: V_i = 1/(3 (1 + a_i)^2), V = prod(1 + V_i) - 1 (Sobol 1993).
#[test]
fn indices_of_the_g_function_are_those_of_its_closed_form() {
    let a = [0.0, 1.0, 4.5, 9.0, 99.0, 99.0];
    let parts = a.map(|a: f64| 1.0 / (3.0 * (1.0 + a).powi(2)));
    let whole: f64 = parts.iter().map(|part| 1.0 + part).product();
    let variance = whole - 1.0;
    let first = parts.map(|part| part / variance);
    let total = parts.map(|part| part * whole / (1.0 + part) / variance);
    let g =
        |u: &[f64]| u.iter().zip(a).map(|(u, a)| ((4.0 * u - 2.0).abs() + a) / (1.0 + a)).product();
    let found = indices_of(Sampler::Sobol, (6, 4096), g);
    compare(&found, &first, &total, 0.02);
    assert!((found.variance / variance - 1.0).abs() < 0.02);
}

#[test]
fn a_linear_function_has_the_variance_and_the_shares_of_its_closed_form() {
    let slopes = [3.0_f64, -1.0, 0.5];
    let deviations = [0.2_f64, 0.5, 2.0];
    let parts: [f64; 3] = std::array::from_fn(|k| (slopes[k] * deviations[k]).powi(2));
    let variance: f64 = parts.iter().sum();
    let linear = |u: &[f64]| -> f64 {
        (0..3).map(|k| slopes[k] * deviations[k] * normal_quantile(u[k])).sum()
    };
    let found = indices_of(Sampler::Sobol, (3, 4096), linear);
    let shares = parts.map(|part| part / variance);
    compare(&found, &shares, &shares, 0.01);
    let alone = propagate(&slopes, &deviations, &Correlation::none(3));
    assert!((alone.deviation.powi(2) / variance - 1.0).abs() < 1e-14);
    for (share, exact) in alone.shares.iter().zip(shares) {
        assert!((share.share - exact).abs() < 1e-14);
    }
    // With correlation: sum of s_i s_j rho_ij over all pairs, and sampled.
    let rho = 0.7;
    let matrix = DMatrix::from_row_slice(3, 3, &[1.0, rho, 0.0, rho, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let correlation = Correlation::new(matrix).expect("a correlation");
    let together = propagate(&slopes, &deviations, &correlation);
    let exact = variance + 2.0 * rho * (3.0 * 0.2) * (-0.5);
    assert!((together.deviation.powi(2) / exact - 1.0).abs() < 1e-14);
    assert!((together.shares.iter().map(|share| share.share).sum::<f64>() - 1.0).abs() < 1e-14);
    let design = Design { sampler: Sampler::Sobol, dimensions: 3, samples: 1 << 14, seed: 4 };
    let (values, groups) = sampled(design, |u| {
        let scores = correlation.scores(u);
        let score = |k: usize| scores[k].unwrap_or_else(|| normal_quantile(u[k]));
        (0..3).map(|k| slopes[k] * deviations[k] * score(k)).sum()
    });
    let summary = Summary::of(&values, &groups, 0.95).expect("statistics");
    assert!((summary.deviation.value.powi(2) / exact - 1.0).abs() < 0.01);
}

#[test]
fn elementary_effects_tell_linear_parameters_from_others() {
    let design = Morris { dimensions: 4, paths: 50, seed: 9 };
    let f = |u: &[f64]| 3.0 * u[0] - 2.0 * u[1] + 8.0 * (u[2] - 0.5).powi(2) + 0.0 * u[3];
    let values: Vec<Vec<f64>> =
        (0..50).map(|path| design.path(path).iter().map(|u| f(u)).collect()).collect();
    let effects = design.effects(&values, 0.95).expect("effects");
    assert!((effects[0].mean - 3.0).abs() < 1e-12 && effects[0].deviation < 1e-12);
    assert!(
        (effects[1].mean + 2.0).abs() < 1e-12 && (effects[1].mean_absolute - 2.0).abs() < 1e-12
    );
    // From 1/8 to 5/8 and from 3/8 to 7/8: -2 and 2 of 8 (u - 1/2)^2, over 1/2.
    assert!((effects[2].mean_absolute - 2.0).abs() < 1e-12 && effects[2].deviation > 1.5);
    assert!(effects[3].mean_absolute.abs() < 1e-12);
    for path in 0..50 {
        let points = design.path(path);
        assert!(points.iter().flatten().all(|u| *u > 0.0 && *u < 1.0));
    }
}

#[test]
fn values_over_variants_are_those_of_single_runs_in_lanes_and_with_events() {
    let of = |text: &str| Expression::parse(text).expect("an expression");
    let smooth = of("max(abs(twist)) + coupling.stiffness/1e6 - final(coupling_torque)/100");
    let runs = Sweep::new(&TwoMass)
        .each(|run| run.until(0.3).points(101).rtol(1e-9).method(Method::Taylor))
        .vary("coupling.stiffness", &[1e3, 5e3, 2e4])
        .expect("a parameter")
        .run();
    for (run, stiffness) in runs.into_iter().zip([1e3, 5e3, 2e4]) {
        let run = run.expect("it runs");
        let simulation = Simulation::new(&TwoMass).until(0.3).points(101).rtol(1e-9);
        let simulation = simulation.parameter("coupling.stiffness", stiffness).expect("known");
        let found = value_over(&smooth, &simulation, &run);
        let exact = gradient(&simulation.method(Method::Dop853), &smooth).expect("it runs").value;
        assert!((found - exact).abs() < 1e-6 * exact.abs(), "{found}, {exact}");
    }
    // Extremes are not interpolated across the impacts.
    let name = machinist_contract::Describe::state(&BouncingMass, 0).name.to_owned();
    let bouncing = of(&format!("max({name}) - min({name})"));
    let simulation = Simulation::new(&BouncingMass).points(301);
    let run = machinist::sweep::one(&simulation).expect("it runs");
    assert!(!run.events.is_empty() && run.times.len() == 301);
    let found = value_over(&bouncing, &simulation, &run);
    let exact = gradient(&simulation, &bouncing).expect("it runs").value;
    assert!((found - exact).abs() < 1e-6 * exact.abs(), "{found}, {exact}");
}

#[test]
fn too_few_samples_and_values_that_are_missing_are_no_panic() {
    let independent = Groups::Independent;
    assert!(Summary::of(&[], &independent, 0.95).is_err());
    assert!(Summary::of(&[1.0, f64::NAN], &independent, 0.95).is_err());
    assert!(Summary::of(&[1.0, 2.0], &independent, 1.0).is_err());
    let summary = Summary::of(&[1.0, f64::NAN, 3.0], &Groups::Replicates(16), 0.95);
    let summary = summary.expect("two values");
    assert!((summary.mean.value - 2.0).abs() < 1e-15 && summary.count == 2);
    let far = summary.quantile(0.01);
    assert!(far.low.is_infinite() && far.value >= 1.0);
    for samples in [0, 1, usize::MAX] {
        let design = Design { sampler: Sampler::Sobol, dimensions: 2, samples, seed: 0 };
        assert!(design.points().is_err(), "{samples}");
    }
    let rows = vec![vec![1.0; 4]; 8];
    assert!(SobolIndices::of(&rows, &independent, 0.95).is_err(), "the values do not vary");
    assert!(Sampler::from_name("sobl").expect_err("unknown").to_string().contains("`sobol`"));
}
