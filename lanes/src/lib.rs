//! The emitted scenes, eight variants side by side, for sweeps.
//!
//! Emitted code is generic, and compiled where it is asked for on some kind of number, as that
//! crate is compiled. Here that is done once, optimised, for programs that are not.
#![forbid(unsafe_code)]

use machinist::lanes::F64x8;
use machinist_contract::Simulator;
use machinist_scenes::scenes;

/// The scene of a name, eight at a time.
#[must_use]
pub fn find(name: &str) -> Option<&'static dyn Simulator<F64x8>> {
    #[cfg(feature = "bench")]
    if let Some(simulator) = machinist_scenes::bench::find(name) {
        return Some(simulator);
    }
    scenes::find(name)
}
