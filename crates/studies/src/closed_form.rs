//! Exact solutions for comparison with the simulators, derived by hand.
//!
//! Nothing here depends on a simulator, a solver or the symbolic pipeline: every
//! function is a formula over `f64`, or over any [`Number`] where its derivatives are
//! wanted too, one file a subject. Quantities are in SI
//! units, angles in rad. No function fails; numbers outside the stated ranges
//! (such as a negative inertia) give NaN or infinities, as their formulas do.

pub mod bobbin_holder;
pub mod bouncing_bobbin;
pub mod coulomb;
pub mod duffing;
pub mod four_bar;
pub mod holder_oscillation;
pub mod induction_motor;
pub mod motor_windings;
mod number;
pub mod one_sided_stop;
pub mod pendulum_chain;
pub mod printed_laws;
pub mod reed;
mod roots;
pub mod saw_gin_by_hand;
pub mod shaft;
pub mod shaken_plate;
pub mod slider_crank;
pub mod stick_slip;
pub mod turning_drum;
pub mod two_mass;
pub mod winder;
pub mod winding_pair;

pub use bobbin_holder::BobbinHolder;
pub use bouncing_bobbin::BouncingBobbin;
pub use coulomb::CoulombOscillator;
pub use duffing::Duffing;
pub use four_bar::FourBar;
pub use holder_oscillation::SwingingHolder;
pub use induction_motor::{InductionMotor, Nameplate};
pub use motor_windings::MotorWindings;
pub use number::Number;
pub use one_sided_stop::OneSidedStop;
pub use pendulum_chain::PendulumChain;
pub use printed_laws::PrintedShaft;
pub use reed::ReedShaft;
pub use saw_gin_by_hand::SawGinByHand;
pub use shaft::Shaft;
pub use shaken_plate::ShakenPlate;
pub use slider_crank::SliderCrank;
pub use stick_slip::StickSlip;
pub use turning_drum::TurningDrum;
pub use two_mass::TwoMass;
pub use winder::BobbinOscillator;
pub use winding_pair::WindingPair;
