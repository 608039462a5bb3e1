//! The emitted scenes with eight lanes, for sweeps.
//!
//! Emitted code is generic over the number type. It is compiled in the crate that uses it, with the
//! settings of that crate. Here it is compiled once, optimised, also for programs that are not, and
//! only the parts that lanes need.
#![forbid(unsafe_code)]

use machinist::lanes::F64x8;
use machinist_contract::SideBySide;
use machinist_scenes::find_carried;

/// Returns the scene of this name with eight lanes, if its variants can run in lanes: by series,
/// without events and switching surfaces.
#[must_use]
pub fn find(name: &str) -> Option<&'static dyn SideBySide<F64x8>> {
    find_carried!(name)
}
