//! Excitation of a linear machine with linear fields: that of the machine, since fields have none.

use machinist_contract::Real;
use machinist_contract::field::FieldScene;
use machinist_contract::linear::LinearEquations;

use super::FieldSimulator;

/// Returns the excitation terms of a scene whose machine and fields are linear. `border` contains
/// the indices of the machine's entries in the state.
pub(super) fn terms<R: Real>(scene: &dyn FieldScene<R>, border: &[u32]) -> Option<Vec<(u32, u32)>> {
    // Guards of the machine are not among the rows of the whole.
    let linear = scene.linear().filter(|_| scene.events() + scene.kinks() == 0)?;
    let is_linear = (0..scene.fields()).all(|index| scene.force_structure(index).linear);
    let terms = linear.excitation_terms().iter();
    is_linear.then(|| terms.map(|(entry, power)| (border[*entry as usize], *power)).collect())
}

impl<R: Real> LinearEquations<R> for FieldSimulator<'_, R> {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        self.excitation_terms.as_deref().unwrap_or_default()
    }

    fn excitation(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let Some(linear) = self.scene().linear() else { return };
        let work = &mut *self.work();
        let mut constants = std::mem::take(&mut work.constants);
        self.compute_constants(parameters, work, &mut constants);
        work.constants = constants;
        // Fields exert no forces without motion.
        for (_, handed) in self.ports.iter().copied() {
            work.p[handed + 1] = R::literal(0.0);
        }
        // Without events the machine has no modes.
        let own = self.scene().shape().states();
        linear.excitation(time, &state[..own], &work.p, values);
    }

    fn switches(&self) -> usize {
        self.scene().linear().map_or(0, LinearEquations::switches)
    }

    fn switch_times(&self, parameters: &[R], times: &mut [R]) {
        let work = &mut *self.work();
        self.place(parameters, work);
        if let Some(linear) = self.scene().linear() {
            linear.switch_times(&work.p, times);
        }
    }
}
