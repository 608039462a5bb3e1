// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen

//! Simulators emitted from the specs, one module a scene.
use ::machinist_contract::{Dual, Real, Simulator, field::FieldScene};

/// Benchmark M1: induction motor alone
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m1;

/// Benchmark M2: saw gin
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m2;

/// Benchmark M3: motor and torsional shaft of equal pieces
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m3;

/// Benchmark M3: motor and torsional shaft of 10 pieces
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m3_10;

/// Benchmark M4: reed as a torsional shaft
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m4;

/// Benchmark M4: reed as a torsional shaft of 7 pieces
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m4_7;

/// Benchmark M5: winder
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m5;

/// Benchmark M6: planar pendulum of 10 links
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m6_10;

/// Benchmark M6: planar pendulum of 2 links
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m6_2;

/// Benchmark M6: planar pendulum of 5 links
#[rustfmt::skip]
#[allow(
    non_snake_case,
    clippy::approx_constant,
    clippy::struct_field_names,
    clippy::too_many_lines,
    reason = "the spec's own names and numbers, in bodies as long as its equations"
)]
pub mod m6_5;

/// Names of all scenes, sorted.
#[rustfmt::skip]
pub const NAMES: &[&str] = &["m1", "m2", "m3_10", "m4_7", "m5", "m6_10", "m6_2", "m6_5"];

/// The scene of a name, if there is one.
#[must_use]
#[allow(clippy::match_single_binding, reason = "features may leave no scene")]
#[rustfmt::skip]
pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
    match name {
        "m1" => Some(&m1::M1),
        "m2" => Some(&m2::M2),
        "m3_10" => Some(&m3_10::M310),
        "m4_7" => Some(&m4_7::M47),
        "m5" => Some(&m5::M5),
        "m6_10" => Some(&m6_10::M610),
        "m6_2" => Some(&m6_2::M62),
        "m6_5" => Some(&m6_5::M65),
        _ => None,
    }
}

/// The scene of a name in `f64`, compiled once and for all: who calls [`find`] compiles
/// all scenes within a crate of its own.
#[must_use]
pub fn find_f64(name: &str) -> Option<&'static dyn Simulator<f64>> {
    find(name)
}

/// Names of all scenes with fields, sorted.
#[rustfmt::skip]
pub const FIELD_NAMES: &[&str] = &["m3", "m4"];

/// The scene with fields of a name, not yet cut into elements.
#[must_use]
#[allow(clippy::match_single_binding, reason = "features may leave no scene")]
pub fn find_field<R: Real>(name: &str) -> Option<&'static dyn FieldScene<R>> {
    match name {
        "m3" => Some(&m3::M3),
        "m4" => Some(&m4::M4),
        _ => None,
    }
}

/// The scene with fields of a name in `f64`, compiled once and for all.
#[must_use]
pub fn find_field_f64(name: &str) -> Option<&'static dyn FieldScene<f64>> {
    find_field(name)
}

/// It on numbers that carry derivatives, likewise.
#[must_use]
pub fn find_field_duals(name: &str) -> Option<&'static dyn FieldScene<Dual>> {
    find_field(name)
}
