//! S-N curves, corrections for the mean, and damage by the rule of Palmgren and Miner.

use serde::Serialize;

use super::CountedCycle;

/// Continuation of an S-N curve below its knee.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MinerRule {
    /// Amplitudes below the knee do no damage.
    Original,
    /// The curve continues with its slope k.
    Elementary,
    /// The curve continues with the slope 2 k - 1 (Haibach 1970).
    Haibach,
}

/// Correction of an amplitude `S_a` for the mean `S_m` of its cycle. The magnitude of the mean
/// counts, since torsion has no preferred direction; for bending this is on the safe side where the
/// mean is a pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MeanStress {
    /// `S = S_a`.
    Ignored,
    /// `S = S_a/(1 - |S_m|/S_u)` with the ultimate strength `S_u`, or with the yield strength as
    /// proposed by Soderberg.
    Goodman(f64),
    /// `S = S_a/(1 - (S_m/S_u)^2)`.
    Gerber(f64),
    /// `S = (S_a + |S_m|)^(1 - g) S_a^g`; with g = 0.5 that of Smith, Watson and Topper.
    Walker(f64),
}

impl MeanStress {
    /// Returns the amplitude with mean zero that does the same damage; infinite if the mean reaches
    /// the strength.
    #[must_use]
    pub fn corrected(self, amplitude: f64, mean: f64) -> f64 {
        let over = |share: f64| if share < 1.0 { amplitude / (1.0 - share) } else { f64::INFINITY };
        match self {
            _ if amplitude == 0.0 => 0.0,
            Self::Ignored => amplitude,
            Self::Goodman(strength) => over(mean.abs() / strength),
            Self::Gerber(strength) => over((mean / strength).powi(2)),
            Self::Walker(exponent) => {
                (amplitude + mean.abs()).powf(1.0 - exponent) * amplitude.powf(exponent)
            }
        }
    }
}

/// S-N curve: `N = N_k (S/S_k)^(-k)` cycles until failure at an amplitude S (Basquin), with a knee.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Curve {
    /// Amplitude at the knee `S_k`, in the unit of the signal.
    pub endurance: f64,
    /// Number of cycles at the knee, `N_k`.
    pub knee: f64,
    /// Slope k.
    pub slope: f64,
    /// Continuation below the knee.
    pub rule: MinerRule,
    /// Correction for the mean.
    pub mean: MeanStress,
}

impl Curve {
    /// Returns the number of cycles until failure at an amplitude with mean zero; infinite where
    /// they do no damage.
    #[must_use]
    pub fn cycles(&self, amplitude: f64) -> f64 {
        let share = amplitude / self.endurance;
        let slope = match self.rule {
            _ if share >= 1.0 => self.slope,
            MinerRule::Original => return f64::INFINITY,
            MinerRule::Elementary => self.slope,
            MinerRule::Haibach => 2.0 * self.slope - 1.0,
        };
        self.knee * share.powf(-slope)
    }

    /// Returns the damage of a counted cycle: its count over the number of cycles until failure.
    #[must_use]
    pub fn damage(&self, cycle: &CountedCycle) -> f64 {
        cycle.count / self.cycles(self.mean.corrected(cycle.amplitude(), cycle.mean))
    }

    /// Returns the damage of all cycles: failure is expected at 1.
    #[must_use]
    pub fn sum(&self, cycles: &[CountedCycle]) -> f64 {
        cycles.iter().map(|cycle| self.damage(cycle)).sum()
    }
}

/// Returns the constant amplitude that does the same damage in the same number of cycles on a curve
/// of slope k without a knee: `(sum n S^k / sum n)^(1/k)`; zero without cycles.
#[must_use]
pub fn equivalent_amplitude(cycles: &[CountedCycle], slope: f64, mean: MeanStress) -> f64 {
    let corrected = |cycle: &CountedCycle| mean.corrected(cycle.amplitude(), cycle.mean);
    let largest = cycles.iter().map(corrected).fold(0.0, f64::max);
    if largest == 0.0 || largest == f64::INFINITY {
        return largest;
    }
    // Over the largest, so that powers neither vanish nor overflow.
    let powers = cycles.iter().map(|cycle| cycle.count * (corrected(cycle) / largest).powf(slope));
    let number: f64 = cycles.iter().map(|cycle| cycle.count).sum();
    largest * (powers.sum::<f64>() / number).powf(1.0 / slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycle(amplitude: f64, mean: f64, count: f64) -> CountedCycle {
        CountedCycle { range: 2.0 * amplitude, mean, count, samples: [0, 1] }
    }

    const RULES: [MinerRule; 3] = [MinerRule::Original, MinerRule::Elementary, MinerRule::Haibach];

    #[test]
    fn blocks_of_amplitudes_do_the_damage_of_the_closed_form() {
        // Damage 1 at the knee after N_k cycles, 2^k times as much at twice the amplitude.
        for (rule, below) in RULES.into_iter().zip([0.0, 0.5_f64.powi(5), 0.5_f64.powi(9)]) {
            let curve =
                Curve { endurance: 100.0, knee: 2e6, slope: 5.0, rule, mean: MeanStress::Ignored };
            let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * b, "{a} for {b}");
            close(curve.sum(&[cycle(100.0, 30.0, 2e6)]), 1.0);
            close(curve.sum(&[cycle(200.0, 0.0, 1000.0)]), 32.0 * 1000.0 / 2e6);
            close(curve.sum(&[cycle(50.0, 0.0, 2e6)]), below);
            close(curve.sum(&[cycle(200.0, 0.0, 2e6 / 64.0), cycle(100.0, 0.0, 1e6)]), 1.0);
        }
    }

    #[test]
    fn means_raise_amplitudes_as_their_formulas_say() {
        let at = |mean: MeanStress| mean.corrected(100.0, -150.0);
        let found = [
            at(MeanStress::Ignored),
            at(MeanStress::Goodman(600.0)),
            at(MeanStress::Gerber(600.0)),
            at(MeanStress::Walker(0.5)),
            at(MeanStress::Goodman(150.0)),
        ];
        let wanted = [100.0, 400.0 / 3.0, 320.0 / 3.0, 25_000_f64.sqrt(), f64::INFINITY];
        for (found, wanted) in found.into_iter().zip(wanted) {
            assert!(
                found.to_bits() == wanted.to_bits() || (found - wanted).abs() < 1e-12,
                "{found}"
            );
        }
    }

    #[test]
    fn the_equivalent_amplitude_does_the_same_damage() {
        let cycles = [cycle(300.0, 0.0, 10.0), cycle(120.0, 50.0, 200.5), cycle(2.0, 0.0, 1e5)];
        for mean in [MeanStress::Ignored, MeanStress::Goodman(900.0)] {
            for slope in [3.0, 8.0, 200.0] {
                let rule = MinerRule::Elementary;
                let curve = Curve { endurance: 100.0, knee: 1e6, slope, rule, mean };
                let number: f64 = cycles.iter().map(|one| one.count).sum();
                let same = cycle(equivalent_amplitude(&cycles, slope, mean), 0.0, number);
                let (found, wanted) = (curve.damage(&same), curve.sum(&cycles));
                assert!((found - wanted).abs() < 1e-11 * wanted, "{slope}: {found}, {wanted}");
            }
        }
        assert_eq!(equivalent_amplitude(&[], 5.0, MeanStress::Ignored).to_bits(), 0);
    }
}
