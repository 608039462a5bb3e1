//! Inclusion of an emitted file in another crate.

/// Includes `$OUT_DIR/<name>.rs`, which `machinist_codegen::Build` wrote for the scene of that
/// name.
///
/// ```text
/// mod drive {
///     machinist_contract::include_scene!("drive");
/// }
///
/// let rate = drive::rate(time, &state, &parameters);
/// ```
///
/// Names come from the spec, and functions are as long as the equations, so style lints are
/// switched off inside.
#[macro_export]
macro_rules! include_scene {
    ($name:literal) => {
        #[allow(
            clippy::all,
            clippy::pedantic,
            dead_code,
            non_snake_case,
            reason = "emitted from a spec: its names, its length, and more than one program uses"
        )]
        mod emitted {
            ::core::include!(::core::concat!(::core::env!("OUT_DIR"), "/", $name, ".rs"));
        }
        #[allow(unused_imports, reason = "a program need not use everything")]
        pub use emitted::*;
    };
}
