//! Methods that suit a machine.

use machinist_contract::Simulator;

use crate::error::{Feature, Unsuitable};
use crate::method_table::Method;

impl Method {
    /// Returns whether the method can run this simulator. `taylor` needs the series that emitted
    /// simulators have and simulators written by hand may lack; `exact` needs linear equations with
    /// constant coefficients while modes are held. Events need a method that watches them, and
    /// constraints one that maintains them.
    #[must_use]
    pub fn suits(self, simulator: &dyn Simulator<f64>) -> bool {
        let has_what_it_needs = match self {
            Self::Taylor => simulator.taylor().is_some(),
            Self::Exact => simulator.linear().is_some(),
            _ => true,
        };
        has_what_it_needs && self.check(simulator).is_ok()
    }

    /// Refuses machines with events or constraints that the method would ignore.
    ///
    /// # Errors
    /// [`Unsuitable`], with the methods made for such machines.
    pub fn check(self, simulator: &dyn Simulator<f64>) -> Result<(), Unsuitable> {
        let refuse = |feature: Feature, has: fn(Self) -> bool| {
            let known = Self::ALL.iter().filter(|method| has(**method));
            let known = known.map(|method| method.name()).collect::<Vec<_>>().join(", ");
            let (scene, method) = (simulator.name().to_owned(), self.name());
            Err(Unsuitable { scene, method, feature, known })
        };
        if simulator.events() > 0 && !self.watches_events() {
            return refuse(Feature::Events, Self::watches_events);
        }
        if simulator.constraints() > 0 && !self.keeps_constraints() {
            return refuse(Feature::Constraints, Self::keeps_constraints);
        }
        Ok(())
    }

    /// Returns whether the method stops where guards cross zero: our own methods that step from one
    /// state to the next do.
    #[must_use]
    pub fn watches_events(self) -> bool {
        self.keeps_constraints() || self == Self::Taylor
    }

    /// Returns whether the method projects the state onto constraints after each step: methods that
    /// watch events do, except series, which no machine with constraints has.
    #[must_use]
    pub fn keeps_constraints(self) -> bool {
        matches!(
            self,
            Self::Tsit5 | Self::Dop853 | Self::Rodas5p | Self::Radau | Self::Auto | Self::Exact
        )
    }
}
