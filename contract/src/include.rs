//! Bringing an emitted file into a crate of one's own.

/// Includes `$OUT_DIR/<name>.rs`, which `machinist_codegen::Build` wrote from the
/// scene of that name.
///
/// ```text
/// mod drive {
///     machinist_contract::include_scene!("drive");
/// }
///
/// let rate = drive::rate(time, &state, &parameters);
/// ```
///
/// The names within are the spec's own and the bodies are as long as the
/// equations, so lints of style are not asked about them.
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
