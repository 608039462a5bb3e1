//! The emitted scenes, eight variants side by side, for sweeps.
//!
//! Emitted code is generic, and compiled where it is asked for on some kind of number, as that
//! crate is compiled. Here that is done once, optimised, for programs that are not; and no more of
//! it than variants side by side ask for.
#![forbid(unsafe_code)]

use machinist::lanes::F64x8;
use machinist_contract::SideBySide;
use machinist_scenes::find_carried;

/// The scene of a name, eight at a time, if variants of it may go so: by series, without events and
/// corners.
#[must_use]
pub fn find(name: &str) -> Option<&'static dyn SideBySide<F64x8>> {
    #[cfg(feature = "bench")]
    if let Some(scene) = find_bench(name) {
        return Some(scene);
    }
    find_carried!(name)
}

#[cfg(feature = "bench")]
fn find_bench(name: &str) -> Option<&'static dyn SideBySide<F64x8>> {
    machinist_scenes::find_carried_in_bench!(name)
}
