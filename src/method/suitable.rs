//! Which methods are for which machines.

use machinist_contract::Simulator;

use super::Method;
use crate::error::{Lack, Unsuitable};

impl Method {
    /// Whether the method can run this simulator: `taylor` needs the series that
    /// emitted simulators have and simulators written by hand may lack, `exact`
    /// linear equations with constant coefficients; events need a method that watches
    /// them, and constraints one that keeps to them.
    #[must_use]
    pub fn suits(self, simulator: &dyn Simulator<f64>) -> bool {
        let has_what_it_needs = match self {
            Self::Taylor => simulator.taylor().is_some(),
            Self::Exact => simulator.linear().is_some(),
            _ => true,
        };
        has_what_it_needs && self.check(simulator).is_ok()
    }

    /// Refuses machines with events or constraints that the method would pass over.
    ///
    /// # Errors
    /// [`Unsuitable`], with the methods that are made for such machines.
    pub fn check(self, simulator: &dyn Simulator<f64>) -> Result<(), Unsuitable> {
        let refuse = |lack: Lack, has: fn(Self) -> bool| {
            let known = Self::ALL.iter().filter(|method| has(**method));
            let known = known.map(|method| method.name()).collect::<Vec<_>>().join(", ");
            let (scene, method) = (simulator.name().to_owned(), self.name());
            Err(Unsuitable { scene, method, lack, known })
        };
        if simulator.events() > 0 && !self.watches_events() {
            return refuse(Lack::Events, Self::watches_events);
        }
        if simulator.constraints() > 0 && !self.keeps_constraints() {
            return refuse(Lack::Constraints, Self::keeps_constraints);
        }
        Ok(())
    }

    /// Whether the method stops where guards pass zero: those of our own that step from
    /// one state to the next do.
    #[must_use]
    pub fn watches_events(self) -> bool {
        self.keeps_constraints() || self == Self::Taylor
    }

    /// Whether the method puts the state back onto constraints after each step: those
    /// that watch events do, but for series, which no machine with constraints has.
    #[must_use]
    pub fn keeps_constraints(self) -> bool {
        matches!(self, Self::Tsit5 | Self::Dop853 | Self::Rodas5p | Self::Radau | Self::Auto)
    }
}
