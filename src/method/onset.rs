//! Detection of an instability that sets in within a step of an implicit method.

use super::Stretch;
use super::one_step::{Trial, finite_jacobian};
use super::step_matrix::StepMatrix;

/// The Jacobian at the end of a step that may be taken, and the sign of the determinant of its
/// matrix.
pub(super) struct Onset<'a> {
    jacobian: Vec<f64>,
    is_known: bool,
    matrix: StepMatrix<'a, f64>,
}

impl<'a> Onset<'a> {
    pub(super) fn new(stretch: &'a Stretch<'a>) -> Self {
        let system = stretch.system;
        let jacobian = vec![0.0; system.jacobian_pattern().entries.len()];
        Self { jacobian, is_known: false, matrix: StepMatrix::new(system) }
    }

    /// Forgets the Jacobian: another step is tried, or another run begins.
    pub(super) fn forget(&mut self) {
        self.is_known = false;
    }

    /// Hands over the Jacobian, if there is one: the step was taken, and its end is the start of
    /// the next one.
    pub(super) fn hand_over(&mut self, jacobian: &mut Vec<f64>) -> bool {
        if self.is_known {
            std::mem::swap(&mut self.jacobian, jacobian);
        }
        std::mem::take(&mut self.is_known)
    }

    /// Refuses a step at whose end a motion grows faster than the method can distinguish from
    /// decay. The step may have passed over the onset of an instability, and would stay where no
    /// real machine stays. `shift` and `jacobian` are those of the step's own matrix.
    ///
    /// # Errors
    /// [`Trial::Unsolved`] in this case, and [`Trial::NotFinite`] if the Jacobian is not finite.
    pub(super) fn refuse(
        &mut self,
        stretch: &Stretch<'_>,
        (now, end): (f64, &[f64]),
        (shift, jacobian): (f64, &[f64]),
    ) -> Result<(), Trial> {
        self.forget();
        if !self.matrix.tells_growth() {
            return Ok(());
        }
        finite_jacobian(stretch, now, end, &mut self.jacobian)?;
        if self.jacobian != jacobian {
            let outcome = self.matrix.factor(shift, &self.jacobian);
            if outcome.is_err() || self.matrix.is_outgrown() {
                return Err(Trial::Unsolved { shrink: 0.5 });
            }
        }
        self.is_known = true;
        Ok(())
    }
}
