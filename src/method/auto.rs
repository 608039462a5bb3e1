//! Chooses a method by the tolerance, and changes it when a machine turns out to
//! be stiff, or not to be any more.

use super::exact::Exact;
use super::explicit::ExplicitSteps;
use super::one_step::{Left, OneStep, drive};
use super::radau::RadauSteps;
use super::rosenbrock::RosenbrockSteps;
use super::tableau::{DOP853, Pair, RODAS5P, TSIT5};
use super::{Integrator, Samples, Stopped, Stretch};

/// So many steps of evidence change the method.
const STIFF_STEPS: usize = 15;
/// So many without it make the evidence void.
const EASY_STEPS: usize = 6;
/// After so many changes within a stretch the run stays with the implicit method,
/// which is never wrong, only slower.
const MOST_CHANGES: usize = 20;
/// An implicit step that is not this much longer than an explicit one could be
/// does not pay for its factorization.
const WORTH: f64 = 2.0;

/// Solves linear machines without steps where that is exact enough. Otherwise starts
/// with an explicit method; changes to an implicit one where steps are
/// held by stability instead of accuracy, and back where they are not.
pub(super) struct Auto;

impl Integrator for Auto {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let rest;
        let stretch = match Exact.integrate(stretch, state, samples) {
            Ok(()) => return Ok(()),
            // Not for this machine, or not from here on.
            Err(stopped) => {
                rest = Stretch { from: stopped.time, ..*stretch };
                &rest
            }
        };
        let choice = Choice::new(stretch.rtol);
        let mut explicit = ExplicitSteps::new(choice.explicit, stretch);
        let system = stretch.system;
        system.note(format!(
            "starts with {}, for a relative tolerance of {:e}",
            choice.explicit_name, stretch.rtol
        ));
        explicit.begin(stretch.from, state);
        let mut at = Left { time: stretch.from, step: explicit.first_step() };
        let mut changes = 0;
        loop {
            let mut evidence = Evidence::default();
            let limit = choice.explicit.stability;
            let is_stiff =
                |method: &ExplicitSteps<'_>, _| evidence.grows(method.stiffness() > limit);
            let Some(left) = drive(&mut explicit, stretch, at, state, samples, is_stiff)? else {
                return Ok(());
            };
            system.note(format!(
                "{} instead of {} from t = {:.6} s on: steps were held by stability, \
                 |h lambda| = {:.1}",
                choice.implicit_name,
                choice.explicit_name,
                left.time,
                explicit.stiffness()
            ));
            changes += 2;
            let may_return = changes < MOST_CHANGES;
            let Some(left) = choice.implicit_stretch(stretch, left, state, samples, may_return)?
            else {
                return Ok(());
            };
            system.note(format!(
                "{} instead of {} from t = {:.6} s on: no longer stiff",
                choice.explicit_name, choice.implicit_name, left.time
            ));
            explicit.begin(left.time, state);
            at = left;
        }
    }
}

/// The methods for a tolerance. Another one, of any kind, is one more field and
/// one more case in `new`.
struct Choice {
    explicit: &'static Pair,
    explicit_name: &'static str,
    implicit_name: &'static str,
    is_tight: bool,
}

impl Choice {
    fn new(rtol: f64) -> Self {
        let (explicit, explicit_name) =
            if rtol > 1e-3 { (&TSIT5, "tsit5") } else { (&DOP853, "dop853") };
        let is_tight = rtol <= 1e-7;
        let implicit_name = if is_tight { "radau" } else { "rodas5p" };
        Self { explicit, explicit_name, implicit_name, is_tight }
    }

    /// Goes on implicitly, until it would do explicitly.
    fn implicit_stretch(
        &self,
        stretch: &Stretch<'_>,
        from: Left,
        state: &mut [f64],
        samples: &mut Samples<'_>,
        may_return: bool,
    ) -> Result<Option<Left>, Stopped> {
        let mut radius = SpectralRadius::new(stretch);
        let mut evidence = Evidence::default();
        let mut is_easy = |jacobian: &[f64], step: f64| {
            let explicit_step = self.explicit.stability / radius.renew(jacobian);
            evidence.grows(step < WORTH * explicit_step) && may_return
        };
        if self.is_tight {
            let mut method = RadauSteps::new(stretch);
            method.begin(from.time, state);
            let leave = |method: &RadauSteps<'_>, step| is_easy(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, leave)
        } else {
            let mut method = RosenbrockSteps::new(&RODAS5P, stretch);
            method.begin(from.time, state);
            let leave = |method: &RosenbrockSteps<'_>, step| is_easy(method.jacobian(), step);
            drive(&mut method, stretch, from, state, samples, leave)
        }
    }
}

/// Steps that speak for a change, not too far apart (Hairer, Wanner, section
/// IV.2).
#[derive(Default)]
struct Evidence {
    found: usize,
    missed: usize,
}

impl Evidence {
    /// Takes the evidence of one step; true if it is enough.
    fn grows(&mut self, is_evidence: bool) -> bool {
        if is_evidence {
            self.missed = 0;
            self.found += 1;
        } else {
            self.missed += 1;
            if self.missed == EASY_STEPS {
                self.found = 0;
            }
        }
        self.found >= STIFF_STEPS
    }
}

/// Largest |eigenvalue| of the Jacobian, by one more power of it a step.
struct SpectralRadius<'a> {
    entries: &'a [(u32, u32)],
    vector: Vec<f64>,
    next: Vec<f64>,
    estimate: f64,
}

impl<'a> SpectralRadius<'a> {
    fn new(stretch: &Stretch<'a>) -> Self {
        let size = stretch.system.states();
        // Anything but an eigenvector.
        let vector = (0..size).map(|index| 1.0 + 0.1 * ((index % 7) as f64)).collect();
        let entries = stretch.system.jacobian_pattern().entries;
        Self { entries, vector, next: vec![0.0; size], estimate: 0.0 }
    }

    /// The estimate after two more multiplications: the square root of the growth
    /// over both, for one alone turns positions into accelerations and says
    /// nothing. It decays slowly, so that a vector that happens to be short of
    /// the fastest motion does not make a machine look easy.
    fn renew(&mut self, jacobian: &[f64]) -> f64 {
        let growth = self.multiply(jacobian) * self.multiply(jacobian);
        let radius = growth.sqrt();
        if radius.is_finite() {
            self.estimate = radius.max(0.9 * self.estimate);
        }
        self.estimate
    }

    /// vector = J vector, then made of length 1; gives the length it had.
    fn multiply(&mut self, jacobian: &[f64]) -> f64 {
        self.next.fill(0.0);
        for (&(row, column), value) in self.entries.iter().zip(jacobian) {
            self.next[row as usize] += value * self.vector[column as usize];
        }
        let length = |vector: &[f64]| vector.iter().map(|v| v * v).sum::<f64>().sqrt();
        let (before, after) = (length(&self.vector), length(&self.next));
        if after > 0.0 && after.is_finite() {
            for (vector, next) in self.vector.iter_mut().zip(&self.next) {
                *vector = next / after;
            }
        }
        after / before
    }
}
