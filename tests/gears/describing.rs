//! Jumps of loose gears beside the describing functions of the literature.
//!
//! With a motion m + a cos(W t + p) between the teeth, the force of a play of half width 1 has the
//! mean G and the first harmonic N a:
//!
//! ```text
//! G = m + a (h(u) - h(l))/2            h(c) = 2/pi (c asin(c) + sqrt(1 - c^2)), |c| beyond 1
//! N = 1 + (g(l) - g(u))/2              g(c) = 2/pi (asin(c) + c sqrt(1 - c^2)), sign(c) beyond 1
//! l = (-1 - m)/a,  u = (1 - m)/a
//! G = F,   a^2 ((N - W^2)^2 + (2 zeta W)^2) = (E W^2)^2
//! ```
//!
//! Sources: R. Comparin, R. Singh: Non-linear frequency response characteristics of an impact pair,
//! J. Sound Vib. 134 (1989); A. Kahraman, R. Singh: Non-linear dynamics of a spur gear pair, J. Sound
//! Vib. 142 (1990).

use std::f64::consts::FRAC_2_PI;

use machinist::Simulation;
use machinist::periodic::{CycleSettings, Period};
use machinist_codegen::mechanics::reduce::Keep;

use super::{WAY, drive, folds, loose_and_soft, of_tooth};
use crate::own_scene::of_text;

fn mean_and_slope(m: f64, a: f64) -> (f64, f64) {
    let root = |c: f64| (1.0 - c * c).sqrt();
    let h = |c: f64| if c.abs() < 1.0 { FRAC_2_PI * (c * c.asin() + root(c)) } else { c.abs() };
    let g = |c: f64| if c.abs() < 1.0 { FRAC_2_PI * (c.asin() + c * root(c)) } else { c.signum() };
    let (l, u) = ((-1.0 - m) / a, (1.0 - m) / a);
    (m + a * (h(u) - h(l)) / 2.0, 1.0 + (g(l) - g(u)) / 2.0)
}

/// Damping ratio, load and transmission error.
#[derive(Debug, Clone, Copy)]
struct Gears {
    zeta: f64,
    load: f64,
    error: f64,
}

impl Gears {
    /// Returns the lower of the frequencies at which the motion has an amplitude.
    fn frequency(self, a: f64) -> Option<f64> {
        let Self { zeta, load, error } = self;
        // The mean force increases with m.
        let (mut low, mut high) = (0.0, 1.0 + load + a);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            let is_above = mean_and_slope(middle, a).0 > load;
            (low, high) = if is_above { (low, middle) } else { (middle, high) };
        }
        let slope = mean_and_slope(low, a).1;
        let (p, q) = (a * a - error * error, a * a * (slope - 2.0 * zeta * zeta));
        let root = q * q - p * (a * slope).powi(2);
        (root >= 0.0).then(|| ((q - root.sqrt()) / p).sqrt())
    }

    /// Returns the frequencies of both folds: as the amplitude grows beyond that at which the teeth
    /// part, the frequency rises, falls, and rises again up to resonance.
    fn folds(self) -> [f64; 2] {
        let amplitudes = (1..20_000).map(|k| self.load * 1.0002_f64.powi(k));
        let all: Vec<f64> = amplitudes.map_while(|a| self.frequency(a)).collect();
        let start = all.windows(2).position(|pair| pair[1] < pair[0]).expect("an upper fold");
        [all[start..].iter().copied().fold(f64::INFINITY, f64::min), all[start]]
    }
}

fn assert_near(found: [f64; 2], wanted: [f64; 2], shares: [f64; 2], title: &str) {
    for ((found, wanted), share) in found.into_iter().zip(wanted).zip(shares) {
        assert!((found / wanted - 1.0).abs() < share, "{title}: {found} for {wanted}");
    }
}

/// The describing functions neglect higher harmonics, which move the folds by some percent.
#[test]
fn gears_jump_near_the_frequencies_of_the_describing_functions() {
    let scene = of_text(WAY, Keep::Needed);
    let sweep = [
        (0.05, 0.1, 0.05),
        (0.04, 0.1, 0.04),
        (0.05, 0.2, 0.08),
        (0.05, 0.1, 0.03),
        (0.08, 0.1, 0.1),
        (0.06, 0.3, 0.15),
    ];
    for (zeta, load, error) in sweep {
        let gears = Gears { zeta, load, error };
        let run = [("pair.damping", 2.0 * zeta), ("pair.load", load), ("pair.error", error)]
            .into_iter()
            .fold(Simulation::new(&scene), |run, (name, value)| {
                run.parameter(name, value).expect("a parameter")
            });
        let cycle = CycleSettings {
            period: Period::Parameter("pair.tooth".to_owned()),
            settle: 300.0,
            points: 401,
            ..CycleSettings::default()
        };
        let found = folds(&run, ("pair.tooth", 1.2, 0.5), &cycle, 400);
        println!("{gears:?}: {found:?}, {:?}", gears.folds());
        assert_near(gears.folds(), found, [0.05, 0.02], &format!("{gears:?}"));
    }
    // Harmonic balance with one term, by `tests/gears/references.py`.
    let gears = Gears { zeta: 0.05, load: 0.1, error: 0.05 };
    let one_term = [0.680_136_921_860_344_6, 0.826_070_049_837_592_6];
    assert_near(gears.folds(), one_term, [1e-7; 2], "one term");
}

/// Number of harmonics and both folds by harmonic balance (`tests/gears/references.py`), the method
/// of G. Blankenship, A. Kahraman: Steady state forced response of a mechanical oscillator with
/// combined parametric excitation and clearance type non-linearity, J. Sound Vib. 185 (1995).
type Balanced = [(usize, [f64; 2]); 5];

/// With a transmission error.
const BALANCED: Balanced = [
    (1, [0.680_136_921_860, 0.826_070_049_838]),
    (2, [0.706_095_984_561, 0.827_923_744_700]),
    (4, [0.707_932_114_850, 0.828_458_453_185]),
    (8, [0.708_029_051_172, 0.828_462_421_739]),
    (16, [0.708_031_605_822, 0.828_464_008_364]),
];

/// With a stiffness that varies with the tooth.
const BALANCED_SOFT: Balanced = [
    (1, [0.705_153_534_777, 0.848_630_778_591]),
    (2, [0.705_850_734_532, 0.843_862_349_888]),
    (4, [0.705_658_137_396, 0.844_477_334_202]),
    (8, [0.705_695_011_242, 0.844_564_343_932]),
    (16, [0.705_697_379_753, 0.844_564_049_674]),
];

#[test]
fn harmonic_balance_of_more_terms_tends_to_the_jumps_of_the_gear_part() {
    let cycle = CycleSettings { points: 401, ..of_tooth(300.0) };
    for (gears, balanced) in [(super::LOOSE, BALANCED), (&loose_and_soft(), BALANCED_SOFT)] {
        let scene = drive(gears, "gears", 2.0);
        let found = folds(&Simulation::new(&scene), ("tooth", 1.2, 0.6), &cycle, 100);
        let mut before = [f64::INFINITY; 2];
        for (harmonics, folds) in balanced {
            let off = [0, 1].map(|k| (folds[k] - found[k]).abs());
            let is_nearer = off[0] < before[0] && off[1] < before[1];
            assert!(is_nearer, "{harmonics} harmonics: {off:?} after {before:?}");
            before = off;
        }
        assert!(before.iter().all(|off| *off < 2e-7), "{before:?}");
    }
}
